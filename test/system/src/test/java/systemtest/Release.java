package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The files that {@code gradle release} has made. */
final class Release {

    static final Path FOLDER = Path.of(System.getProperty("javino.root"), "build/release");

    private Release() {}

    /**
     * The file of the release that begins and ends so.
     *
     * @throws IOException if there is not exactly one.
     */
    static Path file(String start, String end) throws IOException {
        try (Stream<Path> all = Files.list(FOLDER)) {
            List<Path> found =
                    all.filter(file -> file.getFileName().toString().matches(start + "[0-9.]+" + end)).toList();
            if (found.size() != 1) {
                throw new IOException(FOLDER + " has " + found + ", not one " + start + "…" + end);
            }
            return found.get(0);
        }
    }

    /** Unpacks the archives of command and emulator, and returns the folder that both come into. */
    static Path unpack(Path folder) throws Exception {
        run("tar", "-C", folder.toString(), "-xf", file("javino-", "\\.tar\\.gz").toString());
        run("tar", "-C", folder.toString(), "-xf", file("javino-emulator-", "-linux-.*\\.tar\\.gz").toString());
        try (Stream<Path> made = Files.list(folder)) {
            List<Path> folders = made.toList();
            assertEquals(1, folders.size(), folders.toString());
            return folders.get(0);
        }
    }

    static void run(String... command) throws Exception {
        assertEquals(0, new ProcessBuilder(command).inheritIO().start().waitFor(), String.join(" ", command));
    }
}
