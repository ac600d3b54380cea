package javino.board;

import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.function.UnaryOperator;
import javino.JavinoException;
import javino.keyring.BoardNote;
import javino.keyring.BoardNotes;
import javino.keyring.BoundedClock;
import javino.keyring.HeldKeys;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;

/**
 * The epochs and keys of boards that a session knows, by its host's notes too: so that no nonce comes again, and no
 * key that was lost (SPEC 5.1). For the session's thread only.
 */
final class KnownState {

    /** More boots than an EEPROM lasts, and so more epochs than a board can have had since one of its was known. */
    static final int MOST_BOOTS = 400_000;

    private final List<BoardNotes> notes;
    private final BoundedClock clock;
    /** The highest epoch of each board that this session has seen, whether it can be noted or not. */
    private final Map<Address, Integer> seen = new HashMap<>();

    KnownState(List<BoardNotes> notes, BoundedClock clock) {
        this.notes = notes;
        this.clock = clock;
    }

    /**
     * The epoch to which a board is to be raised that was not greeted since its boot: above all that it has had, by the
     * clock and by all that was seen.
     *
     * @param told its keys.
     * @return nothing if its own is high enough, or if it has lost its own and none is known.
     */
    OptionalInt toRaise(BoardInfo board, Map<Address, HeldKeys> told) throws IOException {
        int own = board.bootEpoch();
        if (own > BoardInfo.LAST_EPOCH) {
            return OptionalInt.empty();
        }
        int known = known(board, told, board.hasLostEpoch());
        int next = board.hasLostEpoch() ? known + MOST_BOOTS : known + 1;
        int epoch = known == 0 ? clock.epoch() : Math.max(clock.epoch(), next);
        boolean wasSeen = known != 0 && known == seen(board);
        boolean isKnown = !board.hasLostEpoch() || wasSeen || known != 0 && epoch <= clock.most();
        return isKnown && epoch > own && epoch <= BoardInfo.LAST_EPOCH ? OptionalInt.of(epoch) : OptionalInt.empty();
    }

    /** Whether a board has epochs left, and all that are above those that it has had are used up. */
    boolean isUsedUp(BoardInfo board, Map<Address, HeldKeys> told) throws IOException {
        return !board.hasLostEpoch() && board.bootEpoch() <= known(board, told, false)
                && known(board, told, false) >= BoardInfo.LAST_EPOCH;
    }

    /** Whether a board goes on from an epoch below one that it has had. */
    boolean isOlder(BoardInfo board, Map<Address, HeldKeys> told) throws IOException {
        return !board.hasLostEpoch() && board.bootEpoch() < known(board, told, false);
    }

    /** The highest epoch that a board is known to have had; 0 if none is. */
    private int known(BoardInfo board, Map<Address, HeldKeys> told, boolean onlyShown) throws IOException {
        if (board.rfId().isEmpty()) {
            return 0;
        }
        int known = seen(board);
        for (BoardNotes each : notes) {
            BoardNote note = each.of(board.rfId().get());
            if (!beginsAnew(note, told) && (!onlyShown || note.isShownBy(told))) {
                known = Math.max(known, note.epoch());
            }
        }
        return known;
    }

    private int seen(BoardInfo board) {
        return board.rfId().map(seen::get).orElse(0);
    }

    /**
     * Whether a board that had an epoch years ahead may begin anew: it has no key any more, and never gets those again
     * that are noted.
     */
    private boolean beginsAnew(BoardNote note, Map<Address, HeldKeys> told) {
        return told.isEmpty() && note.epoch() >= clock.most();
    }

    /** Notes the epoch that a board has from now on, before anything is sent; and the keys that it tells. */
    void greeted(BoardInfo board, Map<Address, HeldKeys> told, boolean wasRaised)
            throws IOException, JavinoException, InterruptedException {
        if (board.rfId().isEmpty() || board.bootEpoch() > BoardInfo.LAST_EPOCH) {
            return;
        }
        Address id = board.rfId().get();
        seen.merge(id, board.bootEpoch(), Math::max);
        for (BoardNotes each : notes) {
            change(each, id, note -> {
                boolean isShown = note.isShownBy(told) || each.keepsTold() && note.keys().isEmpty();
                boolean counts = wasRaised || isShown && board.bootEpoch() <= clock.most();
                BoardNote noted = counts && !beginsAnew(note, told) ? note.withEpoch(board.bootEpoch()) : note;
                if (!each.keepsTold()) {
                    return noted;
                }
                return isShown ? noted.withTold(told) : noted.withSeen(told);
            });
        }
    }

    /** Whether a board had a key and has lost it. */
    boolean isLost(Address board, Address with, Bytes check, Map<Address, HeldKeys> told) throws IOException {
        for (BoardNotes each : notes) {
            if (each.of(board).isLost(with, check, told)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Notes a key that a board was given.
     *
     * @param before its keys until then.
     * @param after  its keys for the address.
     */
    void given(BoardInfo board, Address with, Map<Address, HeldKeys> before, HeldKeys after)
            throws IOException, JavinoException, InterruptedException {
        for (BoardNotes each : notes) {
            change(each, board.rfId().orElseThrow(), note -> {
                BoardNote noted = beginsAnew(note, before) ? note.withNewEpoch(board.bootEpoch()) : note;
                HeldKeys had = before.getOrDefault(with, HeldKeys.NONE);
                return each.keepsTold() ? noted.withGiven(with, had).withGiven(with, after) : noted;
            });
        }
    }

    /** Writes only what is new. */
    private static void change(BoardNotes notes, Address board, UnaryOperator<BoardNote> change)
            throws IOException, JavinoException, InterruptedException {
        BoardNote note = notes.of(board);
        if (!change.apply(note).equals(note)) {
            notes.change(board, change);
        }
    }
}
