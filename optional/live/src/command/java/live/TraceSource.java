package live;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javino.JavinoException;
import trace.MalformedEventException;
import trace.TraceReader;

/** A trace file, which the page plays. */
final class TraceSource implements Source {

    private final Path file;

    private TraceSource(Path file) {
        this.file = file;
    }

    /**
     * Reads a file to its end.
     *
     * @throws JavinoException if it has a line that is no event.
     */
    static TraceSource read(Path file, Hub hub) throws IOException, JavinoException {
        try {
            TraceReader.read(file, event -> {
                // Pages do not need what agents decided: the server answers questions.
                if (!event.name().startsWith("agent-")) {
                    hub.add(event.line());
                }
            });
        } catch (MalformedEventException e) {
            throw new JavinoException(file + ":" + e.number()
                    + ": this is no event; name the trace of a run, such as build/trace.jsonl", e);
        }
        return new TraceSource(file);
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

    /** {@inheritDoc} The file is read again: it may be longer than what the memory has room for. */
    @Override
    public Optional<Log> log() {
        return Optional.of(() -> TraceReader.all(file));
    }

    @Override
    public void close() {
        // All was read.
    }
}
