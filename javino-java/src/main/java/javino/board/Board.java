package javino.board;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javino.link.LinkOpener;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Counter;
import javino.protocol.Key;
import javino.protocol.Outcome;
import javino.protocol.ProtocolException;
import javino.protocol.Reply;
import javino.protocol.Request;
import javino.protocol.Status;

/**
 * A session with one board, which is greeted, polled, and found again when it was gone, all on a daemon thread.
 *
 * <p>Nothing here waits for the board: requests return futures, which complete on the session's thread (so what
 * depends on them must not block). A request made while the board is offline waits for it, at most
 * {@link BoardConfig#patience()}. A future fails with
 * <ul>
 * <li>{@link RequestFailedException} where the board refused,
 * <li>{@link LegacyBoardException} where the board speaks the older protocol (SPEC 8), but for actions and percepts,
 * <li>{@link BoardOfflineException} where it was not reached,
 * <li>{@link OutcomeUnknownException} where it was lost or reset while the request was under way,
 * <li>{@link QueueFullException} where too many requests wait,
 * <li>{@link ProtocolException} where the reply made no sense.
 * </ul>
 */
public final class Board implements AutoCloseable {

    private static final Duration CLOSE_TIMEOUT = Duration.ofSeconds(2);

    private final Context context;
    private final Session session;
    private final CompletableFuture<Void> ended = new CompletableFuture<>();
    private final Thread thread;

    private Board(LinkOpener opener, BoardConfig config, BoardListener listener) {
        context = Context.of(opener.name(), config, listener);
        session = new Session(opener, context);
        thread = new Thread(this::run, "javino " + opener.name());
        thread.setDaemon(true);
    }

    private void run() {
        try {
            session.run();
        } finally {
            ended.complete(null);
        }
    }

    /** Begins a session; the board need not be there yet. */
    public static Board open(LinkOpener opener, BoardConfig config, BoardListener listener) {
        Board board = new Board(opener, config, listener);
        board.thread.start();
        return board;
    }

    /**
     * Has the sketch perform an action. A board that speaks the older protocol answers none: there the future completes
     * when the action has left.
     *
     * @param action {@code name} or {@code name(arguments)}, 1…510 bytes of UTF-8.
     * @throws IllegalArgumentException if the action is empty or too long.
     */
    public CompletableFuture<Void> act(String action) {
        return ask(Request.act(action), Board::nothing);
    }

    /**
     * Has a content sent by radio from the board's own address.
     *
     * @throws IllegalArgumentException if the destination is the serial line.
     */
    public Transmission transmit(Address to, Content content) {
        if (to.equals(Address.SERIAL)) {
            throw new IllegalArgumentException("a transmission goes to an RF address, not " + to);
        }
        String description = "transmit to " + to + ": " + content;
        CompletableFuture<Outcome> end = new CompletableFuture<>();
        CompletableFuture<Void> taken = ask(description, board -> {
            Address origin = board.rfId().orElseThrow(() -> new RequestFailedException(description, Status.NO_RF_ID));
            return Request.transmit(to, origin, content);
        }, reply -> {
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
     * Gives the board its address; it keeps it.
     *
     * @throws IllegalArgumentException if the address is no device's.
     */
    public CompletableFuture<Void> setRfId(Address id) {
        return ask(Request.setRfId(id), reply -> {
            reply.nothing();
            session.renamed(id);
            return null;
        });
    }

    /** Has radio messages received, or not, now and whenever the board comes online again. */
    public CompletableFuture<Void> radio(boolean open) {
        // At once, so that of two threads' wishes the last to be remembered is also the last to be performed.
        synchronized (context.radio()) {
            context.radio().set(open);
            return ask(Request.radio(open), Board::nothing);
        }
    }

    /**
     * Stores a key in the board, in the place of all that it has for the address; it keeps it.
     *
     * @param address the device or group that the key is shared with.
     * @return the check value that the board computed, 3 bytes, to be compared with {@link Key#check()}.
     * @throws IllegalArgumentException if the address is neither a device's nor a group's.
     */
    public CompletableFuture<Bytes> setKey(Address address, Key key) {
        return ask(Request.setKey(address, key), Reply::checkValue);
    }

    /**
     * Raises the first half of the board's nonces; one that is not lower stays. The board goes on with it.
     *
     * @throws IllegalArgumentException if the epoch is not 0…0xFFFFFE.
     */
    public CompletableFuture<Void> raiseEpoch(int epoch) {
        return ask(Request.raiseEpoch(epoch), Board::nothing);
    }

    /**
     * Stores a key in the board as the next one of an address that has one: frames that come sealed with it are accepted
     * and acknowledged; the one so far seals, until {@link #useKey}. Fails with NO_KEY where there is none so far, with
     * BAD_ARGUMENT where another renewal is not finished.
     *
     * @return the check value that the board computed, 3 bytes, to be compared with {@link Key#check()}.
     * @throws IllegalArgumentException if the address is neither a device's nor a group's.
     */
    public CompletableFuture<Bytes> renewKey(Address address, Key key) {
        return ask(Request.renewKey(address, key), Reply::checkValue);
    }

    /**
     * Has the board seal with the next key of an address, once all who share it accept it; frames that come sealed with
     * the one so far are still accepted, until {@link #finishRenewal}. Fails with NO_KEY where there is no next one, with
     * BUSY while a message is under way that is sealed with the one so far: then it is to be tried again.
     */
    public CompletableFuture<Void> useKey(Address address) {
        return ask(Request.useKey(address), Board::nothing);
    }

    /**
     * Has the board forget the previous key of an address, once all who share it seal with the one after it; fails with
     * NO_KEY where there is none.
     */
    public CompletableFuture<Void> finishRenewal(Address address) {
        return ask(Request.finishRenewal(address), Board::nothing);
    }

    /** Has the board forget all keys of an address. */
    public CompletableFuture<Void> deleteKey(Address address) {
        return ask(Request.deleteKey(address), Board::nothing);
    }

    /** The addresses, roles and check values of the board's keys. */
    public CompletableFuture<List<Reply.StoredKey>> keys() {
        return ask(Request.listKeys(), Reply::storedKeys);
    }

    /** The board's counters, since it booted: as a rule when this session opened its port. */
    public CompletableFuture<Map<Counter, Long>> statistics() {
        return ask(Request.statistics(), Reply::statistics);
    }

    /** Has percepts asked for, or not; without, the listener is told an empty set. At first they are not. */
    public void percepts(boolean wanted) {
        context.perception().setWanted(wanted);
        context.queue().wake();
    }

    /**
     * Limits how often percepts are asked for.
     *
     * @param least the least time between two sets; zero, as at first, for each poll.
     * @throws IllegalArgumentException if it is negative.
     */
    public void perceptInterval(Duration least) {
        if (least.isNegative()) {
            throw new IllegalArgumentException("the least time between percepts cannot be negative: " + least);
        }
        context.perception().setInterval(least);
    }

    /**
     * Waits for percepts that are asked for from now on, so that they show what an action has changed. It completes when
     * the listener was told of them, if they are others than before; or where none come: they are not wanted, the board
     * is not there or goes, or {@link #perceptInterval} lets them come later. It never fails.
     *
     * @param within how much later they may come.
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
     * What first comes of the session: who the board is, or in one line why it cannot be reached. After a failure the
     * session still tries, but where the board speaks another version of the protocol.
     */
    public CompletableFuture<BoardInfo> greeted() {
        return session.greeted().copy();
    }

    /** How the session stands with the board. */
    public BoardState state() {
        return session.state();
    }

    /** The board as it was greeted last, with its present address; nothing before the first time. */
    public Optional<BoardInfo> info() {
        return session.info();
    }

    /** The session's own counters. */
    public Map<SessionCounter, Long> counters() {
        return context.counters().snapshot();
    }

    /**
     * Ends the session without waiting for it; requests that wait fail.
     *
     * @return completes when the port is free for others, as a rule within a tenth of a second.
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
            end.completeOnTimeout(null, CLOSE_TIMEOUT.toMillis(), TimeUnit.MILLISECONDS).join();
        }
    }

    private static Void nothing(Reply reply) throws ProtocolException {
        reply.nothing();
        return null;
    }

    private <T> CompletableFuture<T> ask(Request request, Pending.Reader<T> reader) {
        return ask(request.toString(), board -> request, reader);
    }

    private <T> CompletableFuture<T> ask(String description, Pending.Source source, Pending.Reader<T> reader) {
        CompletableFuture<T> result = new CompletableFuture<>();
        try {
            context.queue().add(new Pending<>(description, source, reader, result,
                    Deadline.in(context.config().patience())));
        } catch (QueueFullException e) {
            context.counters().count(SessionCounter.REFUSED_REQUESTS);
            result.completeExceptionally(e);
        } catch (BoardOfflineException e) {
            result.completeExceptionally(e);
        }
        return result;
    }
}
