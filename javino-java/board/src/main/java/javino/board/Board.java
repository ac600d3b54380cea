package javino.board;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import javino.link.LinkOpener;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.Counter;
import javino.protocol.Frame;
import javino.protocol.Key;
import javino.protocol.Outcome;
import javino.protocol.ProtocolException;
import javino.protocol.Reply;
import javino.protocol.Request;
import javino.protocol.Status;
import javino.protocol.Message;

/**
 * A session with one board. A daemon thread says hello to the board, polls it, and finds it again when it was lost.
 *
 * <p>No method waits for the board: requests return futures, which complete on the session's thread (so actions that
 * depend on them must not block). A request made while the board is offline waits for it, at most
 * {@link BoardConfig#patience()}. A future fails with
 * <ul>
 * <li>{@link RequestFailedException} if the board refused,
 * <li>{@link LegacyBoardException} if the board speaks the older protocol (SPEC 8), except for actions and percepts,
 * <li>{@link BoardOfflineException} if it was not reached,
 * <li>{@link OutcomeUnknownException} if it was lost or reset while the request was under way,
 * <li>{@link QueueFullException} if too many requests wait,
 * <li>{@link AirtimeUsedException} if the board is full while its airtime limit holds messages back,
 * <li>{@link ProtocolException} if the reply was not understood.
 * </ul>
 */
public final class Board implements AutoCloseable {

    private static final Duration CLOSE_TIMEOUT = Duration.ofSeconds(2);

    private final SessionContext context;
    private final Session session;
    private final CompletableFuture<Void> ended = new CompletableFuture<>();
    private final Thread thread;

    private Board(LinkOpener opener, BoardConfig config, BoardListener listener) {
        context = SessionContext.of(opener.name(), config, listener);
        session = new Session(opener, context);
        thread = context.time().thread("javino " + opener.name(), this::run);
    }

    private void run() {
        try {
            session.run();
        } finally {
            ended.complete(null);
        }
    }

    /** Starts a session; the board need not be there yet. */
    public static Board open(LinkOpener opener, BoardConfig config, BoardListener listener) {
        Board board = new Board(opener, config, listener);
        board.thread.start();
        return board;
    }

    /**
     * Makes the sketch perform an action, once however damaged the line is. A board that speaks the older protocol does
     * not answer: there the future completes when the action has left the host.
     *
     * @param action {@code name} or {@code name(arguments)}, 1…510 bytes of UTF-8.
     * @return the number that the action returns, -8388608…8388607, if it returns one. A
     *         {@link RequestFailedException} may have the sketch's {@link RequestFailedException#reason}.
     * @throws IllegalArgumentException if the action is empty or too long.
     */
    public CompletableFuture<OptionalInt> act(String action) {
        return ask(Request.act(action), Reply::number);
    }

    /**
     * Sends a message by radio from the board's own address. It waits here until the board has room for it.
     *
     * @throws IllegalArgumentException if the destination is the serial line.
     */
    public Transmission transmit(Address to, Message message) {
        if (to.equals(Address.SERIAL)) {
            throw new IllegalArgumentException("a transmission goes to an RF address, not " + to);
        }
        String description = "transmit to " + to + ": " + message;
        return transmission(description, true, board -> {
            Address self = board.rfId().orElseThrow(() -> new RequestFailedException(description,
                    board.hasRadio() ? Status.NO_RF_ID : Status.NO_RADIO));
            return Request.transmit(to, self, message);
        });
    }

    /**
     * Sends a frame of another device once, byte by byte as it is, when the air is free. The board needs no key and no
     * address for it. The transmission ends as {@link Outcome#SENT}.
     *
     * @throws IllegalArgumentException if the frame is too long for any packet of a radio.
     */
    public Transmission relay(Frame frame) {
        Request request = Request.relay(frame);
        return transmission(request.toString(), false, board -> request);
    }

    private Transmission transmission(String description, boolean waits, PendingRequest.Source source) {
        CompletableFuture<Outcome> end = new CompletableFuture<>();
        CompletableFuture<Void> taken = ask(description, waits, source, reply -> {
            session.transmitting(reply.transmissionNumber(), end);
            return null;
        });
        taken.whenComplete((nothing, thrown) -> {
            if (thrown != null) {
                end.completeExceptionally(thrown);
            }
        });
        return new Transmission(taken, end);
    }

    /**
     * Sets the board's address, which the board stores.
     *
     * @throws IllegalArgumentException if the address is no device's.
     */
    public CompletableFuture<Void> setRfId(Address id) {
        return ask(Request.setRfId(id), Board::nothing);
    }

    /** Switches the reception of radio messages on or off, now and whenever the board comes online again. */
    public CompletableFuture<Void> radio(boolean open) {
        return wish(context.radio(), open, Request.radio(open));
    }

    /**
     * Has the listener told of each packet that the board hears on the air, whoever it is for, or of none, now and
     * whenever the board comes online again. The board needs no key for it, and its radio may be blocked.
     */
    public CompletableFuture<Void> overhear(boolean on) {
        return wish(context.overhear(), on, Request.overhear(on));
    }

    /**
     * Makes the board a relay, or none (SPEC 7.5). The board stores that and goes on after each boot. It needs neither
     * key nor address. Fails with UNKNOWN_COMMAND if the board, or its radio, cannot relay.
     *
     * @return whether the board is a relay now.
     */
    public CompletableFuture<Boolean> relaying(boolean on) {
        return ask(on ? Request.relaying(context.time().random().nextInt(0x1_0000)) : Request.notRelaying(),
                Reply::relaying);
    }

    /** Whether the board is a relay; fails as {@link #relaying(boolean)} does. */
    public CompletableFuture<Boolean> isRelaying() {
        return ask(Request.isRelaying(), Reply::relaying);
    }

    private CompletableFuture<Void> wish(AtomicReference<Boolean> wish, boolean value, Request request) {
        // At once, so that of two threads' wishes the last to be remembered is also the last to be performed.
        synchronized (wish) {
            wish.set(value);
            return ask(request, Board::nothing);
        }
    }

    /**
     * Stores a key in the board and replaces all its keys for the address.
     *
     * @param address the device or group that the key is shared with.
     * @return the check value that the board computed, 3 bytes, to be compared with {@link Key#check()}. Fails with a
     *         {@link LostKeyException} if the board had this key and has lost it, and with a
     *         {@link javino.JavinoException} if it has no RF id.
     * @throws IllegalArgumentException if the address is neither a device's nor a group's.
     */
    public CompletableFuture<Bytes> setKey(Address address, Key key) {
        return ask(Request.setKey(address, key), Reply::checkValue);
    }

    /**
     * Stores a key in the board as the next one of an address that has one: frames sealed with it are accepted and
     * acknowledged; the current key seals until {@link #useKey}. Fails with NO_KEY if there is no current key, and with
     * BAD_ARGUMENT if another renewal is not finished.
     *
     * @return the check value that the board computed, 3 bytes, to be compared with {@link Key#check()}. Fails as that
     *         of {@link #setKey}.
     * @throws IllegalArgumentException if the address is neither a device's nor a group's.
     */
    public CompletableFuture<Bytes> renewKey(Address address, Key key) {
        return ask(Request.renewKey(address, key), Reply::checkValue);
    }

    /**
     * Makes the board seal with the next key of an address; call it when all devices that share the key accept it.
     * Frames sealed with the key before are still accepted until {@link #finishRenewal}. Fails with NO_KEY if there is
     * no next key, and with BUSY while a message sealed with the key before is under way: then try again.
     */
    public CompletableFuture<Void> useKey(Address address) {
        return ask(Request.useKey(address), Board::nothing);
    }

    /**
     * Makes the board delete the previous key of an address; call it when all devices that share the key seal with the
     * next one. Fails with NO_KEY if there is no previous key.
     */
    public CompletableFuture<Void> finishRenewal(Address address) {
        return ask(Request.finishRenewal(address), Board::nothing);
    }

    /**
     * Gives the board the key of a pair that lives in its RAM only, as a device's session key; the one before is
     * deleted. The key is gone when the board boots, which {@link BoardListener#online} tells by another boot epoch;
     * and when the board needs its place for another session key and has used this one least recently: then messages
     * for the device fail with NO_KEY. The board writes no EEPROM. Fails with HAS_KEY if the board has a stored key for
     * the device, with BAD_ARGUMENT if it had this session key before, and with UNKNOWN_COMMAND if its firmware has no
     * place for session keys.
     *
     * @param key fresh: agreed on with the device just now, and never set before.
     * @return the check value that the board computed, 3 bytes, to be compared with {@link Key#check()}.
     * @throws IllegalArgumentException if the address is no device's.
     */
    public CompletableFuture<Bytes> setSessionKey(Address device, Key key) {
        return ask(Request.setSessionKey(device, key), Reply::checkValue);
    }

    /** Makes the board delete all keys of an address. */
    public CompletableFuture<Void> deleteKey(Address address) {
        return ask(Request.deleteKey(address), Board::nothing);
    }

    /** The addresses, roles and check values of the board's keys. */
    public CompletableFuture<List<Reply.StoredKey>> keys() {
        return ask(Request.listKeys(), Reply::storedKeys);
    }

    /** The board's counters since it booted, as a rule when this session opened its port. */
    public CompletableFuture<Map<Counter, Long>> statistics() {
        return ask(Request.statistics(), context::counted);
    }

    /**
     * How much of the last hour the board's radio has sent, by counters of at most a minute ago; nothing before the
     * first of them, without a radio, and from an earlier library.
     */
    public Optional<AirtimeHour.Use> airtime() {
        return info().filter(BoardInfo::countsAirtime).flatMap(any -> context.airtime().use(context.time().nanos()));
    }

    /**
     * Switches percepts on or off; off is the default. When they are switched off, the listener is told an empty set.
     */
    public void percepts(boolean wanted) {
        context.perception().setWanted(wanted);
        context.queue().wake();
    }

    /**
     * Limits how often the board tells percepts.
     *
     * @param least the least time between two sets; zero, the default, for each change.
     * @throws IllegalArgumentException if it is negative.
     */
    public void perceptInterval(Duration least) {
        if (least.isNegative()) {
            throw new IllegalArgumentException("the least time between percepts cannot be negative: " + least);
        }
        context.perception().setInterval(least);
        context.queue().wake();
    }

    /**
     * Waits for percepts that are asked for from now on, so that they show the effect of an action. It completes after
     * the listener was told of them, if they have changed; or at once if none come: they are switched off, the board is
     * not there or is lost, or {@link #perceptInterval} delays them too long. It never fails.
     *
     * @param within the longest delay that is waited for.
     */
    public CompletableFuture<Void> reading(Duration within) {
        CompletableFuture<Void> taken = context.perception().reading(within);
        if (state() == BoardState.ONLINE) {
            context.queue().wake();
        } else {
            taken.complete(null);
        }
        return taken.copy();
    }

    /**
     * The first result of the session: the board's description, or the reason why it cannot be reached. After a failure
     * the session still tries, unless the board speaks another version of the protocol.
     */
    public CompletableFuture<BoardInfo> greeted() {
        return session.greeted().copy();
    }

    /** In which the session lives. */
    public Time time() {
        return context.time();
    }

    /** The state of the session. */
    public BoardState state() {
        return session.state();
    }

    /** The board's description from its last hello, with its present address; nothing before the first hello. */
    public Optional<BoardInfo> info() {
        return session.info();
    }

    /** The counters of the session itself. */
    public Map<SessionCounter, Long> counters() {
        return context.counters().all(SessionCounter.class);
    }

    /**
     * Ends the session without waiting for it; requests that wait fail.
     *
     * @return completes when the port is free for others, usually within a tenth of a second.
     */
    public CompletableFuture<Void> end() {
        context.queue().close("the session was closed");
        return ended.copy();
    }

    /** Ends the session, and waits until the port is free, except on the session's own thread; 2 s at most. */
    @Override
    public void close() {
        CompletableFuture<Void> end = end();
        if (Thread.currentThread() != thread) {
            context.time().join(context.time().completeOnTimeout(end, null, CLOSE_TIMEOUT));
        }
    }

    private static Void nothing(Reply reply) throws ProtocolException {
        reply.nothing();
        return null;
    }

    private <T> CompletableFuture<T> ask(Request request, PendingRequest.Reader<T> reader) {
        return ask(request.toString(), false, board -> request, reader);
    }

    private <T> CompletableFuture<T> ask(String description, boolean waits, PendingRequest.Source source,
            PendingRequest.Reader<T> reader) {
        CompletableFuture<T> result = new CompletableFuture<>();
        try {
            context.queue().add(new PendingRequest<>(description, source, reader, result,
                    context.in(context.config().patience()), waits));
        } catch (QueueFullException e) {
            context.counters().count(SessionCounter.REFUSED_REQUESTS);
            result.completeExceptionally(e);
        } catch (BoardOfflineException e) {
            result.completeExceptionally(e);
        }
        return result;
    }
}
