package javino.keyring;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import javino.JavinoException;
import javino.board.EpochNotes;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Reply.StoredKey;

/** The notes of a keyring, for a host that has one beside its agents. */
public final class KeyringNotes implements EpochNotes {

    /** Names the keyring's file to an agent's host. */
    public static final String PROPERTY = "javino.keyring";

    private final Path file;

    private KeyringNotes(Path file) {
        this.file = file;
    }

    /** Those of the file that the property {@link #PROPERTY} names. */
    public static EpochNotes named() {
        return Optional.ofNullable(System.getProperty(PROPERTY))
                .<EpochNotes>map(name -> new KeyringNotes(Path.of(name)))
                .orElse(NONE);
    }

    @Override
    public OptionalInt raise(Address board, List<StoredKey> keys, int least)
            throws IOException, JavinoException, InterruptedException {
        BoardNote note = Keyring.read(file).note(board);
        Map<Address, HeldKeys> held = HeldKeys.of(keys);
        boolean proved = held.entrySet().stream()
                .anyMatch(key -> key.getValue().current() != null
                        && note.held(key.getKey()).accepts(key.getValue().current()));
        Instant now = Instant.now();
        int epoch = Math.max(least, EpochNotes.above(note.epoch(), now));
        if (note.epoch() == 0 || !proved || epoch > Math.min(BoardInfo.LAST_EPOCH, BoardNote.mostAt(now))) {
            return OptionalInt.empty();
        }
        Keyring.change(file, latest -> latest.note(board, latest.note(board).withEpoch(epoch)));
        return OptionalInt.of(epoch);
    }
}
