package diffuser;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiFunction;
import java.util.function.Consumer;

import javino.board.QueueFullException;
import javino.board.Transmission;
import javino.protocol.Address;
import javino.protocol.HostMessage;

/**
 * Sends host messages: one broadcast at a time, and one unicast to each device. Hands those that come to the libraries
 * that they are for, if {@link Policy} lets them come by that cast and under that key. For any thread.
 */
public final class HostChannel {

    /** Messages that wait for each address. */
    static final int MOST_WAITING = 16;

    private final Map<HostMessage.Use, HostService> services = new EnumMap<>(HostMessage.Use.class);
    private final BiFunction<Address, HostMessage, Transmission> transmit;
    private final Consumer<String> warn;
    private final AtomicLong refused = new AtomicLong();
    private final AtomicLong notSent = new AtomicLong();
    /** Of each address the first is under way. */
    private final Map<Address, Deque<Sending>> sendings = new HashMap<>();

    private record Sending(HostMessage message, Transmission transmission) {
    }

    /**
     * @param services no two for one use.
     * @param transmit has the board transmit a message.
     * @param warn     is told once or more why a message was dropped.
     */
    public HostChannel(List<? extends BoardService> services, BiFunction<Address, HostMessage, Transmission> transmit,
            Consumer<String> warn) {
        this.transmit = transmit;
        this.warn = warn;
        services.stream().filter(HostService.class::isInstance).map(HostService.class::cast)
                .forEach(service -> service.uses().forEach(use -> this.services.put(use, service)));
    }

    /**
     * Sends a message, when those before it to the same address have ended.
     *
     * @return fails as the board's; and with a {@link QueueFullException}, if the same message waits already, or too
     *         many.
     */
    public Transmission send(Address to, HostMessage message) {
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
            begun = transmit.apply(to, sending.message);
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

    /**
     * Takes a message, or drops and counts it.
     *
     * @param to   this device, or all.
     * @param peer what is known of the sender: of a broadcast, of the device in whose name it came.
     */
    public void receive(Address from, Address to, TrustLevel peer, HostMessage message) {
        try {
            HostMessage.Use use = message.kind().use();
            Gate.permit(Policy.Act.of(use), Provenance.of(from, Cast.of(to), peer));
            if (!services.containsKey(use)) {
                throw new Gate.RefusedException("the library for it is not there");
            }
            services.get(use).received(from, message);
        } catch (Gate.RefusedException e) {
            refused.incrementAndGet();
            // What anybody can broadcast, in any name, is counted only.
            if (Cast.of(to) != Cast.BROADCAST) {
                warn.accept("dropped a " + message + " from " + from + ": " + e.getMessage());
            }
        }
    }

    /** How many messages were dropped. */
    public long refused() {
        return refused.get();
    }
}
