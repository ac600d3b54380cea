package trace;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;

/** Reads traces; empty lines count only as lines. */
public final class TraceReader {

    private TraceReader() {
    }

    /**
     * Reads a stream to its end.
     *
     * @param others takes each line that is no event; it may throw what it is given.
     */
    public static void read(InputStream in, Consumer<TraceEvent> events, Consumer<MalformedEventException> others)
            throws IOException {
        try (BoundedLines lines = new BoundedLines(in)) {
            int number = 1;
            for (String line = lines.next(); line != null; line = lines.next(), number++) {
                TraceEvent event = null;
                try {
                    event = line.isBlank() ? null : TraceEvent.parse(number, line);
                } catch (MalformedEventException none) {
                    others.accept(none);
                }
                if (event != null) {
                    events.accept(event);
                }
            }
        }
    }

    /**
     * Reads a file to its end.
     *
     * @throws MalformedEventException if it has a line that is no event.
     * @throws FileSystemException     if it is a folder, or has no event at all.
     */
    public static void read(Path file, Consumer<TraceEvent> events) throws IOException {
        if (Files.isDirectory(file)) {
            throw new FileSystemException(file.toString(), null, "it is a folder, not a file");
        }
        AtomicBoolean any = new AtomicBoolean();
        read(Files.newInputStream(file), event -> {
            any.setPlain(true);
            events.accept(event);
        }, none -> {
            throw none;
        });
        if (!any.getPlain()) {
            throw new FileSystemException(file.toString(), null,
                    "it has no event; name the trace of a run, such as build/trace.jsonl");
        }
    }

    /** All events of a file, as {@link #read}. */
    public static List<TraceEvent> all(Path file) throws IOException {
        List<TraceEvent> events = new ArrayList<>();
        read(file, events::add);
        return events;
    }
}
