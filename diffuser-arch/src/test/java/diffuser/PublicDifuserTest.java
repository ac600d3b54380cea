package diffuser;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import javino.fake.FakeBoard;

/** Agents as they are written for the public Difuser architecture, 0.2. */
@Tag("newerJava")
class PublicDifuserTest {

    private static final String RECEIVER = """
            !start.
            +!start <- .difuser.port(ttyExogenous3); .difuser.limit(10); .difuser.listen(open);
                diffuser.note(listening).
            +!deaf(How) <- .difuser.listen(How); diffuser.note(deaf).
            +message(random(I,R)) <- diffuser.note(message,I,R); .difuser.transmit(ack(I)).
            """;

    private static final String TRANSMITTER = """
            iteration(2).
            !start.
            +!start <- .difuser.port(ttyEmulatedPort3); .difuser.listen(open); .difuser.limit(10); !transmit.
            +!transmit : iteration(I) & I > 0 <- .difuser.transmit(random(I,0.5)).
            -!transmit[error(E)] <- diffuser.note(end,E).
            +message(ack(I)) <- -+iteration(I-1); diffuser.note(ack,I); !transmit.
            """;

    private static RunningAgent difuser(String program, FakeBoard... boards) {
        return RunningAgent.run(program, null, List.of(ScriptedArgo.class.getName()), boards);
    }

    private static FakeBoard board(String port) {
        return new FakeBoard(port).setRfId("SUPO");
    }

    @Test
    void receiver_messagesByRadio_areEventsEachTimeAndAnswered() {
        FakeBoard board = board("ttyExogenous3");
        RunningAgent agent = difuser(RECEIVER, board);
        agent.notes("listening");
        RunningAgent.asked(board, "radio 1");
        for (int i = 0; i < 2; i++) {
            board.receive("////", "ROMA", "signal;message(random(7,0.5))");
            agent.notes("message 7 0.5");
            RunningAgent.asked(board, "//// signal;message(ack(7))");
        }
    }

    @Test
    void receiver_messageAsPercept_isAnEvent() {
        FakeBoard board = board("ttyExogenous3");
        RunningAgent agent = difuser(RECEIVER, board);
        agent.notes("listening");
        board.perceive("message(random(8,0.25))");
        agent.notes("message 8 0.25");
    }

    @ParameterizedTest
    @ValueSource(strings = {"close", "block"})
    void listen_closed_hearsNothing(String how) {
        FakeBoard board = board("ttyExogenous3");
        RunningAgent agent = difuser(RECEIVER + "+!probe <- diffuser.note(probed).", board);
        agent.notes("listening");
        RunningAgent.asked(board, "radio 1");
        agent.achieve("deaf(" + how + ")");
        agent.notes("deaf");
        RunningAgent.asked(board, "radio 0");
        board.perceive("message(random(8,0.25))");
        agent.notesNothingElse();
    }

    @Test
    void transmit_sketchHasTheAction_performsIt() {
        FakeBoard board = new FakeBoard("ttyEmulatedPort3").setActions("stop", "message");
        RunningAgent agent = difuser(TRANSMITTER, board);
        RunningAgent.asked(board, "radio 1");
        RunningAgent.asked(board, "act message(random(2,0.5))");
        board.perceive("message(ack(2))");
        agent.notes("ack 2");
        RunningAgent.asked(board, "act message(random(1,0.5))");
    }

    @Test
    void transmitter_eachAcknowledgement_sendsTheNext() {
        FakeBoard board = board("ttyEmulatedPort3");
        RunningAgent agent = difuser(TRANSMITTER, board);
        RunningAgent.asked(board, "radio 1");
        RunningAgent.asked(board, "//// signal;message(random(2,0.5))");
        board.receive("////", "ROMA", "signal;message(ack(2))");
        agent.notes("ack 2");
        RunningAgent.asked(board, "//// signal;message(random(1,0.5))");
        board.receive("////", "ROMA", "signal;message(ack(1))");
        agent.notes("ack 1");
        agent.notes("end no_applicable");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            ".difuser.listen(yes)        | wrong_arguments | open or block was expected, not 'yes'",
            ".difuser.listen             | wrong_arguments | One argument is expected",
            ".difuser.limit(soon)        | wrong_arguments | milliseconds from 0 to 3600000",
            ".difuser.port(5)            | wrong_arguments | a port's name such as",
            ".difuser.transmit(a,b)      | wrong_arguments | One argument is expected",
            ".difuser.transmit(hello)    | no_rf_id        | the board has no RF id",
    })
    void action_thatFails_saysWhy(String action, String error, String fragment) {
        String program = "!start. +!start <- .difuser.port(desk); !do. +!do <- " + action + "; diffuser.note(done)."
                + "-!do[error(E),error_msg(M)] <- diffuser.note(E,\":\",M).";
        RunningAgent agent = difuser(program, new FakeBoard("desk"));
        String note = agent.nextNote();
        assertTrue(note.startsWith(error + " :"), note);
        assertTrue(note.contains(fragment), note);
    }

    @ParameterizedTest
    @ValueSource(strings = {".difuser.listen(open)", ".difuser.transmit(hello)"})
    void action_ofAnAgentWithAnotherArchitecture_saysWhichItNeeds(String action) {
        String program =
                "!start. +!start <- " + action + ". -!start[error(E),error_msg(M)] <- diffuser.note(E,\":\",M).";
        RunningAgent agent = RunningAgent.run(program);
        String note = agent.nextNote();
        assertTrue(note.startsWith("no_diffuser :") && note.contains("jason.Difuser"), note);
    }
}
