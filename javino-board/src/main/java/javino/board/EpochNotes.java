package javino.board;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.OptionalInt;
import javino.JavinoException;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Reply.StoredKey;

/**
 * What a host knows of the boot epochs of boards (SPEC 5.1), so that one that has lost its epoch gets a higher one than
 * it ever had.
 */
public interface EpochNotes {

    /** Nothing is known. */
    EpochNotes NONE = (board, keys, least) -> OptionalInt.empty();

    /** Minutes since then are the epoch that a board is given at least: enough for 31 years. */
    Instant FIRST_EPOCH = Instant.parse("2026-01-01T00:00:00Z");

    /** More boots than an EEPROM lasts, and so more epochs than a board can have had since one of its was known. */
    int MOST_BOOTS = 400_000;

    /**
     * Finds an epoch above all that a board has had, and notes it before the board has it.
     *
     * @param board its address.
     * @param keys  that it has.
     * @param least an epoch that is high enough by what the session knows; 0 if it knows nothing.
     * @return nothing if nothing is noted of this board.
     */
    OptionalInt raise(Address board, List<StoredKey> keys, int least)
            throws IOException, JavinoException, InterruptedException;

    /** The epoch of a time by the clock, 0…0xFFFFFE; 0 before 2026, as a computer without a clock has it. */
    static int at(Instant time) {
        return (int) Math.min(BoardInfo.LAST_EPOCH, Math.max(0, Duration.between(FIRST_EPOCH, time).toMinutes()));
    }

    /**
     * An epoch above all that a board can have had; {@link BoardInfo#LAST_EPOCH} plus 1 if none is left.
     *
     * @param known one that it has had, whenever that was.
     */
    static int above(int known, Instant now) {
        return Math.min(BoardInfo.LAST_EPOCH + 1, Math.max(at(now), known + MOST_BOOTS));
    }
}
