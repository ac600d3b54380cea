package verdict;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Runs cognitiveAgentBench as its author does, by Argo and by our {@code jason.Argo} in turns: how many percepts their
 * agent takes in a minute from an emulated Uno with their sketch. Nothing else should run beside it.
 */
public final class PerceptsPerMinute {

    private static final Pattern FIGURE = Pattern.compile("PPM = (\\d+)");
    /** The agents connect, and then count for a minute. */
    private static final int SECONDS = 180;
    /** Argo looks for ports in /dev only; no key of their LCD shield is pressed. */
    private static final String BOARD = """
            {"boards": [{"name": "uno", "model": "uno", "port": "/dev/ttyUSB0",
              "firmware": "%s/environment/simulatedArduino/simulatedArduino.ino.hex",
              "sensors": [{"type": "ldr", "pin": "A0", "light": [[0, 1023]]}]}]}
            """;

    private PerceptsPerMinute() {
    }

    /** @param arguments the benchmark's folder, an emulator, a Java, Argo's class path, ours, how many turns. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        List<Integer> theirs = new ArrayList<>();
        List<Integer> ours = new ArrayList<>();
        for (int turn = 0; turn < Integer.parseInt(arguments[5]); turn++) {
            theirs.add(run(arguments, arguments[3]));
            ours.add(run(arguments, arguments[4]));
            System.out.println("percepts a minute: Argo " + theirs + ", our jason.Argo " + ours);
        }
    }

    private static int run(String[] arguments, String classes) throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("verdict");
        Path board = Files.writeString(folder.resolve("board.json"), BOARD.formatted(arguments[0]));
        Process emulator = new ProcessBuilder(arguments[1], board.toString()).inheritIO().start();
        try {
            List<String> log = Log.until(Path.of(arguments[0], "jasonEmbedded"), SECONDS,
                    line -> FIGURE.matcher(line).find(), List.of(arguments[2], "-cp", classes,
                            "jason.infra.local.RunLocalMAS", "cognitiveAgentBenchWithJasonARGO.mas2j", "--no-net"));
            Matcher figure = FIGURE.matcher(String.join("\n", log));
            if (!figure.find()) {
                throw new IOException("no figure:\n" + String.join("\n", log));
            }
            return Integer.parseInt(figure.group(1));
        } finally {
            // At its end it takes the port away.
            emulator.destroy();
            emulator.waitFor();
        }
    }
}
