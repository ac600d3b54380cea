package javino.keyring;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javino.JavinoException;
import javino.protocol.Address;

/** Notes about boards in a private file, so that none gets a nonce or a lost key again (SPEC 5.1). */
public interface BoardNotes {

    /** The note about a board; {@link BoardNote#NONE} if there is none. */
    BoardNote of(Address board) throws IOException;

    /** Changes that; does nothing where nothing is to be noted of the board. */
    void change(Address board, UnaryOperator<BoardNote> change)
            throws IOException, JavinoException, InterruptedException;

    /** Whether the keys that a board tells are noted; else only those that it was given by whoever notes. */
    boolean keepsTold();

    /** The notes of an agent's host: of the keyring that it names, and of its devices with certificates. */
    static List<BoardNotes> ofHost() {
        Stream<BoardNotes> keyring = Optional.ofNullable(System.getProperty(KeyringNotes.PROPERTY)).stream()
                .map(Path::of).map(KeyringNotes::new);
        return Stream.concat(keyring, Stream.of(DeviceNotes.named())).toList();
    }
}
