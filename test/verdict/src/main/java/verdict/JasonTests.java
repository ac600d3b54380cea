package verdict;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Runs the tests that Jason has of itself, with its own architecture and with ours: each assertion that passes there is
 * to pass here. Some of them measure milliseconds, so that one of three runs is to pass.
 */
public final class JasonTests {

    private static final String MAS = "src/test/jason/unit_tests.mas2j";
    private static final int SECONDS = 180;
    private static final int RUNS = 3;
    private static final String ALL_PASSED = "End of Jason unit tests: PASSED";
    /** Such as {@code [send] assert_equals on event 'test_send' PASSED}. */
    private static final Pattern PASSED = Pattern.compile("^\\[(\\w+)\\] (\\w+ on event '.*) PASSED$");

    private JasonTests() {
    }

    /** @param arguments a Jason's name, version and sources, a Java, and a class path with this Jason and ours. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        Path sources = Path.of(arguments[2]);
        try (Judge judge = new Judge("Jason's own tests, " + arguments[0], arguments[1], "`Diffuser`")) {
            if (!Files.exists(sources.resolve(MAS))) {
                throw new IOException("there is no " + sources.resolve(MAS) + "; SOURCES.txt says what to put there");
            }
            Map<String, Integer> own = passed(sources, arguments[3], arguments[4], "jason.infra.local.RunLocalMAS");
            Map<String, Integer> ours = passed(sources, arguments[3], arguments[4],
                    "verdict.RunWithArchitecture", "diffuser.Diffuser");
            own.forEach((assertion, times) -> {
                for (int i = 0; i < times; i++) {
                    judge.judge(assertion, i < ours.getOrDefault(assertion, 0));
                }
            });
        }
    }

    /** How often each assertion has passed in the run in which it did most. */
    private static Map<String, Integer> passed(Path sources, String java, String classes, String... program)
            throws IOException, InterruptedException {
        Map<String, Integer> passed = new TreeMap<>();
        for (int i = 0; i < RUNS; i++) {
            List<String> log = run(sources, java, classes, program);
            Map<String, Integer> now = new TreeMap<>();
            log.stream().map(PASSED::matcher).filter(Matcher::matches)
                    .forEach(line -> now.merge(line.group(1) + ": " + line.group(2), 1, Integer::sum));
            now.forEach((assertion, times) -> passed.merge(assertion, times, Math::max));
            if (log.stream().anyMatch(line -> line.contains(ALL_PASSED))) {
                break;
            }
        }
        return passed;
    }

    private static List<String> run(Path sources, String java, String classes, String... program)
            throws IOException, InterruptedException {
        List<String> words = new ArrayList<>(List.of(java, "-cp", classes));
        words.addAll(List.of(program));
        words.addAll(List.of(MAS, "--log-conf", "src/test/jason/logging.properties", "--no-net"));
        return Log.of(sources, SECONDS, words);
    }
}
