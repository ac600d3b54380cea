package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import javino.fake.FakeBoard;

/** An agent's answers to other devices. */
class AnswersTest {

    private static final String PROGRAM = """
            speed(80). near(bus1,3). near(bus2,7)[seen].
            !start.
            +!start <- .port(antenna); .setMyRFId("SUPO"); .getRFMessages(open); diffuser.note(ready).
            +?far(X) <- X = 9.
            +?long(X) <- .concat("%s","",X).
            @go +!go(X) : near(X,_) <- .print("on my \\"way\\"\\n"); run(X).
            +!probe <- diffuser.note(probed).
            """.formatted("x".repeat(600));

    private final FakeBoard board = new FakeBoard("antenna");

    private RunningAgent ready() {
        RunningAgent agent = RunningAgent.run(PROGRAM, board);
        agent.notes("ready");
        RunningAgent.asked(board, "id SUPO");
        RunningAgent.asked(board, "radio 1");
        return agent;
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\0', value = {
            "askOne#AbC;speed(X)    | tell#AbC;speed(80)",
            "askOne#/+9;near(bus2,X) | tell#/+9;near(bus2,7)[seen]",
            "askOne#AAA;near(bus2,X)[cast(unicast,a)] | tell#AAA;near(bus2,7)[seen]",
            "askOne#AbC;far(X)      | tell#AbC;far(9)",
            "askOne#AbC;unknown     | untell#AbC;unknown",
            "askAll#AbC;near(W,_)   | tell#AbC;[near(bus1,3),near(bus2,7)[seen]]",
            "askAll#AbC;unknown     | tell#AbC;[]",
            "askHow#AbC;{ +!stop }  | tellHow#AbC;[]",
            "askHow#AbC;\"+!stop\"  | tellHow#AbC;[]",
    })
    void ask_unicast_isAnsweredInItsConversation(String question, String answer) {
        RunningAgent agent = ready();
        board.receive("SUPO", "ROMA", question);
        RunningAgent.asked(board, "ROMA " + answer);
        agent.notesNothingElse();
    }

    @Test
    void askHow_planWithStrings_isTheWholePlan() {
        RunningAgent agent = ready();
        board.receive("SUPO", "ROMA", "askHow#AbC;{ +!go(_) }");
        String answer = RunningAgent.next(board.requests, "an answer");
        assertTrue(answer.matches("ROMA tellHow#AbC;\\[\\{ @go \\+!go\\((\\w+)\\) : near\\(\\1,\\w+\\) <- "
                + "\\.print\\(\"on my \\\\\"way\\\\\"\\\\n\"\\); run\\(\\1\\) }]"), answer);
        agent.notesNothingElse();
    }

    @Test
    void askHow_planWithoutALabelOfItsOwn_travelsWithoutOne() {
        RunningAgent agent = ready();
        board.receive("SUPO", "ROMA", "askHow#AbC;{ +!probe }");
        RunningAgent.asked(board, "ROMA tellHow#AbC;[{ +!probe <- diffuser.note(probed) }]");
    }

    @Test
    void ask_group_isAnsweredToTheAskerAloneWhereSomethingIsKnown() {
        RunningAgent agent = ready();
        board.receive("//SU", "ROMA", "askOne#AAA;unknown");
        board.receive("//SU", "ROMA", "askAll#AAB;unknown");
        board.receive("//SU", "ROMA", "askHow#AAC;{ +!stop }");
        board.receive("//SU", "ROMA", "askOne#AAD;speed(X)");
        RunningAgent.asked(board, "ROMA tell#AAD;speed(80)");
        agent.notesNothingElse();
    }

    @ParameterizedTest
    @ValueSource(strings = {"askOne#AAA;speed(X)", "askAll#AAA;speed(X)", "askHow#AAA;{ +!go(_) }"})
    void ask_broadcast_isRefusedAndCounted(String question) throws Exception {
        RunningAgent agent = ready();
        board.receive("////", "ROMA", question);
        agent.warns(
                "dropped " + question.split("#")[0] + " from ROMA: it came as a broadcast, which anyone can send"
                        + " in anyone's name");
        board.receive("SUPO", "ROMA", "askOne#AAD;speed(X)");
        RunningAgent.asked(board, "ROMA tell#AAD;speed(80)");
        assertEquals(1L, agent.diffuser().inbox().refused());
    }

    @Test
    void ask_answerIsTooLong_askerIsToldBothLengths() {
        RunningAgent agent = ready();
        board.receive("SUPO", "ROMA", "askOne#AbC;long(X)");
        RunningAgent.asked(board, "ROMA sorry#AbC;\"a content has at most 494 bytes of UTF-8, not 617\"");
        agent.notesNothingElse();
    }
}
