package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Mosquitto;
import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The commands of all pages, as printed: page by page in one folder, as a reader does them who has no hardware, and
 * whose path only the page itself changes.
 *
 * <p>A block {@code sh} is run to its end, {@code sh ends} until it has printed the block {@code text} that follows,
 * {@code sh runs} until the page ends or {@code <!-- ends WORD -->} names it. All others are exceptions, for a reason.
 * A block after the name of a file is that file. {@code gradle TASK} runs a task's program in the reader's folder; what
 * the task would build first is built.
 */
@Tag("verify")
class PagesTest {

    /** Why a block is not run, and what in it says so. */
    private static final Map<String, Pattern> EXCEPTIONS = Map.of(
            "board", Pattern.compile("\\bavrdude |gradle home|javino doctor|mosquitto_sub -t"),
            "long", Pattern.compile(
                    "gradle .*\\b(test|highway|run|soak|campaign|corpus|keep|model|crossCheck)\\b|--after 60"),
            "network", Pattern.compile("\\bscp |broker\\.example"),
            "root", Pattern.compile("\\bsudo "),
            "screen", Pattern.compile("\\bwireshark "));
    private static final Pattern COMMANDS =
            Pattern.compile("^(bash|console|shell)$|\\A\n(\\./|(cd|gradle|javino|sudo) )", Pattern.MULTILINE);
    private static final Pattern BLOCK = Pattern.compile("(?:`([\\w/]+\\.(?:asl|json|mas2j|sh))`(?: is|:)\n\n)?"
            + "^```(.*)\n((?s:.*?))^```$|^<!-- ends (\\S+) -->$", Pattern.MULTILINE);
    /** The port that a page says to write in place of a board's. */
    private static final Pattern EMULATED = Pattern.compile("`(\\S+)` for `(/dev/\\w+)`");
    private static final Pattern TASK = Pattern.compile("(?<![\\w-])gradle ((?::?\\w[:\\w-]* *)*)");
    /** Tasks of Gradle itself, of a project of the reader's, of JaCaMo, and of a sketch that the reader writes. */
    private static final Set<String> OTHER_TASKS =
            Set.of("tasks", "run", "sketch", "bundle", "buildJCMDeps", ":javino-firmware:firmwareFollower");
    /** The files that an emulator makes before it can be used: its scenario's ports, and its control socket. */
    private static final Pattern SCENARIO = Pattern.compile("javino-emulator (\\S+)");
    private static final Pattern MADE = Pattern.compile("(?:\"port\": *\"|--control )([\\w/]+)");
    private static final String BROKER = "mqtt://localhost";
    /** Has the next terminal begin where this one ends: only of one that is waited for. */
    private static final String KEEP = "trap 'export -p > %1$s/state; pwd > %1$s/place' DEBUG\n";
    private static final String MEGAS = "docs/first-steps-mega.md";
    private static final List<String> FIRST = List.of("README.md", "docs/first-steps.md", MEGAS);
    private static final Path ROOT = Path.of(System.getProperty("javino.root"));
    private static final long PATIENCE_SECONDS = 240;

    /** Commands that were not at their end when the page went on. */
    private record Terminal(int number, String commands, Process process) {
    }

    @TempDir
    private Path folder;

    private final List<Terminal> running = new ArrayList<>();
    private final List<String> printed = new ArrayList<>();
    private final List<String> exceptions = new ArrayList<>();
    private Path clone;
    private String terminals;
    private int count;
    private long commandsRun;
    private int brokersPort;

    @BeforeEach
    void prepare() throws Exception {
        terminals = "JAVINO_TERMINAL=" + folder + "/";
        Runtime.getRuntime().addShutdownHook(new Thread(() -> end(terminals)));
        clone = Files.createDirectory(folder.resolve("javino"));
        try (Stream<Path> all = Files.list(ROOT)) {
            for (Path each : all.filter(file -> !file.endsWith("examples")).toList()) {
                Files.createSymbolicLink(clone.resolve(each.getFileName()), each);
            }
        }
        for (String file : output("git", "-C", ROOT.toString(), "ls-files", "examples")) {
            Path copy = clone.resolve(file);
            Files.createDirectories(copy.getParent());
            Files.copy(ROOT.resolve(file), copy);
        }
        command("javino", "echo 'another javino' >&2; exit 1");
        command("xdg-open", "");
        command("gradle", """
                for word; do
                    case $word in
                        -P*=*) options+=("--${word#-P}") ;;
                        -P*) options+=("--${word#-P}=") ;;
                        *) grep -q ":${word#:}\\$" '%2$s/built' || { echo "$word is not built" >&2; exit 1; }
                            [ -e "%2$s/${word##*:}" ] && program=%2$s/${word##*:}
                    esac
                done
                cd %1$s
                [ -z "$program" ] || exec bash "$program" "${options[@]}"
                """.formatted(clone, System.getProperty("javino.programs")));
        brokersPort = Mosquitto.freePort();
        Files.writeString(folder.resolve("state"), "");
    }

    /** A command that goes before those of this computer. */
    private void command(String name, String text) throws IOException {
        Path file = Files.createDirectories(folder.resolve("bin")).resolve(name);
        Files.writeString(file, "#!/bin/bash\n" + text + "\n");
        assertTrue(file.toFile().setExecutable(true));
    }

    private static List<String> output(String... command) throws IOException {
        return new ProcessBuilder(command).start().inputReader().lines().toList();
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @AfterEach
    void endAll() throws IOException {
        end(terminals);
        try (Stream<Path> all = Files.list(clone)) {
            for (Path link : all.filter(Files::isSymbolicLink).toList()) {
                Files.delete(link);
            }
        }
    }

    /** All pages: the first ones in the order in which they name each other, then the others. */
    private static List<String> pages() throws IOException {
        List<String> all = output("git", "-C", ROOT.toString(), "ls-files", "*.md").stream()
                .filter(page -> !page.contains("/src/")).toList();
        return Stream.concat(FIRST.stream(), all.stream()).distinct().toList();
    }

    @Test
    void commands_asPrinted_doWhatThePagesSay() throws Exception {
        Set<String> built = new HashSet<>(Files.readAllLines(Path.of(System.getProperty("javino.programs"), "tasks")));
        built.addAll(OTHER_TASKS);
        List<String> failures = new ArrayList<>();
        for (String page : pages()) {
            try {
                assertEquals(List.of(), unknownTasks(page, built), page);
                follow(page);
            } catch (AssertionError failed) {
                failures.add(failed.getMessage());
            }
            end(terminals);
            running.clear();
            clear();
        }
        System.out.println(String.join("\n", exceptions));
        System.out.printf("pages: %d blocks of commands were run, %d were not%n", commandsRun, exceptions.size());
        assertEquals("", String.join("\n\n", failures));
    }

    /** Gradle's tasks that a page names and nobody has. */
    private static List<String> unknownTasks(String page, Set<String> tasks) {
        return TASK.matcher(read(ROOT.resolve(page))).results()
                .flatMap(command -> Stream.of(command.group(1).strip().split(" +")))
                .filter(task -> !tasks.contains(task)).toList();
    }

    private void follow(String page) throws Exception {
        String text = read(ROOT.resolve(page));
        List<MatchResult> blocks = new ArrayList<>(BLOCK.matcher(text).results().toList());
        boolean boards = blocks.stream().anyMatch(block -> isRun(block) && block.group(3).contains("/dev/ttyACM"));
        commandsRun += blocks.stream().filter(PagesTest::isRun).count();
        Map<String, String> ports = ports(text);
        Files.writeString(folder.resolve("place"), clone.toString());
        if (boards && ports.isEmpty()) {
            String megas = read(ROOT.resolve(MEGAS));
            ports = ports(megas);
            follow(BLOCK.matcher(megas).results().filter(PagesTest::isRun).findFirst().orElseThrow(), "", MEGAS, ports);
        }
        Files.writeString(folder.resolve("state"), "");
        if (text.contains(BROKER)) {
            start("/usr/sbin/mosquitto -p " + brokersPort);
        }
        String last = "";
        for (MatchResult block : blocks) {
            String where = page + ":" + (text.substring(0, block.start()).lines().count() + 2) + ": ";
            try {
                last = follow(block, last, where, ports);
            } catch (AssertionError failed) {
                throw new AssertionError(where + failed.getMessage() + "\n" + String.join("\n", lines()), failed);
            }
        }
        for (Terminal each : running) {
            assertTrue(each.process.isAlive(), () -> page + ": ended by itself: " + each.commands);
        }
    }

    private static Map<String, String> ports(String page) {
        Map<String, String> ports = new LinkedHashMap<>();
        EMULATED.matcher(page).results().forEach(words -> ports.put(words.group(2), words.group(1)));
        return ports;
    }

    private static boolean isRun(MatchResult block) {
        return block.group(2) != null && List.of("sh", "sh runs", "sh ends").contains(block.group(2));
    }

    /**
     * Does the steps of a block.
     *
     * @param last the mark of the commands before it
     * @return the same mark, or the one of this block
     */
    private String follow(MatchResult block, String last, String where, Map<String, String> ports) throws Exception {
        if (block.group(4) != null) {
            assertTrue(running.removeIf(each -> each.commands.contains(block.group(4)) && end(each)));
            return last;
        }
        String info = block.group(2);
        String text = block.group(3);
        for (Map.Entry<String, String> port : ports.entrySet()) {
            text = text.replace(port.getKey(), port.getValue());
        }
        text = text.replace(BROKER, BROKER + ":" + brokersPort);
        if (info.equals("text") && !last.startsWith("not ")) {
            for (String line : text.lines().filter(each -> !each.equals("…")).toList()) {
                Pattern expected = expected(line);
                await(line, () -> lines().stream().anyMatch(each -> expected.matcher(each).find()));
            }
            if (last.equals("sh ends")) {
                running.removeIf(each -> each.number == count && end(each));
            }
        } else if (isRun(block)) {
            run(text, info);
            return info;
        } else if (info.startsWith("sh")) {
            String reason = info.substring("sh".length()).strip();
            assertTrue(EXCEPTIONS.containsKey(reason), "the mark '" + info + "' is unknown");
            assertTrue(EXCEPTIONS.get(reason).matcher(text).find(), "the mark '" + info + "' is not needed");
            exceptions.add("not run, " + reason + ": " + where + block.group(3).lines().findFirst().orElseThrow());
            return "not " + reason;
        } else if (block.group(1) == null) {
            assertFalse(COMMANDS.matcher(info + "\n" + text).find(), "not marked as PagesTest says");
        } else {
            Path file = place().resolve(block.group(1));
            Files.createDirectories(file.getParent());
            Files.writeString(file, text);
        }
        return last;
    }

    /** The pattern of a page's line: a run has other numbers and keys. */
    private static Pattern expected(String line) {
        Matcher variable = Pattern.compile("(?<=check value )\\w+|\\d+|…|\\s+").matcher(line.strip());
        StringBuilder pattern = new StringBuilder();
        int end = 0;
        while (variable.find()) {
            pattern.append(Pattern.quote(line.strip().substring(end, variable.start())));
            pattern.append(variable.group().isBlank() ? "\\s+" : variable.group().equals("…") ? ".*" : "[0-9a-f]+");
            end = variable.end();
        }
        return Pattern.compile(pattern + Pattern.quote(line.strip().substring(end)));
    }

    private Path place() {
        return Path.of(read(folder.resolve("place")).strip());
    }

    /** Commands in a terminal, of which only the last one may go on. */
    private void run(String commands, String mark) throws Exception {
        count++;
        int last = mark.equals("sh") ? commands.length() : commands.stripTrailing().lastIndexOf('\n') + 1;
        if (last > 0) {
            Process process = start(KEEP.formatted(folder) + commands.substring(0, last));
            assertTrue(process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS), () -> "does not end: " + commands);
            assertEquals(0, process.exitValue(), commands);
            awaitMade(commands.substring(0, last).lines().filter(line -> line.endsWith("&")).toList());
        }
        if (last < commands.length()) {
            running.add(new Terminal(count, commands, start(commands.substring(last))));
            awaitMade(List.of(commands.substring(last)));
        }
    }

    /** Runs commands where the last ones left off, and with what these exported. */
    private Process start(String commands) throws IOException {
        String terminal = folder + "/" + count + "/";
        ProcessBuilder bash = new ProcessBuilder("bash", "-c", read(folder.resolve("state"))
                + "export JAVINO_TERMINAL=" + terminal + "\ncd " + place() + "\nset -e -o pipefail\n" + commands
                + "\n:");
        bash.environment().putAll(Map.of("HOME", folder.resolve("home").toString(), "PATH",
                folder.resolve("bin") + ":" + System.getenv("PATH"), "JAVINO_TERMINAL", terminal, "JAVA_TOOL_OPTIONS",
                "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC -Duser.home=" + folder.resolve("home"), "TERM", "dumb"));
        Process process = bash.redirectErrorStream(true).redirectInput(new File("/dev/null")).start();
        Thread reader = new Thread(() -> process.inputReader().lines().forEach(this::print), "output");
        reader.setDaemon(true);
        reader.start();
        return process;
    }

    private void awaitMade(List<String> commands) {
        Path place = place();
        for (String command : commands) {
            String scenarios = SCENARIO.matcher(command).results().map(file -> read(place.resolve(file.group(1))))
                    .collect(Collectors.joining());
            MADE.matcher(command + scenarios).results().map(made -> place.resolve(made.group(1)))
                    .forEach(made -> await(made.toString(), () -> Files.exists(made, LinkOption.NOFOLLOW_LINKS)));
        }
    }

    private synchronized void print(String line) {
        printed.add(line);
    }

    private synchronized List<String> lines() {
        return List.copyOf(printed);
    }

    private synchronized void clear() {
        printed.clear();
    }

    private void await(String what, BooleanSupplier isThere) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (!isThere.getAsBoolean()) {
            assertTrue(System.nanoTime() < end && running.stream().allMatch(each -> each.process.isAlive()),
                    () -> "not there: " + what);
            pause();
        }
    }

    private static void pause() {
        try {
            Thread.sleep(20);
        } catch (InterruptedException interrupted) {
            throw new IllegalStateException(interrupted);
        }
    }

    private boolean end(Terminal terminal) {
        end(terminals + terminal.number + "/");
        return true;
    }

    /** Ends all that was started in these terminals, also what has left them. */
    private static void end(String terminals) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        List<ProcessHandle> left = ProcessHandle.allProcesses().filter(each -> isIn(each, terminals)).toList();
        while (!left.isEmpty()) {
            left.forEach(System.nanoTime() < end ? ProcessHandle::destroy : ProcessHandle::destroyForcibly);
            while (left.stream().anyMatch(PagesTest::runs) && System.nanoTime() < end) {
                pause();
            }
            left = ProcessHandle.allProcesses().filter(each -> isIn(each, terminals)).toList();
        }
    }

    private static boolean isIn(ProcessHandle process, String terminals) {
        return proc(process, "environ").contains(terminals);
    }

    /** Whether it has not closed its files yet. */
    private static boolean runs(ProcessHandle process) {
        return proc(process, "stat").matches(".*\\) [^ZX] .*\n");
    }

    /** Nothing where the process has ended, or is another user's. */
    private static String proc(ProcessHandle process, String file) {
        try {
            return Files.readString(Path.of("/proc/" + process.pid(), file), StandardCharsets.ISO_8859_1);
        } catch (IOException e) {
            return "";
        }
    }
}
