package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import javino.fake.FakeBoard;
import javino.protocol.Capability;

/** An agent whose board has no radio. */
class WithoutRadioTest {

    private static final String PROGRAM = """
            !start.
            +!start <- .port(plain); .percepts(open); diffuser.note(ready).
            +!do <- %s; diffuser.note(done).
            -!do[error(E),error_msg(M)] <- diffuser.note(E,M).
            +undelivered(_,_,_)[error(E)] <- diffuser.note(E).
            +dark <- diffuser.note(dark).
            """;
    private static final String MESSAGE = "failed: NO_RADIO, the board has no radio; for one, its sketch makes a "
            + "JavinoRadioBoard";

    private static FakeBoard board() {
        return new FakeBoard("plain").setCapabilities(Capability.SAYS_TAKEN);
    }

    @ParameterizedTest
    @ValueSource(strings = {".setMyRFId(\"ROMA\")", ".getRFMessages(open)", ".getRFMessages(block)",
            ".diffuse(\"SUPO\",tell,help)", ".diffuse(broadcast,tell,help)"})
    void action_ofTheRadio_failsAndTheBoardIsNotAsked(String action) {
        FakeBoard board = board();
        RunningAgent agent = RunningAgent.run(PROGRAM.formatted(action), board);
        agent.notes("ready");
        agent.achieve("do");
        String note = agent.nextNote();
        assertTrue(note.startsWith("no_radio ") && note.contains(MESSAGE), note);
        assertEquals(List.of(), List.copyOf(board.requests));
    }

    @Test
    void send_toADevice_isUndeliveredAsThereIsNoRadio() {
        RunningAgent agent = RunningAgent.run(PROGRAM.formatted(".send(\"SUPO\",tell,help)"), board());
        agent.notes("ready");
        agent.achieve("do");
        agent.notesAll("done", "no_radio");
    }

    @Test
    void board_withoutRadio_sensesAndActs() {
        FakeBoard board = board().perceive("dark");
        RunningAgent agent = RunningAgent.run(PROGRAM.formatted(".act(stop)"), board);
        agent.notesAll("ready", "dark");
        agent.achieve("do");
        agent.notes("done");
        assertEquals(List.of("act stop"), List.copyOf(board.requests));
    }

    @Test
    void port_afterWishesForTheRadio_warnsOfThem() {
        String program = "!start. +!start <- .setMyRFId(\"ROMA\"); .getRFMessages(open); .port(plain); "
                + "diffuser.note(ready).";
        FakeBoard board = board();
        RunningAgent agent = RunningAgent.run(program, board);
        agent.notes("ready");
        agent.warns("plain: the board has no radio; for one, its sketch makes a JavinoRadioBoard");
        assertEquals(List.of(), List.copyOf(board.requests));
    }
}
