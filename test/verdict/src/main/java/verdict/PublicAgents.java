package verdict;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Runs agents of public repositories, each with an emulated board on every port that its program names: right is one
 * that finds its board, and of which no plan fails.
 */
public final class PublicAgents {

    private static final int SECONDS = 20;
    private static final int RUNS = 3;
    private static final Pattern PORT = Pattern.compile("\\b(tty[A-Za-z]+\\d|COM\\d)\\b");
    private static final Pattern ERROR = Pattern.compile("(?i)exception|error|could not|no fail event|FAILED| is off");

    private PublicAgents() {
    }

    /** @param arguments the agents' folder, their list, an emulator, the sketches' folder, a Java, a class path. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        try (Judge judge = new Judge("Agents of public repositories", "agents.txt", "`jason.Argo`, `Diffuser`")) {
            for (String line : Files.readAllLines(Path.of(arguments[1]))) {
                String[] words = line.split(" ");
                if (line.startsWith("#")) {
                    continue;
                }
                Path repository = Path.of(arguments[0], words[0]);
                boolean right = false;
                for (int i = 0; i < RUNS && !right; i++) {
                    List<String> log = run(repository, words, arguments);
                    right = log.stream().noneMatch(said -> ERROR.matcher(said).find());
                    if (!right) {
                        System.out.println(line + ":\n" + String.join("\n", log));
                    }
                }
                judge.judge(words[0] + "/" + words[2], right);
            }
        }
    }

    private static List<String> run(Path repository, String[] words, String[] arguments)
            throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("verdict");
        Set<String> ports = new TreeSet<>();
        try (Stream<Path> files = Files.walk(repository)) {
            for (Path file : (Iterable<Path>) files.filter(Files::isRegularFile)::iterator) {
                Path copy = folder.resolve(repository.relativize(file));
                Files.createDirectories(copy.getParent());
                Files.copy(file, copy);
                for (Matcher port = PORT.matcher(Files.readString(file)); port.find();) {
                    ports.add(port.group());
                }
            }
        }
        Path program = Path.of(words[2]);
        Files.writeString(folder.resolve("public.mas2j"),
                "MAS public { agents: %s agentArchClass %s; aslSourcePath: \"%s\"; \".\"; }\n".formatted(
                        program.getFileName().toString().replace(".asl", ""), words[3], program.getParent()));
        boolean isUno = words[4].endsWith("Uno");
        String sketch = isUno ? words[4].replace("Uno", "") : words[4];
        Path elf = Path.of(arguments[3], sketch.toLowerCase(Locale.ROOT) + (isUno ? "-uno" : ""), sketch + ".ino.elf");
        List<String> boards = ports.stream()
                .map(port -> "{\"name\": \"%s\", \"model\": \"%s\", \"firmware\": \"%s\", \"port\": \"%s\"}"
                        .formatted(port.toLowerCase(Locale.ROOT), isUno ? "uno" : "mega", elf, port))
                .toList();
        Files.writeString(folder.resolve("board.json"), "{\"boards\": [" + String.join(", ", boards) + "]}");
        Process emulator = new ProcessBuilder(arguments[2], "board.json").directory(folder.toFile())
                .redirectErrorStream(true).redirectOutput(folder.resolve("emulator.log").toFile()).start();
        try {
            Files.writeString(folder.resolve("log.properties"),
                    "handlers = java.util.logging.ConsoleHandler\n.level = INFO\n"
                            + "java.util.logging.ConsoleHandler.formatter = jason.runtime.MASConsoleLogFormatter\n");
            return Log.untilQuiet(folder, SECONDS, SECONDS, List.of(arguments[4], "-cp", arguments[5],
                    "jason.infra.local.RunLocalMAS", "public.mas2j", "--log-conf", "log.properties", "--no-net"));
        } finally {
            emulator.destroyForcibly().waitFor();
        }
    }
}
