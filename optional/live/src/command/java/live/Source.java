package live;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import javino.JavinoException;
import trace.TraceEvent;

/** A source of events, which puts them into the hub by itself. */
interface Source extends AutoCloseable {

    /** Told to the page: {@code run}, {@code trace} or {@code board}. */
    String kind();

    /** Whether events still come, so that the page follows them. */
    boolean isLive();

    /** Commands that {@link #command} takes here, by the name in {@code do}. */
    List<String> controls();

    /**
     * Has it do what a page asks.
     *
     * @param command its {@code do} is one of {@link #controls}.
     * @throws JavinoException if it does not; the message says why, in one line.
     */
    void command(JsonObject command) throws JavinoException;

    /** The log of which pages can ask why; nothing if there is none. */
    default Optional<Log> log() {
        return Optional.empty();
    }

    /** A run's log. */
    interface Log {

        /** All of its lines, in their order. */
        List<TraceEvent> events() throws IOException;
    }

    /** @param pages that show the events now. */
    default void watched(int pages) {
        // Most sources tell the same to nobody.
    }

    @Override
    void close();
}
