package diffuser.board;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiFunction;

import javino.board.QueueFullException;
import javino.board.Transmission;
import javino.protocol.Address;
import javino.protocol.HostMessage;
import javino.protocol.Message;

/**
 * Sends all messages of a host by its board: host messages one at a time to each address, others at once. For any
 * thread.
 */
public final class Sender {

    /** Messages that wait for each address. */
    static final int MOST_WAITING = 16;

    private final BiFunction<Address, Message, Transmission> board;
    private final AtomicLong notSent = new AtomicLong();
    /** Messages for each address; the first of them is under way. */
    private final Map<Address, Deque<Sending>> sendings = new HashMap<>();

    private record Sending(HostMessage message, Transmission transmission) {
    }

    /** @param board transmits a message. */
    public Sender(BiFunction<Address, Message, Transmission> board) {
        this.board = board;
    }

    /**
     * Sends a message; a host message when those before it to the same address have ended.
     *
     * @return fails as the board's; and with a {@link QueueFullException}, if the same host message waits already, or
     *         too many.
     */
    public Transmission send(Address to, Message message) {
        return message instanceof HostMessage ofHosts ? sendInTurn(to, ofHosts) : board.apply(to, message);
    }

    private Transmission sendInTurn(Address to, HostMessage message) {
        Sending mine = new Sending(message,
                new Transmission(new CompletableFuture<>(), new CompletableFuture<>()));
        int before;
        synchronized (sendings) {
            Deque<Sending> all = sendings.computeIfAbsent(to, any -> new ArrayDeque<>());
            before = all.size();
            boolean same = all.stream().skip(1).anyMatch(other -> other.message.equals(message));
            if (same || before > MOST_WAITING) {
                notSent.incrementAndGet();
                return failed(new QueueFullException(message.toString(), MOST_WAITING));
            }
            all.add(mine);
        }
        if (before == 0) {
            begin(to, mine);
        }
        return mine.transmission;
    }

    private static Transmission failed(Exception why) {
        return new Transmission(CompletableFuture.failedFuture(why), CompletableFuture.failedFuture(why));
    }

    private void begin(Address to, Sending sending) {
        Transmission begun;
        try {
            begun = board.apply(to, sending.message);
        } catch (IllegalArgumentException wrong) {
            begun = failed(wrong); // so that those behind it are sent
        }
        begun.taken().whenComplete((taken, thrown) -> complete(sending.transmission.taken(), taken, thrown));
        begun.end().whenComplete((outcome, thrown) -> {
            Optional<Sending> next;
            synchronized (sendings) {
                sendings.get(to).remove();
                next = Optional.ofNullable(sendings.get(to).peek());
                sendings.computeIfPresent(to, (any, rest) -> rest.isEmpty() ? null : rest);
            }
            complete(sending.transmission.end(), outcome, thrown);
            next.ifPresent(waiting -> begin(to, waiting));
        });
    }

    private static <T> void complete(CompletableFuture<T> future, T value, Throwable thrown) {
        if (thrown == null) {
            future.complete(value);
        } else {
            future.completeExceptionally(thrown);
        }
    }

    /** How many messages were not sent, as too many waited. */
    public long notSent() {
        return notSent.get();
    }
}
