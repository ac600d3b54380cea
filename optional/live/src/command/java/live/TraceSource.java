package live;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javino.JavinoException;

/** A trace file, which the page plays. */
final class TraceSource implements Source {

    private TraceSource() {
    }

    /**
     * Reads a file to its end.
     *
     * @throws JavinoException if it has a line that is no event.
     */
    static TraceSource read(Path file, Hub hub) throws IOException, JavinoException {
        try (BoundedLines lines = new BoundedLines(Files.newInputStream(file))) {
            long number = 1;
            for (String line = lines.next(); line != null; line = lines.next(), number++) {
                if (line.isBlank()) {
                    continue;
                }
                if (!Events.isEvent(line)) {
                    throw new JavinoException(file + ":" + number
                            + ": this is no event; name the trace of a run, such as build/trace.jsonl");
                }
                hub.add(line);
            }
        }
        return new TraceSource();
    }

    @Override
    public String kind() {
        return "trace";
    }

    @Override
    public boolean isLive() {
        return false;
    }

    @Override
    public List<String> controls() {
        return List.of();
    }

    @Override
    public void command(JsonObject command) throws JavinoException {
        throw new JavinoException("a trace takes no commands");
    }

    @Override
    public void close() {
        // All was read.
    }
}
