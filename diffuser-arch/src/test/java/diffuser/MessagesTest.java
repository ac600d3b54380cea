package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import javino.fake.FakeBoard;

class MessagesTest {

    private static final String PROGRAM = """
            !start.
            +!start <- .port(radio); .getRFMessages(open); diffuser.note(ready).
            +p(X)[source(S)] <- diffuser.note(plus,X,S).
            -p(X)[source(S)] <- diffuser.note(minus,X,S).
            +!go(X)[source(S)] <- diffuser.note(going,X,S); .suspend.
            ^!go(X)[state(dropped)] <- diffuser.note(dropped,X).
            """;

    private final FakeBoard board = new FakeBoard("radio");

    private RunningAgent ready() {
        return RunningAgent.listening(PROGRAM, board);
    }

    @Test
    void checkMail_tellAndUntell_beliefOfTheSenderComesAndGoes() {
        RunningAgent agent = ready();
        board.receive("////", "ROMA", "tell;p(1)");
        agent.notes("plus 1 ROMA");
        board.receive("//SU", "SUPO", "tell;p(1)");
        agent.notes("plus 1 SUPO");
        board.receive("////", "ROMA", "untell;p(1)");
        agent.notes("minus 1 ROMA");
    }

    @Test
    void checkMail_achieveAndUnachieve_goalIsAdoptedAndDropped() {
        RunningAgent agent = ready();
        board.receive("CAFE", "ROMA", "achieve;go(12)");
        agent.notes("going 12 ROMA");
        board.receive("CAFE", "ROMA", "unachieve;go(12)");
        agent.notes("dropped 12");
    }

    @Test
    void checkMail_listOfBeliefs_eachIsBelieved() {
        RunningAgent agent = ready();
        board.receive("////", "ROMA", "tell;[p(1),p(2)]");
        agent.notesAll("plus 1 ROMA", "plus 2 ROMA");
    }

    @ParameterizedTest
    @CsvSource({"////,broadcast", "//SU,multicast", "CAFE,unicast"})
    void checkMail_eachCast_isAnnotatedWithItsSender(String to, String cast) {
        String program = PROGRAM + """
                +q(X)[cast(C,S)] <- diffuser.note(C,S).
                +!run(X)[cast(broadcast,S)] <- diffuser.note(broadcast,S,X).
                +!run(X)[cast(C,S)] <- diffuser.note(C,S,X).
                """;
        RunningAgent agent = RunningAgent.listening(program, board);
        board.receive(to, "ROMA", "tell;q(1)");
        agent.notes(cast + " ROMA");
        board.receive(to, "ROMA", "achieve;run(2)");
        agent.notes(cast + " ROMA 2");
        board.receive(to, "ROMA", "tell;[q(3),q(4)]");
        agent.notesAll(cast + " ROMA", cast + " ROMA");
    }

    /** Among forgeries of all kinds, of one belief that several devices share. */
    private void sealedAmongForged() {
        board.receive("////", "SUPO", "tell;help");
        board.receive("////", "SUPO", "tell;help[cast(unicast,\"SUPO\")]");
        board.receive("////", "SUPO", "tell;help[cast(unicast,'SUPO'),source('SUPO')]");
        board.receive("////", "SUPO", "tell;[help[cast(unicast,'SUPO')]]");
        board.receive("CAFE", "ROMA", "tell;help");
        board.receive("////", "SUAM", "tell;[help,help[cast(unicast,'SUPO')]]");
        board.receive("CAFE", "SUHO", "tell;help[cast(unicast,'SUPO')]");
    }

    @Test
    void checkMail_triggerDemandsUnicast_onlySealedOnesCount() {
        String program = PROGRAM + "+help[cast(unicast,S)] <- diffuser.note(S).";
        RunningAgent agent = RunningAgent.listening(program, board);
        sealedAmongForged();
        agent.notes("ROMA");
        agent.notes("SUHO");
        board.receive("CAFE", "SUPO", "tell;help");
        agent.notes("SUPO");
    }

    @Test
    void checkMail_triggerDemandsUnicastOfAnybody_onlySealedOnesCount() {
        String program = PROGRAM + "+help[source(S),cast(unicast,_)] <- diffuser.note(S).";
        RunningAgent agent = RunningAgent.listening(program, board);
        sealedAmongForged();
        agent.notes("ROMA");
        agent.notes("SUHO");
    }

    @Test
    void checkMail_contextDemandsUnicast_onlySealedOnesCount() {
        String program = PROGRAM + """
                +check <- .setof(S, help[cast(unicast,S)], Sealed);
                    .setof(S, help[source(S)], All);
                    diffuser.note(Sealed,All).
                """;
        RunningAgent agent = RunningAgent.listening(program, board);
        sealedAmongForged();
        board.receive("////", "SUAM", "tell;check");
        agent.notes("[ROMA,SUHO] [ROMA,SUAM,SUHO,SUPO]");
    }

    @Test
    void checkMail_contentHasSemicolonAndStrings_arrivesWhole() {
        RunningAgent agent = ready();
        board.receive("////", "ROMA", "tell;p(\"a;b ü\")");
        agent.notes("plus a;b ü ROMA");
    }

    @Test
    void checkMail_malformedContent_droppedCountedAndTheNextArrives() throws Exception {
        RunningAgent agent = ready();
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

    @Test
    void wake_agentSleeps_messageEndsItsSleep() {
        RunningAgent agent = ready();
        agent.cycles(3);
        assertTrue(agent.body().getTS().canSleep(), "an idle agent can sleep");
        board.receive("////", "ROMA", "tell;p(1)");
        agent.notes("plus 1 ROMA");
    }
}
