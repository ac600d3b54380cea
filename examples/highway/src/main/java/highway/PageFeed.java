package highway;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.atomic.AtomicLong;

/** Brings events to the page's server. The run never waits for it: what it does not take in time is left out. */
final class PageFeed {

    private static final int MOST_WAITING = 10_000;

    /** An event's time, for what is said of those before it. */
    private record Timed(double seconds, String event) {}

    private final BlockingQueue<Timed> waiting = new ArrayBlockingQueue<>(MOST_WAITING);
    private final AtomicLong skipped = new AtomicLong();

    PageFeed(OutputStream server) {
        Thread writer = new Thread(() -> write(server), "page");
        writer.setDaemon(true);
        writer.start();
    }

    /** Takes an event, or counts it as skipped. */
    void add(double seconds, String event) {
        if (!waiting.offer(new Timed(seconds, event))) {
            skipped.incrementAndGet();
        }
    }

    private void write(OutputStream server) {
        try (PrintStream out = new PrintStream(server, true, StandardCharsets.UTF_8)) {
            while (!out.checkError()) {
                Timed next = waiting.take();
                long lost = skipped.getAndSet(0);
                if (lost > 0) {
                    out.println("{\"t\":" + next.seconds() + ",\"event\":\"skipped\",\"count\":" + lost + "}");
                }
                out.println(next.event());
            }
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
        }
    }
}
