package diffuser.board;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;

import jason.asSyntax.Literal;
import jason.asSyntax.Term;

import diffuser.gate.Texts;
import diffuser.gate.TrustLevel;
import diffuser.report.Failure;

import javino.board.AirtimeHour;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.ReceivedMessage;
import javino.board.RequestFailedException;
import javino.board.SketchTimes;
import javino.board.Transmission;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Counter;
import javino.protocol.HostMessage;
import javino.protocol.Message;
import javino.protocol.Outcome;
import javino.protocol.PollReply;
import javino.protocol.Status;

/**
 * The board on one port, as one agent sees it. The session's thread puts what happens at the board where the agent
 * finds it in its next cycle, and wakes the agent.
 */
public final class Device implements BoardListener {

    /** Longer than a session waits for two actions, so that it ends only what the session itself has lost. */
    private static final Duration ANSWER = Duration.ofSeconds(30);
    /** Until sensors that are held are read by themselves. */
    private static final Duration NEVER = Duration.ofDays(36_500);

    private final ExclusivePort link;
    private final Time time;
    private final DeviceContext context;
    private final Percepts percepts;
    private final Communicability communicability;
    private final BoardKeys keys;
    private final Sender sender = new Sender(this::begin);
    private final CompletableFuture<Board> session = new CompletableFuture<>();
    private final CompletableFuture<Void> decided = new CompletableFuture<>();
    private volatile BoardSettings settings;
    private volatile boolean online;
    /** The board's answer when it was greeted last. */
    private volatile Optional<BoardInfo> info = Optional.empty();
    private volatile boolean closed;

    private Device(ExclusivePort link, Term term, Time time, BoardSettings settings, DeviceContext context) {
        this.link = link;
        this.time = time;
        this.settings = settings;
        this.context = context;
        this.percepts = new Percepts(term, settings.percepts(), context);
        this.keys = new BoardKeys(this, this::session, context);
        this.communicability = new Communicability(this::packetsReceived, this::tellAgent, context.warnings(), time);
    }

    /**
     * Starts to look for a board, and returns at once.
     *
     * @param port as beliefs name it.
     */
    public static Device open(ExclusivePort link, Term port, BoardConfig config, BoardSettings settings,
            DeviceContext context) {
        Device device = new Device(link, port, config.time(), settings, context);
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
    public CompletableFuture<Void> decided() {
        return decided;
    }

    /** The port as the agent's program names it. */
    public String port() {
        return link.name();
    }

    /** Whether the board is there. */
    public boolean isOnline() {
        return online;
    }

    /** The address that the board has or is to have, as far as is known. */
    public Optional<Address> address() {
        return hasRadio() ? settings.rfId().or(() -> info.flatMap(BoardInfo::rfId)) : Optional.empty();
    }

    /** Whether the board speaks the older protocol, as far as is known: then it has actions for {@code .act} only. */
    public boolean isLegacy() {
        return info.map(BoardInfo::isLegacy).orElse(false);
    }

    /** Whether the board has a radio, as far as is known. An agent has only that of its main board. */
    public boolean hasRadio() {
        return isMain() && info.map(BoardInfo::hasRadio).orElse(true);
    }

    private boolean isMain() {
        return context.board().equals(BoardName.MAIN);
    }

    /** Whether the board has sealed unicasts only, as far as is known. */
    boolean hasUnicastsOnly() {
        return info.map(BoardInfo::hasUnicastsOnly).orElse(false);
    }

    /** Whether an action of that name is the board's; one that speaks the older protocol cannot say, so any may be. */
    public boolean performs(String action) {
        return isLegacy() || hasAction(action);
    }

    /**
     * Sends a message; to a device or group for which the board has no key, once key agreement has one, if it can.
     *
     * @return both fail with what {@link Failure#of} reads.
     */
    public Transmission transmit(Address to, Message message) {
        return context.keyService().filter(keyService -> hasRadio() && keys.lacks(to))
                .map(keyService -> keyService.transmit(keys, to, message))
                .orElseGet(() -> sender.send(to, message));
    }

    /** Sends under the keys that the board has. */
    public Sender sender() {
        return sender;
    }

    private Transmission begin(Address to, Message message) {
        Transmission begun = session().transmit(to, message);
        begun.end().thenAccept(this::ended);
        return begun;
    }

    /** The trust level of a device from which a sealed message came. */
    public TrustLevel peer(Address from) {
        return keys.peer(from);
    }

    /** Whether agents can communicate by the board's radio. */
    public boolean communicates() {
        return communicability.isUsable();
    }

    /** All that the board lets the agent perceive now; another state is another list. */
    public List<Literal> perceived() {
        return percepts.snapshot();
    }

    /** How many percepts were left out as malformed or refused. */
    public long malformedPercepts() {
        return percepts.malformed();
    }

    /** What the board that is here, or was here last, said of itself. */
    public Optional<BoardInfo> info() {
        return info;
    }

    /** Whether a board was here ever. */
    public boolean isKnown() {
        return info.isPresent();
    }

    /** Whether the sketch of the board that is here, or was here last, has named an action so. */
    public boolean hasAction(String name) {
        return info.map(board -> board.actions().contains(name)).orElse(false);
    }

    /** Whether the sketch of the board that is here, or was here last, has named no action: it may know any text. */
    public boolean readsActions() {
        return info.map(board -> board.actions().isEmpty()).orElse(false);
    }

    /** Has the board do as wished, now and whenever it comes back; {@link #setRfId} and {@link #radio} add when. */
    public void apply(BoardSettings wanted) {
        settings = wanted;
        Board board = session();
        percepts.sensing(wanted.percepts(), wanted.filters());
        board.perceptInterval(wanted.percepts() == SensorMode.HELD ? NEVER : wanted.limit());
        board.percepts(wanted.percepts() != SensorMode.BLOCKED);
        communicability.silence(wanted.silence());
    }

    /** What the agent wishes of the board. */
    public BoardSettings settings() {
        return settings;
    }

    /** Sets the board's address. */
    public CompletableFuture<Void> setRfId(Address id) {
        return bounded(session().setRfId(id).thenRun(() -> {
            communicability.addressed();
            tellFinder();
        }));
    }

    /** Opens or blocks the radio. */
    public CompletableFuture<Void> radio(boolean open) {
        return bounded(session().radio(open).thenRun(() -> communicability.radio(open)));
    }

    /** Has the board perform an action, which may return a number; a failure has the sketch's reason. */
    public CompletableFuture<OptionalInt> act(String action) {
        return bounded(session().act(action).exceptionallyCompose(thrown -> CompletableFuture.failedFuture(
                thrown instanceof RequestFailedException refused && refused.reason().isPresent()
                        ? Failure.of(refused).because(Texts.reason(refused.reason().get())).toException() : thrown)));
    }

    /** Completes when the sensors were read anew, or will not be read so soon; never fails. */
    public CompletableFuture<Void> reading(Duration within) {
        return session.thenCompose(board -> board.reading(within));
    }

    /** The outcome of a message that the board has transmitted. */
    private void ended(Outcome outcome) {
        if (outcome == Outcome.DELIVERED) {
            communicability.heard();
        } else if (outcome == Outcome.UNDELIVERED) {
            counters();
        }
    }

    /**
     * Ends the session without waiting for it; nothing comes from this device any more.
     *
     * @return completes when the port is free for another.
     */
    public CompletableFuture<Void> close() {
        closed = true;
        communicability.close();
        decided.complete(null);
        return session().end().whenComplete((done, thrown) -> link.leave());
    }

    /** Asks for the board's counters, and warns of what in the sketch keeps the radio waiting. */
    public CompletableFuture<Map<Counter, Long>> counters() {
        return session.thenCompose(Board::statistics).thenApply(counters -> {
            SketchTimes.slow(counters, hasRadio()).forEach(slow -> context.warnings().once(slow.part(),
                    "the sketch on " + port() + " is slow, " + slow.part() + ": " + slow.remedy()));
            return counters;
        });
    }

    /** How much of the last hour the board's radio has sent; of the one radio that an agent has, as far as is known. */
    public Optional<AirtimeHour.Use> airtime() {
        return isMain() ? session().airtime() : Optional.empty();
    }

    private CompletableFuture<Long> packetsReceived() {
        return counters().thenApply(counts -> Objects
                .requireNonNull(counts.get(Counter.RADIO_RECEIVED), "the board does not count what it hears"));
    }

    private <T> CompletableFuture<T> bounded(CompletableFuture<T> answer) {
        return time.orTimeout(answer.copy(), ANSWER);
    }

    private Board session() {
        return time.join(session);
    }

    // On the session's thread:

    @Override
    public void online(BoardInfo board) {
        if (closed) {
            return;
        }
        info = Optional.of(board);
        BoardSettings wanted = settings;
        if (board.isLegacy()) {
            context.warnings().once("the board on " + port() + " speaks the older protocol: percepts and .act work, the"
                    + " radio does not; for that flash a sketch with the library JavinoBDI");
        } else if (!board.hasRadio() && (wanted.radio() || wanted.rfId().isPresent())) {
            context.warnings().once(port() + ": " + Status.NO_RADIO.explanation());
        }
        if (board.hasRadio() && !isMain()) {
            context.warnings().once("the radio of the board " + context.board() + " stays closed: an agent has that of"
                    + " its main board only; for a second one use another agent");
            session().radio(false);
        }
        boolean other = board.hasRadio() && wanted.rfId().isPresent() && !wanted.rfId().equals(board.rfId());
        // The session's thread waits here for the one that has begun it: so these requests go before the first poll.
        Board open = session();
        (other ? open.setRfId(wanted.rfId().get()) : CompletableFuture.completedFuture(null))
                .whenComplete((done, thrown) -> {
                    if (thrown != null) {
                        context.warnings().always(Failure.of(thrown).message());
                    }
                    askForKeys(board.rfId().isPresent() || other && thrown == null);
                });
    }

    /** Before the agent may act, it is to be known for whom there are keys. */
    private void askForKeys(boolean hasAddress) {
        if (!hasRadio()) {
            nowOnline(false);
            return;
        }
        session.thenCompose(Board::keys).whenComplete((list, thrown) -> {
            if (thrown == null) {
                keys.told(list);
            } else {
                context.warnings().once("it is not known which keys the board has: " + Failure.of(thrown).message());
            }
            nowOnline(hasAddress);
        });
    }

    /** Only now may the agent act: its address is set; and the session has opened the radio as wished. */
    private void nowOnline(boolean hasAddress) {
        online = true;
        communicability.online(hasAddress, settings.radio());
        percepts.port(true);
        percepts.peers(keys.beliefs());
        decided.complete(null);
        tellAgent();
        tellFinder();
    }

    /** The board has keys for others than before. */
    void keysChanged() {
        if (online) {
            percepts.peers(keys.beliefs());
            tellAgent();
        }
    }

    private void tellFinder() {
        if (online && !closed) {
            address().ifPresent(self -> keys.online(self, info.map(BoardInfo::bootEpoch).orElse(0)));
        }
    }

    @Override
    public void offline(String why) {
        online = false;
        communicability.offline();
        percepts.port(false);
        if (!closed) {
            context.warnings().always("the board " + (isMain() ? "" : context.board() + " ") + "is off: " + why);
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
        take(message, keys.peer(message));
    }

    /** A message for the agent. */
    void take(ReceivedMessage message, TrustLevel peer) {
        // After the end it is left to the next session, as the board was not told that it was taken.
        if (!closed) {
            communicability.heard();
            context.messages().accept(message, peer);
            tellAgent();
        }
    }

    @Override
    public void hostMessage(Address from, Address to, HostMessage message) {
        if (!closed) {
            communicability.heard();
            context.hosts().receive(from, to, keys.peer(from, message.kind().use()), message);
        }
    }

    @Override
    public void noKey(PollReply.NoKey frame) {
        if (!closed) {
            context.keyService().ifPresent(keyService -> keyService.noKey(frame));
        }
    }

    @Override
    public void printed(String text) {
        if (!closed) {
            context.printed().accept(text);
        }
    }

    @Override
    public void warning(String what) {
        if (!closed) {
            context.warnings().once(what);
        }
    }

    private void tellAgent() {
        if (!closed) {
            context.wake().run();
        }
    }
}
