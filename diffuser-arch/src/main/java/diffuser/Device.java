package diffuser;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

import jason.asSyntax.Literal;
import jason.asSyntax.Term;

import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.ReceivedMessage;
import javino.board.Transmission;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Content;
import javino.protocol.Counter;
import javino.protocol.Outcome;

/**
 * The board on one port, as one agent sees it. What happens at the board is put, on the session's thread, where the
 * agent finds it in its next cycle; then the agent is woken.
 */
final class Device implements BoardListener {

    /** Longer than a session waits and repeats, so that it ends only what the session itself has lost. */
    private static final long ANSWER_SECONDS = 10;
    /** Until sensors that are held are read by themselves. */
    private static final Duration NEVER = Duration.ofDays(36_500);

    private final ExclusivePort link;
    private final String port;
    private final Surroundings surroundings;
    private final Percepts percepts;
    private final Communicability communicability;
    private final CompletableFuture<Board> session = new CompletableFuture<>();
    private final CompletableFuture<Void> decided = new CompletableFuture<>();
    private volatile BoardSettings settings;
    private volatile boolean online;
    private volatile boolean legacy;
    /** What the sketch has named, when it was greeted last; null before the first time. */
    private volatile Set<String> actions;
    private volatile Optional<Address> address = Optional.empty();
    private volatile boolean closed;

    /**
     * The agent around a device.
     *
     * @param agent    its name.
     * @param inbox    where its messages go.
     * @param warnings where its user is told what went wrong.
     * @param wake     ends its sleep.
     */
    record Surroundings(String agent, Inbox inbox, Warnings warnings, Runnable wake) {
    }

    private Device(ExclusivePort link, Term term, BoardSettings settings, Surroundings surroundings) {
        this.link = link;
        this.port = link.name();
        this.settings = settings;
        this.surroundings = surroundings;
        this.percepts = new Percepts(term, settings.percepts(), surroundings.warnings());
        this.communicability = new Communicability(this::packetsReceived, this::tellAgent, surroundings.warnings());
    }

    /**
     * Starts to look for a board, and returns at once.
     *
     * @param port as beliefs name it.
     */
    static Device open(ExclusivePort link, Term port, BoardConfig config, BoardSettings settings,
            Surroundings surroundings) {
        Device device = new Device(link, port, settings, surroundings);
        Board board = Board.open(link, config, device);
        device.session.complete(board);
        device.apply(settings);
        // First in the board's queue, so that the agent's first message finds the address set.
        settings.rfId().ifPresent(device::setRfId);
        if (settings.radio()) {
            device.radio(true);
        }
        return device;
    }

    /** Completes as soon as it is known whether a board is there, or nobody cares any more; never fails. */
    CompletableFuture<Void> decided() {
        return decided;
    }

    /** The port as the agent's program names it. */
    String port() {
        return port;
    }

    /** Whether the board is there. */
    boolean isOnline() {
        return online;
    }

    /** The address that the board has or is to have, as far as is known. */
    Optional<Address> address() {
        return settings.rfId().or(() -> address);
    }

    /** Whether the board speaks the older protocol, as far as is known: then it has actions for {@code .act} only. */
    boolean isLegacy() {
        return legacy;
    }

    /** Whether an action of that name is the board's; one that speaks the older protocol cannot say, so any may be. */
    boolean performs(String action) {
        return legacy || hasAction(action);
    }

    /** Whether agents can communicate by the board's radio. */
    boolean communicates() {
        return communicability.isUsable();
    }

    /** All that the board lets the agent perceive now; another state is another list. */
    List<Literal> perceived() {
        return percepts.snapshot();
    }

    /** How many percepts were left out as malformed. */
    long malformedPercepts() {
        return percepts.malformed();
    }

    /** Whether a board was here ever. */
    boolean isKnown() {
        return actions != null;
    }

    /** Whether the sketch of the board that is here, or was here last, has named an action so. */
    boolean hasAction(String name) {
        return actions != null && actions.contains(name);
    }

    /** Has the board do as wished, now and whenever it comes back; {@link #setRfId} and {@link #radio} add when. */
    void apply(BoardSettings wanted) {
        settings = wanted;
        Board board = session.join();
        percepts.sensing(wanted.percepts(), wanted.filters());
        board.perceptInterval(wanted.percepts() == SensorMode.HELD ? NEVER : wanted.limit());
        board.percepts(wanted.percepts() != SensorMode.BLOCKED);
        communicability.silence(wanted.silence());
    }

    /** Sets the board's address. */
    CompletableFuture<Void> setRfId(Address id) {
        return bounded(session.join().setRfId(id).thenRun(communicability::addressed));
    }

    /** Opens or blocks the radio. */
    CompletableFuture<Void> radio(boolean open) {
        return bounded(session.join().radio(open).thenRun(() -> communicability.radio(open)));
    }

    /** Has the board perform an action. */
    CompletableFuture<Void> act(String action) {
        return bounded(session.join().act(action));
    }

    /** Completes when the sensors were read anew, or will not be read so soon; never fails. */
    CompletableFuture<Void> reading(Duration within) {
        return session.thenCompose(board -> board.reading(within));
    }

    /** Has the board transmit. */
    Transmission transmit(Address to, Content content) {
        Transmission begun = session.join().transmit(to, content);
        return new Transmission(bounded(begun.taken()), begun.end().thenApply(this::ended));
    }

    private Outcome ended(Outcome outcome) {
        if (outcome == Outcome.DELIVERED) {
            communicability.heard();
        }
        return outcome;
    }

    /**
     * Ends the session without waiting for it; nothing comes from this device any more.
     *
     * @return completes when the port is free for another.
     */
    CompletableFuture<Void> close() {
        closed = true;
        communicability.close();
        decided.complete(null);
        return session.join().end().whenComplete((done, thrown) -> link.leave());
    }

    /** Asks for the board's counters. */
    CompletableFuture<Map<Counter, Long>> counters() {
        return session.thenCompose(Board::statistics);
    }

    private CompletableFuture<Long> packetsReceived() {
        return counters().thenApply(counts -> Objects
                .requireNonNull(counts.get(Counter.RADIO_RECEIVED), "the board does not count what it hears"));
    }

    private static <T> CompletableFuture<T> bounded(CompletableFuture<T> answer) {
        return answer.copy().orTimeout(ANSWER_SECONDS, TimeUnit.SECONDS);
    }

    // On the session's thread:

    @Override
    public void online(BoardInfo info) {
        if (closed) {
            return;
        }
        legacy = info.isLegacy();
        actions = Set.copyOf(info.actions());
        address = info.rfId();
        if (legacy) {
            surroundings.warnings()
                    .once("the board on " + port + " speaks the older protocol: percepts and .act work, the"
                            + " radio does not; for that flash a sketch with the Javino library");
        }
        BoardSettings wanted = settings;
        boolean stranger = wanted.rfId().isPresent() && !wanted.rfId().equals(info.rfId());
        if (stranger) {
            session.thenCompose(board -> board.setRfId(wanted.rfId().get())).whenComplete((done, thrown) -> {
                if (thrown != null) {
                    surroundings.warnings().always(Failure.of(thrown).message());
                }
                nowOnline(thrown == null || info.rfId().isPresent());
            });
        } else {
            nowOnline(info.rfId().isPresent());
        }
    }

    /** Only now may the agent act: its address is set; and the session has opened the radio as wished. */
    private void nowOnline(boolean hasAddress) {
        online = true;
        communicability.online(hasAddress, settings.radio());
        percepts.port(true);
        decided.complete(null);
        tellAgent();
    }

    @Override
    public void offline(String why) {
        online = false;
        communicability.offline();
        percepts.port(false);
        if (!closed) {
            surroundings.warnings().always("the board is off: " + why);
        }
        decided.complete(null);
        tellAgent();
    }

    @Override
    public void percepts(List<String> literals) {
        percepts.sensors(literals);
        tellAgent();
    }

    @Override
    public void message(ReceivedMessage message) {
        // After the end it is left to the next session, as the board was not told that it was taken.
        if (!closed) {
            communicability.heard();
            surroundings.inbox().put(message, surroundings.agent());
            tellAgent();
        }
    }

    @Override
    public void warning(String what) {
        if (!closed) {
            surroundings.warnings().once(what);
        }
    }

    private void tellAgent() {
        if (!closed) {
            surroundings.wake().run();
        }
    }
}
