package javino.keyring;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.UnaryOperator;
import javino.JavinoException;
import javino.protocol.Address;

/**
 * The notes of devices with certificates: for each a file beside its identity, {@code SUPO.note}, with a line as a
 * keyring has it.
 *
 * @param folder the folder of the identities.
 */
public record DeviceNotes(Path folder) implements BoardNotes {

    /** Names the folder of identities where it is not {@link #defaultFolder}. */
    public static final String FOLDER_PROPERTY = "javino.identities";

    private static final String IDENTITY = ".identity";

    /** The folder in which {@code javino enroll} puts identities unless told otherwise: {@code ~/.javino}. */
    public static Path defaultFolder() {
        return Path.of(System.getProperty("user.home"), ".javino");
    }

    /** The notes in the folder that the property names, or in the default one. */
    public static DeviceNotes named() {
        return new DeviceNotes(Path.of(System.getProperty(FOLDER_PROPERTY, defaultFolder().toString())));
    }

    /** The file of a device's identity. */
    public static Path identity(Path folder, Address device) {
        return beside(folder, device, IDENTITY);
    }

    private static Path beside(Path folder, Address device, String kind) {
        // A slash is a digit of addresses, and no letter of a file's name.
        return folder.resolve(device.toString().replace('/', '-') + kind);
    }

    private Path file(Address board) {
        return beside(folder, board, ".note");
    }

    @Override
    public BoardNote of(Address board) throws IOException {
        return Files.exists(file(board)) ? Keyring.read(file(board)).note(board) : BoardNote.NONE;
    }

    @Override
    public void change(Address board, UnaryOperator<BoardNote> change)
            throws IOException, JavinoException, InterruptedException {
        if (!Files.exists(identity(folder, board))) {
            return;
        }
        if (!Files.exists(file(board))) {
            try {
                PrivateFile.create(file(board), "");
            } catch (FileAlreadyExistsException e) {
                // Another program of this host was first.
            }
        }
        Keyring.change(file(board), latest -> latest.note(board, change.apply(latest.note(board))));
    }

    @Override
    public boolean keepsTold() {
        return true;
    }
}
