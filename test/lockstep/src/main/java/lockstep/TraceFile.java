package lockstep;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;

/** The trace that an emulator writes, read as far as it goes. */
final class TraceFile implements AutoCloseable {

    private final InputStream trace;
    private final ByteArrayOutputStream line = new ByteArrayOutputStream();
    private final Consumer<String> lines;

    /** @param lines takes the lines of the file, which is there. */
    TraceFile(Path file, Consumer<String> lines) throws IOException {
        trace = new BufferedInputStream(Files.newInputStream(file));
        this.lines = lines;
    }

    /** Reads what is new. */
    void read() {
        try {
            for (int next = trace.read(); next >= 0; next = trace.read()) {
                if (next != '\n') {
                    line.write(next);
                    continue;
                }
                String whole = line.toString(StandardCharsets.UTF_8);
                line.reset();
                lines.accept(whole);
            }
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    @Override
    public void close() {
        try {
            trace.close();
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }
}
