package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

import javino.fake.FakeBoard;

/** The paper's plan 1, as printed but for its trigger. */
class PlanOneTest {

    private static final String PLAN_ONE = """
            !start.
            +!start : true <-
                .print("I am a Diffuser agent");
                .port(COM5);
                .percepts(open);
                .setMyRFId(ROMA);
                .getRFMessages(open);
                diffuser.note(ready).
            +port(P,S) <- diffuser.note(P,S).
            +proximity(X) <- diffuser.note(proximity,X).
            +help[source(S)] <- diffuser.note(help,S); .diffuse(S,tell,helpComing).
            """;

    @Test
    void plan1_boardIsThere_runsAsPrinted() {
        FakeBoard board = new FakeBoard("COM5").perceive("proximity(17)");
        RunningAgent agent = RunningAgent.run(PLAN_ONE, board);
        agent.notes("COM5 on");
        RunningAgent.asked(board, "id ROMA");
        RunningAgent.asked(board, "radio 1");
        agent.notesAll("ready", "proximity 17");
        board.receive("////", "SUPO", "tell;help");
        agent.notes("help SUPO");
        RunningAgent.asked(board, "SUPO tell;helpComing");
    }

    @Test
    void plan1_boardIsNotThere_runsAllTheSameAndHoldsOnceItComes() {
        FakeBoard board = new FakeBoard("COM5").perceive("proximity(17)").unplug();
        RunningAgent agent = RunningAgent.run(PLAN_ONE, board);
        agent.notesAll("COM5 off", "ready");
        agent.warns("the board is off: COM5: there is no such port");
        board.port.plug();
        agent.notesAll("COM5 on", "proximity 17");
        board.receive("ROMA", "SUPO", "tell;help");
        agent.notes("help SUPO");
        assertEquals("ROMA", board.rfId());
    }
}
