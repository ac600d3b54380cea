package javino.board;

import java.io.IOException;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import javino.JavinoException;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Reply.StoredKey;

/** What a board may have lost of the state on which security rests (SPEC 5.1), for a session and for people. */
public final class LostState {

    private static final String LOST = "the board has lost its boot epoch: something has written over its EEPROM; ";

    private final EpochNotes notes;
    /** The highest epoch of each board that this session has seen: it alone has used them, as the port is its own. */
    private final Map<Address, Integer> seen = new HashMap<>();

    LostState(EpochNotes notes) {
        this.notes = notes;
    }

    /** A board was greeted. */
    void greeted(BoardInfo board) {
        if (board.bootEpoch() <= BoardInfo.LAST_EPOCH) {
            board.rfId().ifPresent(id -> seen.merge(id, board.bootEpoch(), Math::max));
        }
    }

    /** Whether a board has lost its epoch, or goes on from one below another that it has had. */
    boolean isLost(BoardInfo board) {
        return board.hasLostEpoch() || board.bootEpoch() < highest(board);
    }

    private int highest(BoardInfo board) {
        return board.rfId().map(seen::get).orElse(0);
    }

    /**
     * The epoch that a board is to be given, which has lost its own.
     *
     * @return nothing if it is not known what it has had.
     */
    OptionalInt epochFor(BoardInfo board, List<StoredKey> keys, Instant now)
            throws IOException, JavinoException, InterruptedException {
        if (board.rfId().isEmpty()) {
            return OptionalInt.empty();
        }
        int known = highest(board);
        int least = known == 0 ? 0 : EpochNotes.above(known, now);
        OptionalInt noted = notes.raise(board.rfId().get(), keys, least);
        return noted.isPresent() || least == 0 || least > BoardInfo.LAST_EPOCH ? noted : OptionalInt.of(least);
    }

    /** For people: what became of a board's epoch. */
    static String raised(int epoch) {
        return LOST + "it was raised to " + epoch + ", above all that it has had";
    }

    /** For people: what is to be done about a board's epoch. */
    public static String notRaised() {
        return LOST + "it seals nothing until javino provision has raised it by its keyring";
    }

    /** For people: of which keys floors may be lost, if there are any. */
    public static Optional<String> ofFloors(List<StoredKey> keys) {
        String doubtful = keys.stream().filter(StoredKey::doubtful).map(key -> key.address().toString()).distinct()
                .collect(Collectors.joining(", "));
        return doubtful.isEmpty() ? Optional.empty()
                : Optional.of("the board may have lost which messages it had under its keys for " + doubtful
                        + ", and refuses those of senders that it does not remember; make new keys for them: "
                        + "javino keygen --renew");
    }

    /** For people: that the memory of nonces did not hold. */
    public static String ofMemory() {
        return "the sketch's stack, or a wild pointer, has written over the board's memory of nonces: sealed messages "
                + "are neither sent nor taken until it is reset; make the sketch's variables smaller";
    }
}
