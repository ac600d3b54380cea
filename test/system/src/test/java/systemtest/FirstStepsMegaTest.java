package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.AgentProcess;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The page docs/first-steps-mega.md, done as it says to do it without boards. */
@Tag("verify")
class FirstStepsMegaTest {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));
    private static final Path HIGHWAY = ROOT.resolve("examples/highway");
    private static final String JAVA = Path.of(System.getProperty("java.home"), "bin/java").toString();
    private static final Pattern BLOCK = Pattern.compile("```\\n(.*?)```", Pattern.DOTALL);

    @TempDir
    private Path folder;

    private final String page = read(ROOT.resolve("docs/first-steps-mega.md"));

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    /** For these boards, whose ports have other names and whose keys and counts are others. */
    private static String ported(String text) {
        return text.replace("/dev/ttyACM0", "ports/roma").replace("/dev/ttyACM1", "ports/supo");
    }

    private static String normalised(String text) {
        return ported(text).replaceAll("check value [0-9a-f]{6}", "check value …")
                .replaceAll("(boot epoch +|\\w+ {2,})\\d+", "$1…");
    }

    /** The block of the page that follows these words. */
    private String blockAfter(String words) {
        int start = page.indexOf(words);
        assertTrue(start >= 0, words);
        return BLOCK.matcher(page.substring(start)).results().findFirst().map(block -> block.group(1)).orElseThrow();
    }

    private Process java(String... words) throws IOException {
        List<String> command = new ArrayList<>(List.of(JAVA, "-cp", System.getProperty("java.class.path")));
        command.addAll(List.of(words));
        return new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start();
    }

    /** What the command prints. */
    private List<String> javino(String command) throws Exception {
        Process process = java(("javino.cli.Main" + command.substring("javino".length())).split(" "));
        List<String> printed = process.inputReader().lines().toList();
        assertEquals(0, process.waitFor(), () -> command + "\n" + String.join("\n", printed));
        return printed;
    }

    private AgentProcess agent(String name) throws IOException {
        return AgentProcess.start(
                new ProcessBuilder(JAVA, "-Djava.awt.headless=true", "-cp", System.getProperty("java.class.path"),
                        "highway.Agent", "--agent=" + name).directory(folder.toFile()));
    }

    private String lineAfter(String words) {
        return ported(blockAfter(words).strip());
    }

    @Test
    void page_doneWithEmulatedMegas_doesWhatItSays() throws Exception {
        Files.copy(HIGHWAY.resolve("logging.properties"), folder.resolve("logging.properties"));
        Files.createDirectory(folder.resolve("agents"));
        Files.writeString(folder.resolve("agents/lamp.asl"), ported(blockAfter("`lamp.asl`:")));
        Files.writeString(folder.resolve("agents/caller.asl"), ported(blockAfter("`caller.asl`:")));
        Files.writeString(folder.resolve("lamp.mas2j"), blockAfter("`lamp.mas2j` is"));
        Files.writeString(folder.resolve("caller.mas2j"), blockAfter("`lamp.mas2j` is").replace("lamp", "caller"));
        List<String> commands = BLOCK.matcher(ported(page.substring(page.indexOf("## 4.")))).results()
                .map((MatchResult block) -> block.group(1)).flatMap(String::lines)
                .filter(line -> line.startsWith("javino ")).toList();
        assertEquals(4, commands.stream().filter(line -> line.matches("javino (keygen|provision|info) .*")).count(),
                commands::toString);

        try (AgentProcess emulator =
                AgentProcess.start(new ProcessBuilder(ROOT.resolve("emulator/build/javino-emulator").toString(),
                        HIGHWAY.resolve("two-megas.json").toString(), "--directory", folder.toString(), "--trace",
                        "-"))) {
            while (!Files.exists(folder.resolve("ports/supo"))) {
                Thread.sleep(20);
            }
            for (String command : commands.stream().filter(line -> !line.startsWith("javino: ")).toList()) {
                for (String line : javino(command).stream().limit(7).toList()) {  // of info, the page has the first few
                    assertTrue(normalised(page).contains(normalised(line)), () -> command + " prints " + line);
                }
            }
            try (AgentProcess lamp = agent("lamp")) {
                lamp.await("[lamp] ready");
                try (AgentProcess caller = agent("caller")) {
                    caller.await("[caller] ROMA has it");
                }
                lamp.await("[lamp] light, please, says SUPO");
                lamp.await("[lamp] the lamp is on");
            }
            emulator.await("\"name\":\"lamp\",\"level\":1}");
            try (AgentProcess caller = agent("caller")) {
                caller.await(lineAfter("Now end ROMA's agent"));
            }
            assertEquals(List.of("key for ROMA forgotten"), javino("javino forget --port ports/supo --key ROMA"));
            try (AgentProcess caller = agent("caller")) {
                caller.await(lineAfter("Now delete the key"));
            }
        }
    }
}
