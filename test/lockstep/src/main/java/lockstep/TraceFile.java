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

/** The trace that a simulation's emulator writes, read as far as it goes whenever the emulator has done something. */
public final class TraceFile implements AutoCloseable {

    private final InputStream trace;
    private final ByteArrayOutputStream line = new ByteArrayOutputStream();
    private final Consumer<String> lines;

    private TraceFile(InputStream trace, Consumer<String> lines) {
        this.trace = trace;
        this.lines = lines;
    }

    /**
     * Follows a file, which is there.
     *
     * @param lines takes its lines, on the coordinator.
     */
    public static TraceFile follow(Simulation simulation, Path file, Consumer<String> lines) throws IOException {
        TraceFile followed = new TraceFile(new BufferedInputStream(Files.newInputStream(file)), lines);
        simulation.watch(followed::read);
        return followed;
    }

    /** Reads what is new. */
    public void read() {
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
