package mobility;

import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.time.InstantSource;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Properties;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import javino.keyring.PrivateFile;
import javino.protocol.Address;
import javino.protocol.Bytes;

/**
 * The folder with the records of a MAS's moves and the texts of the agents (SPEC 9.3), for its user only. A method's
 * changes are on the disk when it returns, so that a computer that loses power goes on from there.
 *
 * <p>All methods throw {@link UncheckedIOException} where the disk fails.
 */
class MoveStore implements AutoCloseable {

    private static final String RECORD = ".move";
    private static final String PARTIAL = ".part";
    private static final String BOARD = "board";
    private static final String PORT = "port";
    private static final String ADDRESS = "address";
    /** Texts that no record names are kept for visits to come, so many. */
    private static final int MOST_SPARE = 64;

    private final Path place;
    private final InstantSource clock;
    private final FileChannel lock;

    /** An operation on the disk. */
    private interface Access<T> {
        T run() throws IOException;
    }

    private static <T> T on(Access<T> disk) {
        try {
            return disk.run();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Opens a folder, which is made if it is not there; fails too if another MAS has it.
     *
     * @param clock by which texts get older.
     */
    MoveStore(Path place, InstantSource clock) {
        this.place = place;
        this.clock = clock;
        lock = on(() -> {
            PrivateFile.createFolder(place.resolve("parts"));
            FileChannel channel =
                    FileChannel.open(place.resolve("lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
            if (!isOurs(channel)) {
                channel.close();
                throw new IOException("the folder " + place.toAbsolutePath()
                        + " is used by another agent; give each agent with a board its own, as in [moves(\"folder\")]");
            }
            return channel;
        });
    }

    private static boolean isOurs(FileChannel lock) throws IOException {
        try {
            return lock.tryLock() != null;
        } catch (OverlappingFileLockException e) {
            // Another agent of this program has it.
            return false;
        }
    }

    /** The records that are there; none if the folder is not there. Those of {@link #unreadable} are left out. */
    static List<Move> records(Path place) {
        return files(place).stream().flatMap(file -> read(file).stream()).toList();
    }

    List<Move> records() {
        return records(place);
    }

    /** The names of files that should be records, and are damaged. */
    static List<String> unreadable(Path place) {
        return files(place).stream().filter(file -> read(file).isEmpty()).map(file -> file.getFileName().toString())
                .toList();
    }

    List<String> unreadable() {
        return unreadable(place);
    }

    private static List<Path> files(Path place) {
        return Files.isDirectory(place) ? list(place).filter(each -> each.toString().endsWith(RECORD)).sorted().toList()
                : List.of();
    }

    private static Stream<Path> list(Path place) {
        try (Stream<Path> files = on(() -> Files.list(place))) {
            return files.toList().stream();
        }
    }

    private static Optional<Move> read(Path file) {
        return on(() -> {
            try {
                String name = file.getFileName().toString();
                return Optional.of(Move.of(name.substring(0, name.length() - RECORD.length()), load(file)));
            } catch (IllegalArgumentException | CharacterCodingException e) {
                return Optional.empty();
            }
        });
    }

    /** Whether there is a record of a move, readable or not. */
    boolean hasRecord(Move.Key key) {
        return Files.exists(place.resolve(key + RECORD));
    }

    /** Writes a record, in the place of the one before of that move. */
    void write(Move move) {
        store(move.properties(), place.resolve(move.key() + RECORD));
    }

    private static void store(Properties properties, Path file) {
        StringWriter text = new StringWriter();
        on(() -> {
            properties.store(text, null);
            return replace(file, text.toString().getBytes(StandardCharsets.UTF_8));
        });
    }

    private static Properties load(Path file) throws IOException {
        Properties properties = new Properties();
        try (var reader = Files.newBufferedReader(file)) {
            properties.load(reader);
        }
        return properties;
    }

    /** Deletes the record of a move, if there is one. */
    void delete(Move.Key key) {
        on(() -> Files.deleteIfExists(place.resolve(key + RECORD)) ? flush(place) : place);
    }

    /** Keeps by which board the moves go, for an agent that leaves its own board behind. */
    void keepBoard(String port, Address address) {
        Properties board = new Properties();
        board.setProperty(PORT, port);
        board.setProperty(ADDRESS, address.toString());
        store(board, place.resolve(BOARD));
    }

    /** Whether there is what {@link #keepBoard} has kept. */
    static boolean hasBoard(Path place) {
        return Files.exists(place.resolve(BOARD));
    }

    /** Does something with the port and the address of {@link #keepBoard}, if there are any. */
    void board(BiConsumer<String, Address> step) {
        if (hasBoard(place)) {
            Properties board = on(() -> load(place.resolve(BOARD)));
            step.accept(board.getProperty(PORT), Address.parse(board.getProperty(ADDRESS)));
        }
    }

    /** The text of a hash, if it is here and undamaged. */
    Optional<Bytes> text(Bytes hash) {
        return bytes(part(hash)).filter(text -> Part.hash(text).equals(hash));
    }

    private static Optional<Bytes> bytes(Path file) {
        return Files.exists(file) ? Optional.of(Bytes.copyOf(on(() -> Files.readAllBytes(file)))) : Optional.empty();
    }

    /** Keeps a text. */
    void keep(Bytes hash, Bytes text) {
        on(() -> {
            if (text(hash).isEmpty()) {
                replace(part(hash), text.toArray());
            }
            Files.setLastModifiedTime(part(hash), FileTime.from(clock.instant()));
            return Files.deleteIfExists(partial(hash));
        });
    }

    /** How many packed bytes of a part are here. */
    int here(Part part) {
        Path partial = partial(part.hash());
        return Files.exists(part(part.hash())) ? part.packed()
                : Files.exists(partial) ? on(() -> (int) Files.size(partial)) : 0;
    }

    /** The text of a part that is here as a whole. @throws RefusedException if it is damaged, and here no longer. */
    Bytes whole(Part part) throws RefusedException {
        try {
            Optional<Bytes> text = text(part.hash());
            return text.isPresent() ? text.get() : part.unpack(bytes(partial(part.hash())).orElse(Bytes.EMPTY));
        } catch (RefusedException e) {
            forget(part.hash());
            throw e;
        }
    }

    /** Adds packed bytes to a part. They are not flushed: what is lost comes again, and the hash tells a fault. */
    void append(Bytes hash, Bytes packed) {
        on(() -> {
            PrivateFile.append(partial(hash), packed.toArray());
            return partial(hash);
        });
    }

    /** Forgets the packed bytes of a part, and its text if that is damaged. */
    void forget(Bytes hash) {
        on(() -> Files.deleteIfExists(partial(hash)) | text(hash).isEmpty() && Files.deleteIfExists(part(hash)));
    }

    /** Deletes the oldest of those texts that no record names, where there are too many. */
    void tidy() {
        Set<String> needed = records().stream().flatMap(move -> move.parts().stream()).map(Bytes::hex)
                .collect(Collectors.toSet());
        list(place.resolve("parts"))
                .filter(file -> !needed.contains(file.getFileName().toString().replaceFirst("[.].*", "")))
                .sorted(Comparator.comparingLong((Path file) -> file.toFile().lastModified()).reversed())
                .skip(MOST_SPARE).forEach(file -> on(() -> Files.deleteIfExists(file)));
    }

    private Path part(Bytes hash) {
        return place.resolve("parts").resolve(hash.hex());
    }

    private Path partial(Bytes hash) {
        return place.resolve("parts").resolve(hash.hex() + PARTIAL);
    }

    private static Path replace(Path file, byte[] bytes) throws IOException {
        PrivateFile.replace(file, bytes);
        return flush(file.getParent());
    }

    /** So that the file's name is on the disk, too; Windows has no such call. */
    private static Path flush(Path directory) throws IOException {
        try (FileChannel channel = FileChannel.open(directory, StandardOpenOption.READ)) {
            channel.force(true);
        } catch (AccessDeniedException e) {
            return directory;
        }
        return directory;
    }

    @Override
    public void close() {
        on(() -> {
            lock.close();
            return lock;
        });
    }
}
