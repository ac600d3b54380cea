package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class MessagesTest {

    private static final String PROGRAM = """
            !start.
            +!start <- .port(radio); .getRFMessages(open); diffuser.note(ready).
            +p(X)[source(S)] <- diffuser.note(plus,X,S).
            -p(X)[source(S)] <- diffuser.note(minus,X,S).
            +!go(X)[source(S)] <- diffuser.note(going,X,S); .suspend.
            ^!go(X)[state(dropped)] <- diffuser.note(dropped,X).
            """;

    private static RunningAgent ready(FakeBoard board) {
        RunningAgent agent = RunningAgent.run(PROGRAM, board);
        RunningAgent.asked(board, "R open");
        agent.notes("ready");
        return agent;
    }

    @Test
    void checkMail_tellAndUntell_beliefOfTheSenderComesAndGoes() {
        FakeBoard board = new FakeBoard("radio");
        try (RunningAgent agent = ready(board)) {
            board.receive("////", "ROMA", "tell;p(1)");
            agent.notes("plus 1 ROMA");
            board.receive("//SU", "SUPO", "tell;p(1)");
            agent.notes("plus 1 SUPO");
            board.receive("////", "ROMA", "untell;p(1)");
            agent.notes("minus 1 ROMA");
        }
    }

    @Test
    void checkMail_achieveAndUnachieve_goalIsAdoptedAndDropped() {
        FakeBoard board = new FakeBoard("radio");
        try (RunningAgent agent = ready(board)) {
            board.receive("CAFE", "ROMA", "achieve;go(12)");
            agent.notes("going 12 ROMA");
            board.receive("CAFE", "ROMA", "unachieve;go(12)");
            agent.notes("dropped 12");
        }
    }

    @Test
    void checkMail_listOfBeliefs_eachIsBelieved() {
        FakeBoard board = new FakeBoard("radio");
        try (RunningAgent agent = ready(board)) {
            board.receive("////", "ROMA", "tell;[p(1),p(2)]");
            agent.notesAll("plus 1 ROMA", "plus 2 ROMA");
        }
    }

    @Test
    void checkMail_contentHasSemicolonAndStrings_arrivesWhole() {
        FakeBoard board = new FakeBoard("radio");
        try (RunningAgent agent = ready(board)) {
            board.receive("////", "ROMA", "tell;p(\"a;b ü\")");
            agent.notes("plus a;b ü ROMA");
        }
    }

    @Test
    void checkMail_malformedContent_droppedCountedAndTheNextArrives() throws Exception {
        FakeBoard board = new FakeBoard("radio");
        try (RunningAgent agent = ready(board)) {
            board.receive("////", "ROMA", "tell;p(");
            board.receive("////", "ROMA", "tell;3");
            board.receive("////", "ROMA", "achieve;.stopMAS");
            board.receive("////", "ROMA", "tell;[p(1),3]");
            board.receive("////", "ROMA", "sing;p(1)");
            board.receive("////", "ROMA", "tell;p(1)");
            agent.notes("plus 1 ROMA");
            agent.warns("dropped a message from ROMA that is no AgentSpeak, \"p(\"");
            agent.warns("\"3\"");
            agent.warns("\".stopMAS\"");
            agent.warns("\"[p(1),3]\"");
            agent.warns("sing;p(1)");
            assertEquals(4L, agent.diffuser().getStatus().get("rfMessagesMalformed"));
            assertEquals(1L, agent.diffuser().getStatus().get("rfMessages"));
        }
    }

    @Test
    void wake_agentSleeps_messageEndsItsSleep() {
        FakeBoard board = new FakeBoard("radio");
        try (RunningAgent agent = ready(board)) {
            agent.cycles(3);
            assertTrue(agent.body().getTS().canSleep(), "an idle agent can sleep");
            board.receive("////", "ROMA", "tell;p(1)");
            agent.notes("plus 1 ROMA");
        }
    }
}
