package diffuser;

import java.util.List;

import javino.board.BoardConfig;
import javino.fake.FakeBoard;
import javino.protocol.Outcome;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Jason's {@code .suspend} and {@code .resume}, said of an intention that waits for the board. */
class SuspendTest {

    private static final String PROGRAM = """
            !start.
            +!start <- .port(body); .setMyRFId("SUPO"); diffuser.note(ready).
            +!outer <- !do; diffuser.note(outer).
            +!do <- %s; diffuser.note(done).
            -!do[error(outcome_unknown)] <- diffuser.note(failed).
            -!do[error(undelivered)] <- diffuser.note(failed).
            +!halt(G) <- .suspend(G); diffuser.note(halted).
            +!on(G) <- .resume(G); diffuser.note(resumed).
            +!other <- .act(go); diffuser.note(other).
            +!drop <- .drop_intention(do); diffuser.note(dropped).
            +!probe <- diffuser.note(probed).
            """;

    private final FakeBoard board = new FakeBoard("body");

    /** Waits for a board as long as a test lets it. */
    public static class Patient extends ScriptedDiffuser {

        private static final long serialVersionUID = 1L;

        @Override
        protected BoardConfig boardConfig() {
            return BoardConfig.create(config -> config.setAttempts(1000));
        }
    }

    private RunningAgent run(String program) {
        return RunningAgent.run(program, null, List.of(Patient.class.getName()), board);
    }

    private RunningAgent waiting(String action, String request) {
        RunningAgent agent = run(PROGRAM.formatted(action));
        agent.notes("ready");
        RunningAgent.asked(board, "id SUPO");
        board.stallAt(request);
        agent.achieve("outer");
        RunningAgent.asked(board, request);
        return agent;
    }

    private static void suspend(RunningAgent agent, String goal) {
        agent.achieve("halt(" + goal + ")");
        agent.notes("halted");
    }

    private static void resume(RunningAgent agent, String goal) {
        agent.achieve("on(" + goal + ")");
        agent.notes("resumed");
    }

    @ParameterizedTest
    @CsvSource({".act(stop),do", ".act(stop),outer", "stop,do", "stop,outer"})
    void suspend_boardHasDoneIt_goesOnAfterResumeOnly(String action, String goal) {
        RunningAgent agent = waiting(action, "act stop");
        suspend(agent, goal);
        board.resume();
        answerToAnother(agent);
        resume(agent, goal);
        agent.notes("done");
        agent.notes("outer");
        agent.notesNothingElse();
    }

    /** When the board has answered this, the answer before is there too. */
    private void answerToAnother(RunningAgent agent) {
        agent.achieve("other");
        RunningAgent.asked(board, "act go");
        agent.notes("other");
        agent.notesNothingElse();
    }

    @ParameterizedTest
    @ValueSource(strings = {".act(stop)", "stop"})
    void suspend_boardIsLost_failsAfterResumeOnly(String action) {
        RunningAgent agent = waiting(action, "act stop");
        suspend(agent, "do");
        board.port.unplug();
        board.resume();
        agent.warns("the board is off");
        agent.notesNothingElse();
        resume(agent, "do");
        agent.notes("failed");
        agent.notes("outer");
        agent.notesNothingElse();
    }

    @ParameterizedTest
    @CsvSource({"DELIVERED,done", "UNDELIVERED,failed"})
    void suspend_messageHasEnded_goesOnAfterResumeOnly(Outcome outcome, String note) {
        RunningAgent agent = waiting(".deliver(\"ROMA\",tell,help)", "ROMA tell;help");
        board.resume();
        suspend(agent, "do");
        board.end("ROMA tell;help", outcome);
        answerToAnother(agent);
        resume(agent, "do");
        agent.notes(note);
        agent.notes("outer");
    }

    @Test
    void suspend_questionThatCannotBeAnswered_failsAfterResumeOnly() {
        board.endAll(Outcome.UNDELIVERED);
        String ask = ".send(\"ROMA\",askOne,p(_),_)";
        board.stallAt("ROMA askOne");
        RunningAgent agent = run(PROGRAM.formatted(ask));
        agent.notes("ready");
        RunningAgent.asked(board, "id SUPO");
        agent.achieve("outer");
        Conversing.asked(board, "ROMA askOne;p\\(\\w+\\)");
        suspend(agent, "do");
        board.resume();
        answerToAnother(agent);
        resume(agent, "do");
        agent.notes("failed");
        agent.notes("outer");
    }

    @ParameterizedTest
    @ValueSource(strings = {".act(stop)", "stop"})
    void suspend_resumedBeforeTheBoardAnswers_goesOnWhenItHas(String action) {
        RunningAgent agent = waiting(action, "act stop");
        suspend(agent, "do");
        resume(agent, "do");
        agent.notesNothingElse();
        board.resume();
        agent.notes("done");
        agent.notes("outer");
    }

    @ParameterizedTest
    @ValueSource(strings = {".act(stop)", "stop"})
    void suspend_droppedMeanwhile_nothingElseHappens(String action) {
        RunningAgent agent = waiting(action, "act stop");
        suspend(agent, "do");
        board.resume();
        answerToAnother(agent);
        agent.achieve("drop");
        agent.notes("dropped");
        resume(agent, "do");
        agent.notesNothingElse();
    }

    @Test
    void suspend_plainActionBesideAnother_onlyTheOtherGoesOn() {
        String more = "+!second <- go; diffuser.note(second).";
        RunningAgent agent = run(PROGRAM.formatted("stop") + more);
        agent.notes("ready");
        RunningAgent.asked(board, "id SUPO");
        board.stallAt("act stop");
        agent.achieve("outer");
        RunningAgent.asked(board, "act stop");
        suspend(agent, "do");
        board.resume();
        for (int i = 0; i < 3; i++) {
            agent.achieve("second");
            RunningAgent.asked(board, "act go");
            agent.notes("second");
        }
        agent.notesNothingElse();
        resume(agent, "do");
        agent.notes("done");
    }
}
