package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;

import javino.fake.FakeBoard;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Plans that come by radio, and signals. */
class PlansTest {

    private static final String PROGRAM = """
            !start.
            +!start <- .port(antenna); .setMyRFId("SUPO"); .getRFMessages(open); diffuser.note(ready).
            +!go <- diffuser.note(mine).
            +!count(Event) <- .relevant_plans(Event,Plans); .length(Plans,N); diffuser.note(N).
            +!probe <- diffuser.note(probed).
            +bell(X)[source(S),cast(C,S)] : not bell(_) <- diffuser.note(bell,X,S,C).
            """;
    private static final String PLAN = "{ @run +!run(X) : X > 1 <- diffuser.note(\"a \\\"b\\\"\\n\u00e9\",X) }";

    private final FakeBoard board = new FakeBoard("antenna");

    private RunningAgent ready(String program) {
        RunningAgent agent = RunningAgent.run(program, board);
        agent.notes("ready");
        RunningAgent.asked(board, "id SUPO");
        RunningAgent.asked(board, "radio 1");
        return agent;
    }

    private RunningAgent ready() {
        return ready(PROGRAM);
    }

    @ParameterizedTest
    @ValueSource(strings = {"SUPO", "//SU"})
    void tellHow_sealed_planRunsUntilItIsTakenBack(String to) {
        String program = PROGRAM + "-!run(_) <- diffuser.note(unable).";
        RunningAgent agent = ready(program);
        board.receive(to, "ROMA", "tellHow;" + PLAN);
        agent.cycles(5);
        agent.achieve("run(2)");
        agent.notes("a \"b\"\n\u00e9 2");
        board.receive(to, "ROMA", "untellHow;run");
        agent.cycles(5);
        agent.achieve("run(2)");
        agent.notes("unable");
    }

    @ParameterizedTest
    @ValueSource(strings = {"\"+!run(X) <- diffuser.note(X).\"",
            "[\"+!run(X) <- diffuser.note(X).\",{ @other +!stay <- true }]", "[{ +!run(X) <- diffuser.note(X) }]"})
    void tellHow_stringOrList_planRuns(String plans) {
        RunningAgent agent = ready();
        board.receive("SUPO", "ROMA", "tellHow;" + plans);
        agent.cycles(5);
        agent.achieve("run(2)");
        agent.notes("2");
    }

    @Test
    void tellHow_broadcast_isRefusedCountedAndReportedOnce() throws Exception {
        RunningAgent agent = ready();
        for (int i = 0; i < 3; i++) {
            board.receive("////", "ROMA", "tellHow;{ @p" + i + " +!go <- diffuser.note(theirs) }");
        }
        board.receive("////", "ROMA", "untellHow;start");
        agent.warns("dropped tellHow from ROMA: it came as a broadcast");
        agent.warns("dropped untellHow from ROMA: it came as a broadcast");
        agent.notesNothingElse();
        assertEquals(4L, agent.diffuser().inbox().refused());
        assertEquals(0, agent.warnings.size());
        agent.achieve("count({ +!go })");
        agent.notes("1");
        agent.achieve("count({ +!start })");
        agent.notes("1");
    }

    @Test
    void tellHow_agentHasAPlanAgainstIt_isNotTaught() {
        String program = PROGRAM + "+!kqml_received(S,tellHow,_,_) <- diffuser.note(S,refused).";
        RunningAgent agent = ready(program);
        board.receive("SUPO", "ROMA", "tellHow;{ @p +!run(_) <- diffuser.note(theirs) }");
        agent.notes("ROMA refused");
        agent.achieve("count({ +!run(_) })");
        agent.notes("0");
    }

    @Test
    void untellHow_planOfTheAgentItself_stays() {
        String program = PROGRAM + "@mine +!stay <- diffuser.note(stayed).";
        RunningAgent agent = ready(program);
        board.receive("SUPO", "ROMA", "untellHow;mine");
        agent.notesNothingElse();
        agent.achieve("stay");
        agent.notes("stayed");
    }

    @Test
    void askHow_answered_plansArriveAtTheAskerAndRun() {
        String program = PROGRAM + "+!learn <- .send(\"ROMA\",askHow,{ +!run(_) },P); .add_plan(P,roma); !run(2).";
        RunningAgent agent = ready(program);
        agent.achieve("learn");
        String id = Conversing.asked(board, "ROMA askHow;\\{ \\+!run\\(\\w+\\) }");
        board.receive("SUPO", "ROMA", "tellHow#" + id + ";[" + PLAN + "]");
        agent.notes("a \"b\"\n\u00e9 2");
    }

    @Test
    void askHow_notAwaited_answerIsLearnt() {
        String program = PROGRAM + "+!learn <- .send(\"ROMA\",askHow,\"+!run(_)\").";
        RunningAgent agent = ready(program);
        agent.achieve("learn");
        String id = Conversing.asked(board, "ROMA askHow;\"\\+!run\\(_\\)\"");
        board.receive("SUPO", "ROMA", "tellHow#" + id + ";[" + PLAN + "]");
        agent.cycles(5);
        agent.achieve("run(2)");
        agent.notes("a \"b\"\n\u00e9 2");
    }

    @Test
    void signal_anyCast_isAnEventAndNoBelief() {
        RunningAgent agent = ready();
        board.receive("////", "ROMA", "signal;bell(1)");
        agent.notes("bell 1 ROMA broadcast");
        board.receive("SUPO", "ROMA", "signal;bell(2)");
        agent.notes("bell 2 ROMA unicast");
        agent.notesNothingElse();
    }
}
