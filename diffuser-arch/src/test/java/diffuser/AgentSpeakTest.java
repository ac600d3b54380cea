package diffuser;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import javino.fake.FakeBoard;
import javino.protocol.Outcome;
import javino.protocol.Status;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** Runs the tests that are written in AgentSpeak. */
class AgentSpeakTest {

    private static final Pattern TEST = Pattern.compile("(?m)^\\+!(test_\\w+)");

    @TestFactory
    Stream<DynamicTest> board() throws IOException {
        String program = resource("/asl/board.asl");
        return TEST.matcher(program).results().map(MatchResult::group)
                .map(trigger -> trigger.substring(2))
                .map(goal -> DynamicTest.dynamicTest(goal, () -> run(goal, program)));
    }

    private static void run(String goal, String program) {
        FakeBoard board = new FakeBoard("desk").perceive("p(1)", "p(-2)")
                .refuse("act fly", Status.UNKNOWN_ACTION)
                .refuse("act jump", Status.ACTION_FAILED)
                .refuse("NOKE tell;secret", Status.NO_KEY)
                .endAll(Outcome.DELIVERED);
        board.receive("////", "ROMA", "tell;q(7)");
        String start = """

                !start.
                +!start <- .port(desk); .setMyRFId("SUPO"); !%s; diffuser.note(passed).
                -!start[error(E),error_msg(M)] <- diffuser.note(E,":",M).
                """.formatted(goal);
        RunningAgent agent = RunningAgent.run(program + start, board);
        agent.notes("passed");
    }

    private static String resource(String name) throws IOException {
        try (InputStream in = AgentSpeakTest.class.getResourceAsStream(name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
