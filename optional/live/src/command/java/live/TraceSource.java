package live;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javino.JavinoException;
import trace.MalformedEventException;
import trace.TraceReader;

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
        try {
            TraceReader.read(file, event -> hub.add(event.line()));
        } catch (MalformedEventException e) {
            throw new JavinoException(file + ":" + e.number()
                    + ": this is no event; name the trace of a run, such as build/trace.jsonl", e);
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
