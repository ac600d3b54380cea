package live;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The events of a source, kept once for all pages. Each page has its own place among them, so that a slow one costs the
 * source nothing.
 */
final class Hub {

    /** The first ones stay for ever, as long as they are not too long: they say what there is. */
    static final int FIRST_KEPT = 1000;
    private static final long MOST_FIRST_CHARACTERS = 16L << 20;
    private static final int MOST_KEPT = 200_000;
    /** So that long events do not fill the memory. */
    private static final long MOST_CHARACTERS = 128L << 20;
    /** A page that was up to date, and then is so far behind, is shown the newest ones instead of all. */
    static final int FAR_BEHIND = 20_000;
    private static final int NEWEST = 1000;

    private final String[] ring;
    private final List<String> head = new ArrayList<>();
    private long oldest = FIRST_KEPT;
    private long next;
    private long characters;
    private PrintStream record = new PrintStream(OutputStream.nullOutputStream());
    private boolean recorded;

    /**
     * Events for a page.
     *
     * @param events  in their order.
     * @param next    the page's place after them: the number of the event that follows.
     * @param skipped how many were left out before them.
     * @param all     whether none is left for this page at present.
     */
    record Batch(List<String> events, long next, long skipped, boolean all) {
    }

    Hub() {
        this(MOST_KEPT);
    }

    /** Writes each event from now on to a file, too, which the page can play later. */
    synchronized void record(Path file) throws IOException {
        record = new PrintStream(Files.newOutputStream(file), true, StandardCharsets.UTF_8);
        recorded = true;
    }

    /** Whether there is such a file. */
    synchronized boolean isRecorded() {
        return recorded;
    }

    /** Writes a line to the file only. */
    synchronized void note(String line) {
        record.println(line);
    }

    /** @param kept how many events are kept beside the first ones. */
    Hub(int kept) {
        ring = new String[kept];
    }

    /** Takes an event: a JSON object in one line. */
    synchronized void add(String event) {
        record.println(event);
        characters += event.length();
        if (next == head.size() && next < FIRST_KEPT && characters <= MOST_FIRST_CHARACTERS) {
            head.add(event);
        } else {
            if (next == head.size()) {
                oldest = next;
            } else if (next - oldest == ring.length) {
                dropOldest();
            }
            ring[slot(next)] = event;
        }
        next++;
        while (characters > MOST_CHARACTERS) {
            dropOldest();
        }
    }

    private void dropOldest() {
        characters -= ring[slot(oldest)].length();
        ring[slot(oldest)] = null;
        oldest++;
    }

    /**
     * The events that follow a page's place.
     *
     * @param place    the number of the first event that the page has not got yet.
     * @param most     events.
     * @param upToDate whether the page had all events once.
     */
    synchronized Batch after(long place, int most, boolean upToDate) {
        long from = Math.max(0, Math.min(place, next));
        long start = from;
        if (upToDate && next - from > FAR_BEHIND) {
            start = next - NEWEST;
        }
        if (start >= head.size()) {
            start = Math.max(start, Math.min(oldest, next));
        }
        List<String> events = new ArrayList<>();
        long end = start;
        for (; end < next && events.size() < most; end++) {
            if (end == head.size() && end < oldest) {
                break;
            }
            events.add(end < head.size() ? head.get((int) end) : ring[slot(end)]);
        }
        return new Batch(events, end, start - from, end == next);
    }

    private int slot(long number) {
        return (int) (number % ring.length);
    }
}
