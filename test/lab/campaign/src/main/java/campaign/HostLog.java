package campaign;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;

/** Lines that survive the process that wrote them: each is with the operating system when {@link #write} returns. */
final class HostLog {

    private static final String RUN = "run";

    private final Path file;

    HostLog(Path file) {
        this.file = file;
    }

    /** Begins a run; says how many there were before. */
    int begin() throws IOException {
        int before = Files.exists(file) ? (int) lines().stream().filter(RUN::equals).count() : 0;
        write(RUN);
        return before;
    }

    synchronized void write(String line) {
        try {
            Files.writeString(file, line.replace('\n', ' ') + "\n", StandardOpenOption.CREATE,
                    StandardOpenOption.APPEND);
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    /** All lines of all runs. */
    List<String> lines() throws IOException {
        return Files.readAllLines(file);
    }

    /** Whether a line begins another run. */
    static boolean isRun(String line) {
        return line.equals(RUN);
    }
}
