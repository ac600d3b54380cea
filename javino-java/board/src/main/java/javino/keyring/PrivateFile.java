package javino.keyring;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.EnumSet;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import javino.JavinoException;
import javino.TextFile;

/**
 * Files with secrets, which only their owner can read. All that Java writes of keys, secrets and agents' minds goes
 * through here: nothing that lies there already is followed or written to, but for its own file that a dead program has
 * left, and where permissions cannot be kept, as on a stick, no file is left. Without POSIX permissions, as on Windows,
 * files have those of their folder.
 */
public final class PrivateFile {

    private static final Set<PosixFilePermission> OWNERS = PosixFilePermissions.fromString("rwx------");
    private static final Set<PosixFilePermission> OF_A_FILE = PosixFilePermissions.fromString("rw-------");
    private static final String NEW = ".new";
    /** Parts that this program is writing: the system would give a lock up if its file was opened and closed again. */
    private static final Set<Path> CLAIMED = ConcurrentHashMap.newKeySet();
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
        if (!isPrivate(file)) {
            throw new IllegalArgumentException(file + ": others than you may read or write it; chmod 600 " + file
                    + "; if that changes nothing, move it to your home");
        }
        return TextFile.read(file);
    }

    /**
     * Makes a file. The text goes to no other one than that, whatever becomes of its name meanwhile.
     *
     * @throws FileAlreadyExistsException if there is something of this name.
     */
    public static void create(Path file, String text) throws IOException, JavinoException {
        Path folder = file.toAbsolutePath().getParent();
        if (folder != null && !Files.isDirectory(folder)) {
            throw new JavinoException(file + ": there is no folder " + folder);
        }
        try (FileChannel created = open(file, true)) {
            write(created, file, bytes(text));
        }
    }

    /** Makes a file, or replaces it as {@link #change} does. One program at a time may do so. */
    public static void replace(Path file, byte[] bytes) throws IOException {
        replace(file, bytes, true);
    }

    /** The same, of what is no secret, and is to be carried elsewhere, such as on a stick. */
    public static void replaceToCarry(Path file, String text) throws IOException {
        replace(file, bytes(text), false);
    }

    private static void replace(Path file, byte[] bytes, boolean isSecret) throws IOException {
        mustBeFile(file);
        Path fresh = file.resolveSibling(file.getFileName() + NEW);
        Files.deleteIfExists(fresh);
        try (FileChannel created = open(fresh, isSecret)) {
            write(created, fresh, bytes);
            move(fresh, file);
        }
    }

    /** Adds to a file, which is made if it is not there. The bytes added are not flushed. */
    public static void append(Path file, byte[] bytes) throws IOException {
        mustBeFile(file);
        boolean isThere = Files.exists(file, LinkOption.NOFOLLOW_LINKS);
        if (isThere && !isPrivate(file, LinkOption.NOFOLLOW_LINKS)) {
            Files.getFileAttributeView(file, PosixFileAttributeView.class, LinkOption.NOFOLLOW_LINKS)
                    .setPermissions(OF_A_FILE);
            mustBePrivate(file);
        }
        try (FileChannel channel = isThere ? FileChannel.open(file, StandardOpenOption.WRITE,
                StandardOpenOption.APPEND, LinkOption.NOFOLLOW_LINKS) : open(file, true)) {
            writeFully(channel, bytes);
        }
    }

    /** Makes a folder, and those that it is in, for its owner only, if it is not there. */
    public static void createFolder(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) {
            Files.createDirectories(folder, attributes(folder, OWNERS));
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
        for (int tries = 0; tries < TRIES; tries++) {
            if (CLAIMED.add(part)) {
                try (FileChannel claimed = claim(file, real, part)) {
                    if (claimed != null) {
                        return replace(real, part, claimed, change);
                    }
                } finally {
                    CLAIMED.remove(part);
                }
            }
            Thread.sleep(PAUSE_MILLIS);
        }
        throw new JavinoException(file + " is being changed by another program; if none runs, delete " + part);
    }

    private static String replace(Path real, Path part, FileChannel created, Change change)
            throws IOException, JavinoException {
        try {
            String text = change.apply(read(real));
            write(created, part, bytes(text));
            move(part, real);
            return text;
        } catch (IOException | JavinoException | RuntimeException e) {
            Files.deleteIfExists(part);
            throw e;
        }
    }

    /** Makes the file that is to be the new one, or takes over a left one; null while another program has it. */
    private static FileChannel claim(Path file, Path real, Path part) throws IOException, JavinoException {
        try {
            FileChannel created = create(part);
            // A part that another has taken over and put in place meanwhile has a text.
            FileChannel locked = lock(created, part, key(part), 0);
            return locked == null ? null : checked(locked, part);
        } catch (FileAlreadyExistsException e) {
            return takeOver(real, part);
        } catch (AccessDeniedException e) {
            throw new JavinoException(
                    file + " cannot be changed, but what boards and devices have must be noted in it; "
                            + "make its folder writable for you",
                    e);
        }
    }

    /** Takes over a part that nobody has locked: a program that has died left it, as at a loss of power. */
    private static FileChannel takeOver(Path real, Path part) throws IOException {
        try {
            if (!isPosix(part) || !Files.isRegularFile(part, LinkOption.NOFOLLOW_LINKS)
                    || !isPrivate(part, LinkOption.NOFOLLOW_LINKS)
                    || !Files.getOwner(part, LinkOption.NOFOLLOW_LINKS).equals(Files.getOwner(real))) {
                return null;
            }
            Object key = key(part);
            return lock(FileChannel.open(part, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS), part, key,
                    Long.MAX_VALUE);
        } catch (NoSuchFileException e) {
            return null;
        }
    }

    /** Locks and empties a file; closes it if another program has it, or had it when it was opened. */
    private static FileChannel lock(FileChannel opened, Path part, Object key, long mostBytes) throws IOException {
        boolean isLocked = false;
        try {
            isLocked = opened.tryLock() != null && opened.size() <= mostBytes && Objects.equals(key, key(part));
            return isLocked ? opened.truncate(0) : null;
        } catch (OverlappingFileLockException e) {
            return null;
        } finally {
            if (!isLocked) {
                opened.close();
            }
        }
    }

    /** A mark that tells a file from others that have had its name; equal to no other if there is none. */
    private static Object key(Path file) throws IOException {
        try {
            return Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS).fileKey();
        } catch (NoSuchFileException e) {
            return new Object();
        }
    }

    /** Makes an empty file for its owner, or none where others could read what is a secret. */
    private static FileChannel open(Path file, boolean isSecret) throws IOException {
        return isSecret ? checked(create(file), file) : create(file);
    }

    private static FileChannel create(Path file) throws IOException {
        return FileChannel.open(file, EnumSet.of(StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE),
                attributes(file, OF_A_FILE));
    }

    /** A new file, or none where others could read it. */
    private static FileChannel checked(FileChannel created, Path file) throws IOException {
        try {
            mustBePrivate(file);
            return created;
        } catch (IOException e) {
            created.close();
            Files.deleteIfExists(file);
            throw e;
        }
    }

    private static void mustBePrivate(Path file) throws IOException {
        if (!isPrivate(file, LinkOption.NOFOLLOW_LINKS)) {
            throw new FileSystemException(file.toString(), null, "others could read the secrets in it, as its "
                    + "permissions cannot be kept; choose a folder in your home");
        }
    }

    private static boolean isPrivate(Path file, LinkOption... options) throws IOException {
        return !isPosix(file) || OWNERS.containsAll(Files.getPosixFilePermissions(file, options));
    }

    private static void mustBeFile(Path file) throws IOException {
        if (Files.exists(file, LinkOption.NOFOLLOW_LINKS) && !Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
            throw new FileSystemException(file.toString(), null, "it is a link or no file; choose another path");
        }
    }

    private static boolean isPosix(Path file) {
        return file.getFileSystem().supportedFileAttributeViews().contains("posix");
    }

    private static FileAttribute<?>[] attributes(Path file, Set<PosixFilePermission> permissions) {
        return isPosix(file) ? new FileAttribute<?>[] {PosixFilePermissions.asFileAttribute(permissions)}
                : new FileAttribute<?>[0];
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    /** Writes a new file to the disk, or takes it back. */
    private static void write(FileChannel to, Path file, byte[] bytes) throws IOException {
        try {
            writeFully(to, bytes);
            to.force(true);
        } catch (IOException e) {
            Files.deleteIfExists(file);
            throw e;
        }
    }

    private static void writeFully(FileChannel to, byte[] bytes) throws IOException {
        ByteBuffer left = ByteBuffer.wrap(bytes);
        while (left.hasRemaining()) {
            to.write(left);
        }
    }

    private static void move(Path fresh, Path file) throws IOException {
        try {
            Files.move(fresh, file, StandardCopyOption.ATOMIC_MOVE);
        } catch (IOException e) {
            Files.deleteIfExists(fresh);
            throw e;
        }
    }
}
