package live;

import com.google.gson.JsonObject;
import diffuser.report.Failure;
import java.io.IOException;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.SocketChannel;
import java.nio.file.Path;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import javino.JavinoException;
import javino.link.Time;

/**
 * The agents' end of their connection to the page's server: events go there, one a line, and commands come. The agents
 * never wait for it: what it does not take in time is left out, and counted.
 */
final class PageLink implements AutoCloseable {

    private static final int MOST_WAITING = 10_000;

    private final BlockingQueue<String> waiting = new ArrayBlockingQueue<>(MOST_WAITING);
    private final AtomicLong skipped = new AtomicLong();
    private final LineChannel server;
    private final Function<JsonObject, CompletableFuture<?>> perform;

    private PageLink(LineChannel server, Function<JsonObject, CompletableFuture<?>> perform) {
        this.server = server;
        this.perform = perform;
    }

    /**
     * Connects; {@link #read} begins to take commands.
     *
     * @param perform does what a command says; its future fails, or it throws, with the reason why it does not.
     * @throws IOException if nobody listens there.
     */
    static PageLink connect(Path socket, Function<JsonObject, CompletableFuture<?>> perform) throws IOException {
        SocketChannel channel = SocketChannel.open(UnixDomainSocketAddress.of(socket));
        PageLink link = new PageLink(new LineChannel(channel), perform);
        Time.REAL.thread("events for the page", link::write).start();
        return link;
    }

    /** Does the first command, which says whether what agents decide is wanted, and then those that come. */
    void read() throws IOException {
        JsonObject first = next();
        if (first == null) {
            throw new IOException("the connection has ended");
        }
        answer(first);
        Time.REAL.thread("commands of the page", this::readAll).start();
    }

    private JsonObject next() throws IOException {
        String line = server.next();
        try {
            return line == null ? null : Events.object(line);
        } catch (JavinoException e) {
            throw new IOException(e);
        }
    }

    /** Tells an event, or counts it as left out. */
    void tell(String event) {
        if (!waiting.offer(event)) {
            skipped.incrementAndGet();
        }
    }

    private void write() {
        try {
            while (true) {
                String next = waiting.take();
                long lost = skipped.getAndSet(0);
                if (lost > 0) {
                    server.send(Events.json("event", "skipped", "count", lost));
                }
                server.send(next);
            }
        } catch (IOException serverHasEnded) {
            // The agents go on.
            return;
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
        }
    }

    private void readAll() {
        try {
            for (JsonObject command = next(); command != null; command = next()) {
                answer(command);
            }
        } catch (IOException serverHasEnded) {
            // The agents go on.
            return;
        }
    }

    private void answer(JsonObject command) {
        CompletableFuture<?> done;
        try {
            done = perform.apply(command);
        } catch (RuntimeException e) {
            done = CompletableFuture.failedFuture(e);
        }
        if (!command.has("id")) {
            return;
        }
        done.whenComplete((result, thrown) -> tell(thrown == null ? Events.json("answer", command.get("id"))
                : Events.json("answer", command.get("id"), "error", Events.shortened(Failure.of(thrown).message()))));
    }

    @Override
    public void close() throws IOException {
        server.close();
    }
}
