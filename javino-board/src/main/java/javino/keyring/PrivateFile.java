package javino.keyring;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.EnumSet;
import java.util.Set;
import javino.JavinoException;
import javino.TextFile;

/** Files with keys: texts that only their owner can read. Without POSIX permissions they have those of their folder. */
public final class PrivateFile {

    private static final boolean POSIX = FileSystems.getDefault().supportedFileAttributeViews().contains("posix");
    private static final Set<PosixFilePermission> OWNERS = PosixFilePermissions.fromString("rwx------");
    private static final int TRIES = 200;
    private static final int PAUSE_MILLIS = 50;

    private PrivateFile() {
    }

    /** Makes the new text of a file from the one that it has. */
    public interface Change {
        /** @throws JavinoException if it cannot be made; then the file stays as it is. */
        String apply(String text) throws JavinoException;
    }

    /**
     * Reads a file.
     *
     * @throws IllegalArgumentException if others may read or write it, or as {@link TextFile#read}.
     */
    public static String read(Path file) throws IOException {
        if (POSIX && !OWNERS.containsAll(Files.getPosixFilePermissions(file))) {
            throw new IllegalArgumentException(file + ": others than you may read or write it; chmod 600 " + file);
        }
        return TextFile.read(file);
    }

    /**
     * Makes a file. Nothing that lies there already is followed or written to, and the text goes to no other file than
     * the new one, whatever becomes of its name meanwhile.
     *
     * @throws FileAlreadyExistsException if there is something of this name.
     */
    public static void create(Path file, String text) throws IOException, JavinoException {
        Path folder = file.toAbsolutePath().getParent();
        if (folder != null && !Files.isDirectory(folder)) {
            throw new JavinoException(file + ": there is no folder " + folder);
        }
        try (FileChannel created = open(file)) {
            write(created, text);
        }
    }

    /**
     * Replaces a file as a whole, so that a loss of power leaves the old one or the new one. One program at a time does
     * so.
     *
     * @return the new text.
     * @throws IllegalArgumentException as {@link #read}.
     * @throws JavinoException          if it cannot be changed.
     */
    public static String change(Path file, Change change) throws IOException, JavinoException, InterruptedException {
        Path real = file.toRealPath();
        Path part = real.resolveSibling(real.getFileName() + ".part");
        try (FileChannel created = claim(file, part)) {
            return replace(real, part, created, change);
        }
    }

    private static String replace(Path real, Path part, FileChannel created, Change change)
            throws IOException, JavinoException {
        try {
            String text = change.apply(read(real));
            write(created, text);
            Files.move(part, real, StandardCopyOption.ATOMIC_MOVE);
            return text;
        } catch (IOException | JavinoException | RuntimeException e) {
            Files.deleteIfExists(part);
            throw e;
        }
    }

    private static FileChannel claim(Path file, Path part) throws IOException, JavinoException, InterruptedException {
        for (int tries = 0; tries < TRIES; tries++) {
            try {
                return open(part);
            } catch (FileAlreadyExistsException e) {
                Thread.sleep(PAUSE_MILLIS);
            } catch (AccessDeniedException e) {
                throw new JavinoException(
                        file + " cannot be changed, but what boards and devices have must be noted in it; "
                                + "make its folder writable for you",
                        e);
            }
        }
        throw new JavinoException(file + " is being changed by another program; if none runs, delete " + part);
    }

    private static FileChannel open(Path file) throws IOException {
        FileAttribute<?>[] attributes = POSIX
                ? new FileAttribute<?>[] {
                        PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------"))}
                : new FileAttribute<?>[0];
        return FileChannel.open(file, EnumSet.of(StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE), attributes);
    }

    private static void write(FileChannel to, String text) throws IOException {
        ByteBuffer bytes = ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8));
        while (bytes.hasRemaining()) {
            to.write(bytes);
        }
        to.force(true);
    }
}
