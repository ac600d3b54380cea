package javino.link;

import com.fazecast.jSerialComm.SerialPort;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import javino.JavinoException;

/**
 * The native library of jSerialComm. Before its first use jSerialComm unpacks it below the folders that two properties
 * name: to a place that every user of the computer may write, from which it also loads a library that lies there
 * already, and which it clears of other files, through links too. Another user could so have us run a program or
 * delete files. While it does so here, both properties name new folders that nobody else may enter.
 */
final class NativeLibrary {

    /** jSerialComm takes the second where the first may hold no programs. */
    private static final List<String> PROPERTIES = List.of("java.io.tmpdir", "user.home");

    private static boolean loaded;
    private static String failure;

    private NativeLibrary() {
    }

    /**
     * Loads it, the first time.
     *
     * @throws JavinoException each time, if there is none for this computer or no folder to unpack it to.
     */
    static synchronized void load() throws JavinoException {
        if (failure != null) {
            throw new JavinoException(failure);
        }
        if (loaded) {
            return;
        }
        if (FileSystems.getDefault().supportedFileAttributeViews().contains("posix")) {
            loadFromOwnFolders();
        } else {
            // Windows: a user's temporary folder is his own, and a library that is in use cannot be deleted.
            SerialPort.getVersion();
        }
        loaded = true;
    }

    private static void loadFromOwnFolders() throws JavinoException {
        Map<String, String> usual = new LinkedHashMap<>();
        PROPERTIES.forEach(property -> usual.put(property, System.getProperty(property)));
        List<Path> own = usual.values().stream().map(NativeLibrary::ownFolderIn).flatMap(Optional::stream).toList();
        if (own.isEmpty()) {
            throw new JavinoException("serial ports need a folder that you may write: " + either(usual));
        }
        try {
            // Not every user has a home; then the first folder has to do for both.
            for (int i = 0; i < PROPERTIES.size(); i++) {
                System.setProperty(PROPERTIES.get(i), own.get(Math.min(i, own.size() - 1)).toString());
            }
            SerialPort.getVersion();
        } catch (LinkageError e) {
            failure = "serial ports need a native library, and jSerialComm has none for this computer ("
                    + System.getProperty("os.name") + ", " + System.getProperty("os.arch") + "), or " + either(usual)
                    + " must be allowed to hold programs (no mount option noexec)";
            throw new JavinoException(failure, e);
        } finally {
            usual.forEach(System::setProperty);
            own.forEach(NativeLibrary::delete);
        }
    }

    private static String either(Map<String, String> folders) {
        return String.join(" or ", folders.values());
    }

    /** A new one that its owner alone may enter. */
    private static Optional<Path> ownFolderIn(String folder) {
        try {
            return Optional.of(Files.createTempDirectory(Path.of(folder), ".javino"));
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    /** A library that is loaded needs its file no more. */
    private static void delete(Path folder) {
        try (Stream<Path> all = Files.walk(folder)) {
            for (Path each : all.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(each);
            }
        } catch (IOException | UncheckedIOException e) {
            // A network's file system may keep a file that is in use. Nobody else can enter its folder.
        }
    }
}
