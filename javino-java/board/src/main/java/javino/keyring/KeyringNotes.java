package javino.keyring;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.UnaryOperator;
import javino.JavinoException;
import javino.protocol.Address;

/**
 * The notes of a keyring, for a host that has one beside its agents.
 *
 * @param file the keyring.
 */
public record KeyringNotes(Path file) implements BoardNotes {

    /** Names the keyring's file to an agent's host. */
    public static final String PROPERTY = "javino.keyring";

    @Override
    public BoardNote of(Address board) throws IOException {
        return Keyring.read(file).note(board);
    }

    @Override
    public void change(Address board, UnaryOperator<BoardNote> change)
            throws IOException, JavinoException, InterruptedException {
        // A board that it does not know is not its own.
        if (!of(board).equals(BoardNote.NONE)) {
            Keyring.change(file, latest -> latest.note(board, change.apply(latest.note(board))));
        }
    }

    @Override
    public boolean keepsTold() {
        return false;
    }
}
