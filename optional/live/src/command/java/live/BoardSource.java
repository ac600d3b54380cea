package live;

import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import javino.JavinoException;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.Transmission;
import javino.board.ReceivedMessage;
import javino.link.LinkOpener;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Content;
import javino.protocol.Counter;
import javino.protocol.Outcome;

/** One board without any agent. Its radio is open meanwhile: this takes the messages. */
final class BoardSource implements Source, BoardListener {

    private static final long SECONDS_TO_ANSWER = 15;
    private static final double NANOS_A_MILLI = 1e6;
    private static final double MILLIS_A_SECOND = 1000;

    private final Hub hub;
    private final String name;
    private final long start = System.nanoTime();
    private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor(task -> {
        Thread thread = new Thread(task, "counters");
        thread.setDaemon(true);
        return thread;
    });
    private volatile Board board;
    private CompletableFuture<?> counting = CompletableFuture.completedFuture(null);
    private Map<String, Long> counted = Map.of();
    private String airtime = "";

    private BoardSource(Hub hub, String name) {
        this.hub = hub;
        this.name = name;
    }

    /**
     * Begins a session with the board.
     *
     * @throws JavinoException if the port cannot be opened, or no board answers there.
     */
    static BoardSource open(LinkOpener link, BoardConfig config, Hub hub) throws JavinoException, InterruptedException {
        String port = link.name();
        BoardSource source = new BoardSource(hub, port.substring(port.lastIndexOf('/') + 1));
        source.board = Board.open(link, config, source);
        try {
            result(source.board.greeted());
        } catch (JavinoException | InterruptedException e) {
            source.close();
            throw e;
        }
        source.board.percepts(true);
        // The rest of a board without a radio for us can be watched.
        source.board.radio(true);
        source.clock.scheduleAtFixedRate(source::count, 0, 1, TimeUnit.SECONDS);
        return source;
    }

    private void count() {
        if (counting.isDone()) {
            counting = board.statistics().thenAccept(this::counters);
        }
    }

    private synchronized void counters(Map<Counter, Long> counters) {
        Map<String, Long> now = Counters.told(counters);
        String sent = board.airtime().map(Object::toString).orElse("");
        if (!now.equals(counted) || !sent.equals(airtime)) {
            counted = now;
            airtime = sent;
            tell("counters-of-board", "counters", now, "airtime", sent);
        }
    }

    @Override
    public synchronized void online(BoardInfo info) {
        counted = Map.of();
        tell("board", "online", true, "address", info.rfId().map(Object::toString).orElse(""), "firmware",
                info.firmware(), "radio", info.hasRadio(), "actions", info.actions());
    }

    @Override
    public void offline(String why) {
        tell("board", "online", false, "why", why);
        percepts(List.of());
    }

    @Override
    public void percepts(List<String> literals) {
        tell("percepts", "percepts", literals);
    }

    @Override
    public void message(ReceivedMessage message) {
        tell("message", "from", message.from().toString(), "to", message.to().toString(), "performative",
                message.content().performative().toString(), "text", message.content().term());
    }

    @Override
    public void warning(String what) {
        tell("warned", "text", what);
    }

    @Override
    public void printed(String text) {
        tell("printed", "text", Events.shortened(text));
    }

    private void tell(String event, Object... namesAndValues) {
        double seconds = Math.round((System.nanoTime() - start) / NANOS_A_MILLI) / MILLIS_A_SECOND;
        List<Object> all = new ArrayList<>(List.of("t", seconds, "board", name, "event", event));
        all.addAll(List.of(namesAndValues));
        hub.add(Events.json(all.toArray()));
    }

    @Override
    public String kind() {
        return "board";
    }

    @Override
    public boolean isLive() {
        return true;
    }

    @Override
    public List<String> controls() {
        return List.of("act", "say");
    }

    @Override
    public void command(JsonObject command) throws JavinoException {
        try {
            if (Events.text(command, "do").equals("say")) {
                say(command);
            } else {
                act(Events.text(command, "action"));
            }
        } catch (IllegalArgumentException e) {
            throw new JavinoException(e.getMessage(), e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new JavinoException("the page's server is ending", e);
        }
    }

    private void act(String action) throws JavinoException, InterruptedException {
        try {
            result(board.act(action));
            tell("acted", "action", action, "ok", true);
        } catch (JavinoException | IllegalArgumentException e) {
            tell("acted", "action", action, "error", e.getMessage());
            throw e;
        }
    }

    private void say(JsonObject command) throws JavinoException, InterruptedException {
        Address to = Address.parse(Events.text(command, "to"));
        Transmission message = board.transmit(to, Content.parse(
                Events.text(command, "performative") + ";" + Events.text(command, "content")));
        result(message.taken());
        // Only a single device acknowledges.
        if (to.kind() == Address.Kind.DEVICE && result(message.end()) == Outcome.UNDELIVERED) {
            throw new JavinoException(to + " has not acknowledged it");
        }
    }

    private static <T> T result(CompletableFuture<T> future) throws JavinoException, InterruptedException {
        try {
            return future.get(SECONDS_TO_ANSWER, TimeUnit.SECONDS);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof JavinoException cause) {
                throw cause;
            }
            throw new IllegalStateException(e.getCause());
        } catch (TimeoutException e) {
            throw new JavinoException("the board did not answer within " + SECONDS_TO_ANSWER + " s", e);
        }
    }

    /** Blocks the radio, so that no message waits for a program that has ended. */
    @Override
    public void close() {
        clock.shutdownNow();
        board.radio(false).exceptionally(thrown -> null).completeOnTimeout(null, 1, TimeUnit.SECONDS).join();
        board.close();
    }
}
