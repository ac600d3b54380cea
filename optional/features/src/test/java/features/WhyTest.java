package features;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import trace.TraceReader;
import trace.why.Why;

/** The first causes that the answers give are those that {@code why.txt} names. */
class WhyTest {

    private static final String WITH_RADIO = """
            !start.
            +!start <- .port("ports/robot"); .setMyRFId("ROMA"); .getRFMessages(open); .percepts(open).
            """;

    /** The cases, as fields by their names. */
    static List<Map<String, String>> cases() throws IOException {
        List<Map<String, String>> cases = new ArrayList<>();
        try (InputStream file = WhyTest.class.getResourceAsStream("why.txt")) {
            String text = new String(file.readAllBytes(), StandardCharsets.UTF_8);
            for (String line : text.replaceAll("(?m)^#.*\n", "").replaceAll("/\n +", "/ ").lines().toList()) {
                if (line.startsWith("case: ")) {
                    cases.add(new TreeMap<>());
                }
                if (line.startsWith("  ")) {
                    cases.get(cases.size() - 1).merge("agent", "\n" + line.strip(), String::concat);
                } else if (!line.isEmpty()) {
                    cases.get(cases.size() - 1).put(line.replaceFirst(": .*", ""), line.replaceFirst("^\\w+: ", ""));
                }
            }
        }
        return cases;
    }

    @ParameterizedTest
    @MethodSource("cases")
    void answer_givesTheFirstCause(Map<String, String> told, @TempDir Path folder) throws IOException {
        String sketch = told.getOrDefault("sketch", "blink/Blink");
        try (Project project = new Project(folder, sketch, told.getOrDefault("agent", WITH_RADIO))) {
            project.change(told.getOrDefault("board", ""), told.getOrDefault("boards", ""));
            assertEquals(0, project.play(told.get("steps")), project.said());
            Path run;
            try (Stream<Path> runs = Files.walk(folder.resolve("runs"))) {
                run = runs.filter(file -> file.endsWith("run.jsonl")).findFirst().orElseThrow();
            }
            List<String> answer = new Why(TraceReader.all(run)).answer(told.get("why"), "");
            String all = String.join("\n", answer);
            assertTrue(answer.get(answer.size() - 1).contains(told.get("cause")), all);
            assertTrue(all.contains(told.getOrDefault("says", "")), all);
        }
    }
}
