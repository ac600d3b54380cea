package live;

import com.google.gson.JsonObject;
import java.util.List;
import javino.JavinoException;

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

    @Override
    void close();
}
