package live;

import io.javalin.http.Context;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.IntConsumer;
import java.util.regex.Pattern;

/**
 * Sends the hub's events to pages, each on the thread of its request: a page that does not read stops nobody else.
 */
final class EventStreams implements AutoCloseable {

    static final int MOST_PAGES = 32;
    private static final int MOST_EVENTS_A_BATCH = 1000;
    private static final int MILLIS_FROM_BATCH_TO_BATCH = 50;
    /** A page that is gone is noticed when something is sent to it: so something is. */
    private static final int BATCHES_OF_SILENCE = 200;

    /** Frequent events that a page does not show: each would wake it. */
    private static final Pattern UNSEEN =
            Pattern.compile("\"event\":\"(point|eeprom|transition|host-(nothing|taking|taken|relay|outcome))\"");

    private final Hub hub;
    private final IntConsumer watched;
    private int pages;
    private volatile boolean closed;

    /** @param watched is told how many pages there are, when that changes. */
    EventStreams(Hub hub, IntConsumer watched) {
        this.hub = hub;
        this.watched = watched;
    }

    /** One page more or less: whether there was room for it. */
    private synchronized boolean changed(int by) {
        if (pages + by > MOST_PAGES) {
            return false;
        }
        pages += by;
        watched.accept(pages);
        return true;
    }

    /**
     * Sends events to a page until it is gone.
     *
     * @param place the number of the first one.
     * @return whether there was room for one more page.
     */
    boolean serve(Context request, long place) throws InterruptedException, IOException {
        if (!changed(1)) {
            return false;
        }
        try {
            request.res().setContentType("text/event-stream;charset=utf-8");
            send(request.res().getOutputStream(), place);
        } catch (IOException e) {
            // The page is gone.
            return true;
        } finally {
            changed(-1);
        }
        return true;
    }

    private void send(OutputStream out, long first) throws IOException, InterruptedException {
        write(out, ":\n\n");
        long place = first;
        boolean upToDate = false;
        for (int silent = 0; !closed; silent++) {
            Hub.Batch batch = hub.after(place, MOST_EVENTS_A_BATCH, upToDate);
            List<String> seen = batch.events().stream().filter(event -> !UNSEEN.matcher(event).find()).toList();
            if (!seen.isEmpty() || batch.skipped() > 0) {
                write(out, message(batch, seen));
                silent = 0;
            } else if (silent == BATCHES_OF_SILENCE) {
                write(out, ":\n\n");
                silent = 0;
            }
            place = batch.next();
            // Earlier events are sent to a new page without pauses, so that it soon shows the present.
            upToDate |= batch.all();
            if (upToDate) {
                Thread.sleep(MILLIS_FROM_BATCH_TO_BATCH);
            }
        }
    }

    private static String message(Hub.Batch batch, List<String> events) {
        String skipped = batch.skipped() == 0 ? ""
                : Events.json("event", "skipped", "count", batch.skipped())
                        + (events.isEmpty() ? "" : ",");
        return "id: " + batch.next() + "\ndata: [" + skipped + String.join(",", events) + "]\n\n";
    }

    private static void write(OutputStream out, String text) throws IOException {
        out.write(text.getBytes(StandardCharsets.UTF_8));
        out.flush();
    }

    @Override
    public void close() {
        closed = true;
    }
}
