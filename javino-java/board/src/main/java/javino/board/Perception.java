package javino.board;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import javino.Counts;
import javino.link.Time;
import javino.protocol.Bytes;
import javino.protocol.ProtocolException;

/**
 * Knows what is wanted of percepts, tells the listener when they have changed, and those who wait for a reading that it
 * was taken. Any thread sets what is wanted; the rest is for the session's.
 */
final class Perception {

    private final ListenerGuard listener;
    private final Counts<SessionCounter> counters;
    private final Time time;
    private volatile boolean wanted;
    private volatile Duration interval = Duration.ZERO;
    private final Queue<Reading> waiting = new ConcurrentLinkedQueue<>();
    private final List<Reading> underWay = new ArrayList<>();
    /** The percepts that were told last; null where nothing holds. */
    private List<Bytes> percepts;
    private boolean leftOut;
    /** The causes that were told last, each in place of a percept. */
    private Set<String> unwritable = Set.of();
    /** When they came last, on the monotonic clock. */
    private long told;

    /** Percepts for which somebody waits, but not if they are due later than that. */
    private record Reading(Duration within, CompletableFuture<Void> taken) {
    }

    Perception(ListenerGuard listener, Counts<SessionCounter> counters, Time time) {
        this.listener = listener;
        this.counters = counters;
        this.time = time;
    }

    void setWanted(boolean percepts) {
        wanted = percepts;
    }

    /** Sets the least time between two sets of percepts. */
    void setInterval(Duration least) {
        interval = least;
    }

    /** Completes when percepts that were asked for after this were told, or where none will be; never fails. */
    CompletableFuture<Void> reading(Duration within) {
        Reading reading = new Reading(within, new CompletableFuture<>());
        waiting.add(reading);
        return reading.taken();
    }

    /** The board came online: percepts will be told anew. */
    void forget() {
        percepts = null;
        leftOut = false;
        unwritable = Set.of();
    }

    /**
     * Tells that nothing is perceived, once percepts are wanted no longer, and releases who would wait in vain.
     *
     * @return whether percepts are to be asked for. If not, the board is to be told so, even if they are wanted again
     *         by then: it tells only what differs from its last reading, which the listener has no more.
     */
    boolean update() {
        // Who comes after this look waits for the next one: percepts may be wanted again while their end is told.
        List<Reading> before = List.copyOf(waiting);
        if (wanted) {
            Duration due = dueIn();
            release(before.stream().filter(reading -> reading.within().compareTo(due) < 0).toList());
            return true;
        }
        if (percepts != null) {
            percepts = null;
            tell(List.of());
        }
        release(before);
        release(underWay);
        return false;
    }

    /** How long percepts are not to be told yet; zero if they may be. */
    Duration dueIn() {
        long nanos = percepts == null ? 0 : interval.toNanos() - (time.nanos() - told);
        return Duration.ofNanos(Math.max(0, nanos));
    }

    /** The least time between two sets of percepts. */
    Duration interval() {
        return interval;
    }

    /** Whether somebody waits for a reading. */
    boolean isAwaited() {
        return !waiting.isEmpty() || !underWay.isEmpty();
    }

    /** A reading that is made after this is asked for now. */
    void asked() {
        for (Reading reading = waiting.poll(); reading != null; reading = waiting.poll()) {
            underWay.add(reading);
        }
    }

    /** @param late whether those who wait for a reading may wait for a later one. */
    void take(List<Bytes> literals, boolean someLeftOut, boolean late) {
        if (someLeftOut && !leftOut) {
            listener.warn("the board has more percepts than fit one reply; the last ones are left out");
        }
        leftOut = someLeftOut;
        if (!literals.equals(percepts)) {
            tell(literals);
            percepts = literals;
        }
        told = time.nanos();
        if (!late) {
            release(underWay);
        }
    }

    /** There will be none: nobody waits any more. */
    void end() {
        asked();
        release(underWay);
    }

    private void release(List<Reading> ended) {
        ended.forEach(reading -> reading.taken().complete(null));
        waiting.removeAll(ended);
        underWay.removeAll(List.copyOf(ended));
    }

    private void tell(List<Bytes> literals) {
        List<String> texts = new ArrayList<>();
        Set<String> causes = new LinkedHashSet<>();
        for (Bytes literal : literals) {
            try {
                String text = literal.text();
                Optional<String> cause = UnwritableNumber.cause(text);
                cause.ifPresentOrElse(causes::add, () -> texts.add(text));
            } catch (ProtocolException e) {
                counters.count(SessionCounter.DAMAGED_RECORDS);
                listener.warn("a percept was skipped: " + e.getMessage());
            }
        }
        causes.forEach(cause -> counters.count(SessionCounter.UNWRITABLE_NUMBERS));
        causes.stream().filter(cause -> !unwritable.contains(cause))
                .forEach(cause -> listener.tell(to -> to.numberLeftOut(cause)));
        unwritable = causes;
        listener.tell(to -> to.percepts(List.copyOf(texts)));
    }
}
