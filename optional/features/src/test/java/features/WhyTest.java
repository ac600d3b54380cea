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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import trace.TraceReader;
import trace.why.Why;

/** The first causes that the answers give are those that {@code why.txt} names. */
class WhyTest {

    private static final String WITH_RADIO = """
            !start.
            +!start <- .port("ports/robot"); .setMyRFId("ROMA"); .getRFMessages(open); .percepts(open).
            """;

    @TempDir
    private static Path run;
    private static Why near;

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

    /** What a question is near to, or says in other words. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "ledOn(3)|no plan of robot has the step ledOn(3); the nearest is ledOn",
            "seen(1,2)|no plan of robot has the step seen(1,2); the nearest is seen(N)",
            "+seen(1,2)|no plan of robot has the step seen(1,2); the nearest is seen(N)",
            "seen(2)|its plan ran to its end, another way",
            "moved(3)|its plan ran to its end, another way",
            ".print(_)|!start is a goal of the program",
            ".print(\"(\")|no plan of robot has the step .print(\"(\"); the nearest is .print(\"up\")",
            ".act(ledOn)|!start is a goal of the program",
            "lamp(1)|!start is a goal of the program",
            "lamp(0)|no action of robot's board has changed lamp so; ask of one, such as 'ledOn'",
            "!go(1,2)|nobody gave robot the goal !go(1,2)",
            "lamp(|WHAT takes a belief, goal, action or pin, such as 'lamp(on)', '!go' or 'lampOn', not 'lamp('"})
    void answer_ofWhatIsNearlySo_isTrue(String question, String cause) throws IOException {
        List<String> answer;
        try {
            answer = near().answer(question, "");
        } catch (IllegalArgumentException refused) {
            answer = List.of(refused.getMessage());
        }
        assertTrue(answer.get(answer.size() - 1).endsWith(cause), String.join("\n", answer));
    }

    private Why near() throws IOException {
        if (near == null) {
            try (Project project = new Project(run, "blink/Blink", """
                    !start.
                    +!start <- .port("ports/robot"); .percepts(open); .act(ledOn); .print("up"); !!go(1).
                    +!go(N) : N > 0 <- +seen(N); -+moved(N+1).
                    """)) {
                assertEquals(0, project.play("When 2 s pass"), project.said());
            }
            near = new Why(TraceReader.all(run.resolve("runs/a-3/run.jsonl")));
        }
        return near;
    }

    @Test
    void answer_leadsFromAPinToThePacket(@TempDir Path folder) throws IOException {
        try (Project project = new Project(folder, "radioblink/RadioBlink",
                WITH_RADIO + "+hello(X)[source(S)] : X > 0 <- !light(X). +!light(X) <- .act(ledOn).")) {
            assertEquals(0,
                    project.play("Given the device SUPO / And ROMA (robot's board) and the device SUPO share a key / "
                            + "When the device SUPO sends tell hello(1) to ROMA / And 2 s pass"),
                    project.said());
            Why why = new Why(TraceReader.all(folder.resolve("runs/a-3/run.jsonl")));
            List<String> answer = why.answer("lamp(on)", "");
            List<String> links = List.of("robot's lamp goes on", "because of ledOn", "asks its board for ledOn",
                    "the step .act(ledOn) of the plan (robot.asl:3)", "chose the plan (robot.asl:3) for +!light(1)",
                    "has the event +!light(1)", "the step !light(1) of the plan (robot.asl:3)",
                    "chose the plan (robot.asl:3) for +hello(1)", "believes hello(1)",
                    "the gate passed tell;hello(1) from SUPO",
                    "robot's board handed it over, number 0", "packet 1 of SUPO, sealed",
                    "attempt 1 of message 0 to ROMA",
                    "first cause: the host of SUPO's board sent it");
            assertEquals(links.size(), answer.size(), String.join("\n", answer));
            for (int i = 0; i < links.size(); i++) {
                assertTrue(answer.get(i).contains(links.get(i)), answer.get(i));
            }
            assertEquals(List
                    .of("first cause: no action of robot's board has changed lamp so; ask of one, such as 'ledOn'"),
                    why.answer("lamp(off)", "").stream().skip(1).toList());
        }
    }
}
