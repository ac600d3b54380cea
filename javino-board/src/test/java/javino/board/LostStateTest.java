package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.OptionalInt;
import javino.protocol.BoardInfo;
import org.junit.jupiter.api.Test;

/** What a session does with a board that has lost the state on which security rests. */
class LostStateTest extends BoardFixture {

    private void setEpoch(int epoch) {
        fake.setRfId("SUPO");
        fake.keys.setEpoch(epoch);
        open(listener);
    }

    private String warning() throws InterruptedException {
        String event = listener.next();
        assertTrue(event.startsWith("warning "), event);
        return event;
    }

    @Test
    void epoch_lostWhileTheSessionKnowsIt_isRaisedAboveAllThatCanHaveBeen() throws Exception {
        setEpoch(9_000_000);
        listener.until("online");
        for (int loss = 1; loss <= 2; loss++) {
            fake.keys.loseEpoch();
            fake.reset();
            listener.until("offline");
            int above = 9_000_000 + loss * EpochNotes.MOST_BOOTS;
            assertTrue(warning().endsWith("it was raised to " + above + ", above all that it has had"));
            assertEquals("online " + above, listener.next());
            assertEquals(above, board.info().orElseThrow().bootEpoch());
            assertEquals(above, fake.keys.epoch());
        }
    }

    @Test
    void epoch_belowOneThatTheSessionKnows_isRaisedToo() throws Exception {
        setEpoch(9_000_000);
        listener.until("online");
        fake.keys.setEpoch(7);
        fake.reset();
        listener.until("offline");
        assertTrue(warning().contains("raised to 9400000"));
        assertEquals("online 9400000", listener.next());
    }

    @Test
    void epoch_lostAndNotKnown_isNotRaisedAndSaysWhatToDo() throws Exception {
        setEpoch(0);
        assertTrue(warning().contains("it seals nothing until javino provision has raised it by its keyring"));
        assertEquals("online 0", listener.next());
        assertTrue(board.info().orElseThrow().hasLostEpoch());
        assertEquals(0, fake.keys.epoch());
        fake.reset();
        assertFalse(listener.until("online").isEmpty(), "it is greeted again, though no epoch tells its boots apart");
    }

    @Test
    void epoch_lostAndNoted_isRaisedBeforeItIsOnline() throws Exception {
        fake.setRfId("SUPO");
        fake.keys.setEpoch(0);
        open(listener, config -> config.setEpochNotes((id, keys, least) -> {
            assertEquals(0, least);
            return OptionalInt.of(470_012);
        }));
        assertTrue(warning().contains("raised to 470012"));
        assertEquals("online 470012", listener.next());
    }

    @Test
    void epoch_notesThatCannotBeRead_areNamed() throws Exception {
        fake.setRfId("SUPO");
        fake.keys.setEpoch(0);
        open(listener, config -> config.setEpochNotes((id, keys, least) -> {
            throw new IllegalArgumentException("keys, line 3: wrong");
        }));
        assertTrue(warning().endsWith("(keys, line 3: wrong)"));
    }

    @Test
    void memory_thatDoesNotHold_isWarnedOfOnce() throws Exception {
        open(listener);
        listener.until("online");
        fake.setDamaged();
        assertTrue(warning().contains("has written over the board's memory of nonces"));
        fake.line.awaitPolls(3);
        fake.reset();
        assertEquals("offline fake: the board was reset", listener.next());
    }

    @Test
    void above_isNeverAnEpochThatWasKnown() {
        Instant early = Instant.EPOCH;
        assertEquals(400_001, EpochNotes.above(1, early));
        assertEquals(473_760, EpochNotes.above(1, Instant.parse("2026-11-26T00:00:00Z")));
        assertEquals(BoardInfo.LAST_EPOCH + 1, EpochNotes.above(BoardInfo.LAST_EPOCH - 7, early));
    }
}
