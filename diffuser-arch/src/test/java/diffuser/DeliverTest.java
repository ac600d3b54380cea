package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import javino.fake.FakeBoard;
import javino.protocol.Outcome;
import javino.protocol.Status;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code .deliver}: waits for the outcome, and fails with it. */
class DeliverTest {

    private static final String UNDELIVERED = "undelivered : tell;help to ROMA was not acknowledged: its receiver is"
            + " out of reach or a board was lost; it may have arrived all the same";

    private static final String PROGRAM = """
            !start.
            +!start <- .port(antenna); .setMyRFId("SUPO"); diffuser.note(ready).
            +!do <- .deliver("ROMA",tell,help); diffuser.note(done).
            -!do[error(E),error_msg(M)] <- diffuser.note(E,":",M).
            +!other <- .port(missing).
            +seen(N) <- diffuser.note(seen,N).
            +!probe <- diffuser.note(probed).
            +delivered(_,_,_) <- diffuser.note(event).
            +undelivered(_,_,_) <- diffuser.note(event).
            """;

    private final FakeBoard board = new FakeBoard("antenna");

    private RunningAgent ready(String program) {
        RunningAgent agent = RunningAgent.run(program, board);
        agent.notes("ready");
        RunningAgent.asked(board, "id SUPO");
        return agent;
    }

    private RunningAgent waiting(String program) {
        RunningAgent agent = ready(program);
        agent.achieve("do");
        RunningAgent.asked(board, "ROMA tell;help");
        return agent;
    }

    @Test
    void deliver_delivered_goesOnWithoutAnEvent() {
        RunningAgent agent = waiting(PROGRAM);
        agent.notesNothingElse();
        board.end("ROMA tell;help", Outcome.DELIVERED);
        agent.notes("done");
        agent.notesNothingElse();
    }

    @Test
    void deliver_undelivered_failsWithoutAnEvent() {
        RunningAgent agent = waiting(PROGRAM);
        board.end("ROMA tell;help", Outcome.UNDELIVERED);
        agent.notes(UNDELIVERED);
        agent.notesNothingElse();
    }

    @ParameterizedTest
    @CsvSource({"NO_KEY,no_key", "QUEUE_FULL,queue_full", "NO_RF_ID,no_rf_id",
            "BAD_DESTINATION,bad_destination", "NONCE_EXHAUSTED,nonce_exhausted"})
    void deliver_boardRefuses_failsWithItsError(Status status, String error) {
        board.refuse("ROMA tell;help", status);
        RunningAgent agent = waiting(PROGRAM);
        agent.notes(error + " : transmit to ROMA: tell;help failed: " + status + ", " + status.explanation());
    }

    @Test
    void deliver_boardIsAway_failsWithPortOff() {
        board.unplug();
        RunningAgent agent = RunningAgent.run(PROGRAM, board);
        agent.notes("ready");
        agent.achieve("do");
        agent.notes("port_off : transmit to ROMA: tell;help was not performed: antenna: there is no such port");
    }

    @Test
    void deliver_cyclesGoOnMeanwhile() {
        RunningAgent agent = waiting(PROGRAM);
        for (int i = 0; i < 20; i++) {
            agent.believe("seen(" + i + ")");
            agent.notes("seen " + i);
        }
        board.end("ROMA tell;help", Outcome.DELIVERED);
        agent.notes("done");
    }

    @Test
    void deliver_boardIsReset_undelivered() {
        RunningAgent agent = waiting(PROGRAM);
        agent.notesNothingElse();
        board.reset();
        agent.notes(UNDELIVERED);
        agent.achieve("do");
        RunningAgent.asked(board, "ROMA tell;help");
        board.end("ROMA tell;help", Outcome.DELIVERED);
        agent.notes("done");
    }

    @Test
    void deliver_boardIsUnpluggedAndComesBackReset_undelivered() {
        RunningAgent agent = waiting(PROGRAM);
        agent.notesNothingElse();
        board.port.unplug();
        agent.warns("the board is off");
        board.reset();
        board.port.plug();
        agent.notes(UNDELIVERED);
    }

    @Test
    void deliver_boardIsLostBeforeItAnswers_outcomeUnknown() {
        board.swallow("ROMA tell;help");
        RunningAgent agent = waiting(PROGRAM);
        String note = agent.nextNote();
        assertTrue(note.startsWith("outcome_unknown : "), note);
    }

    @Test
    void deliver_anotherPortIsOpened_undelivered() {
        RunningAgent agent = waiting(PROGRAM);
        agent.notesNothingElse();
        agent.achieve("other");
        agent.notes(UNDELIVERED);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {".drop_intention(do)", ".drop_desire(do)", ".drop_all_intentions",
            ".succeed_goal(do)"})
    void deliver_droppedMeanwhile_nothingIsLeft(String drop) {
        String program = PROGRAM + "+!drop <- diffuser.note(dropping); " + drop + ".";
        RunningAgent agent = waiting(program);
        agent.notesNothingElse();
        assertEquals(1, agent.body().getTS().getC().getPendingIntentions().size());
        agent.achieve("drop");
        agent.notes("dropping");
        agent.notesNothingElse();
        assertEquals(0, agent.body().getTS().getC().getPendingIntentions().size());
        board.end("ROMA tell;help", Outcome.DELIVERED);
        agent.notesNothingElse();
        agent.achieve("do");
        RunningAgent.asked(board, "ROMA tell;help");
        board.end("ROMA tell;help", Outcome.UNDELIVERED);
        agent.notes(UNDELIVERED);
        assertEquals(List.of(), List.copyOf(agent.warnings));
    }

    @Test
    void deliver_goalFailedMeanwhile_failsOnce() {
        String program = PROGRAM + "-!do <- diffuser.note(failed). +!drop <- .fail_goal(do).";
        RunningAgent agent = waiting(program);
        agent.notesNothingElse();
        agent.achieve("drop");
        agent.notes("failed");
        board.end("ROMA tell;help", Outcome.UNDELIVERED);
        agent.notesNothingElse();
    }

    @Test
    void deliver_agentStopsMeanwhile_sessionEnds() throws Exception {
        RunningAgent agent = waiting(PROGRAM);
        agent.notesNothingElse();
        agent.close();
        ScriptedDiffuser.join(ScriptedDiffuser.session("antenna"));
        assertEquals(1L, agent.diffuser().getStatus().get("rfUndelivered"));
    }

    @Test
    void deliver_severalAtOnce_eachGoesOnByItself() {
        String program = PROGRAM + """
                +!all <- !to("ROMA") |&| !to("SUHO") |&| !to("SUAM"); diffuser.note(all).
                +!to(X) <- .deliver(X,tell,a); diffuser.note(X).
                """;
        RunningAgent agent = ready(program);
        agent.achieve("all");
        for (int i = 0; i < 3; i++) {
            RunningAgent.next(board.requests, "a request");
        }
        board.end("SUAM tell;a", Outcome.DELIVERED);
        agent.notes("SUAM");
        board.end("ROMA tell;a", Outcome.DELIVERED);
        agent.notes("ROMA");
        board.end("SUHO tell;a", Outcome.DELIVERED);
        agent.notes("SUHO");
        agent.notes("all");
    }

    @Test
    void deliver_inAnAtomicPlan_goesOn() {
        board.endAll(Outcome.DELIVERED);
        String program = PROGRAM + "@a[atomic] +!atomic <- .deliver(\"ROMA\",tell,help); diffuser.note(atomic).";
        RunningAgent agent = ready(program);
        agent.achieve("atomic");
        agent.notes("atomic");
    }

    @Test
    void deliver_undeliveredInAnAtomicPlan_fails() {
        board.endAll(Outcome.UNDELIVERED);
        String program = PROGRAM + """
                @a[atomic] +!atomic <- .deliver("ROMA",tell,help).
                -!atomic[error(E)] <- diffuser.note(E).
                """;
        RunningAgent agent = ready(program);
        agent.achieve("atomic");
        agent.notes("undelivered");
    }

    @Test
    void deliver_triedAgainAfterFailure_secondSucceeds() {
        String program = PROGRAM + """
                +!insist <- .deliver("ROMA",tell,help); diffuser.note(insisted).
                -!insist[error(undelivered)] <- !insist.
                """;
        RunningAgent agent = ready(program);
        agent.achieve("insist");
        RunningAgent.asked(board, "ROMA tell;help");
        board.end("ROMA tell;help", Outcome.UNDELIVERED);
        RunningAgent.asked(board, "ROMA tell;help");
        board.end("ROMA tell;help", Outcome.DELIVERED);
        agent.notes("insisted");
    }
}
