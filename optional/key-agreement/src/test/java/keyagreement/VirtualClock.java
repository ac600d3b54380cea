package keyagreement;

import java.time.Instant;
import java.time.ZoneOffset;
import java.util.Comparator;
import java.util.PriorityQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

import javino.keyring.BoundedClock;
import javino.link.RealTime;

/** A time of its own, from the day of the release on, for the clocks of several hosts: nothing waits. */
final class VirtualClock extends RealTime {

    private static final Instant START = BoundedClock.RELEASED.atStartOfDay().toInstant(ZoneOffset.UTC);

    private final PriorityQueue<Step> steps =
            new PriorityQueue<>(Comparator.comparingLong(Step::at).thenComparingLong(Step::order));
    private long now;
    private long order;

    private record Step(long at, long order, Runnable what) {
    }

    /** In ms. */
    synchronized long passed() {
        return now;
    }

    @Override
    public long nanos() {
        return TimeUnit.MILLISECONDS.toNanos(passed());
    }

    @Override
    public Instant instant() {
        return START.plusMillis(passed());
    }

    private synchronized void after(long millis, Runnable step) {
        steps.add(new Step(now + millis, order++, step));
    }

    /** {@inheritDoc} The steps are taken by {@link #runDue}, on its thread, and throw there. */
    @Override
    public Timer timer(String name, Consumer<RuntimeException> failed) {
        return new Timer() {

            private volatile boolean closed;

            @Override
            public long millis() {
                return passed();
            }

            @Override
            public void after(long millis, Runnable step) {
                VirtualClock.this.after(millis, () -> {
                    if (!closed) {
                        step.run();
                    }
                });
            }

            @Override
            public void close() {
                closed = true;
            }
        };
    }

    /** Does all that is due. Tells whether something was. */
    boolean runDue() {
        boolean any = false;
        for (Step step = next(passed()); step != null; step = next(passed())) {
            step.what.run();
            any = true;
        }
        return any;
    }

    private synchronized Step next(long until) {
        return steps.isEmpty() || steps.peek().at > until ? null : steps.poll();
    }

    /** Goes on to what is to be done next, or to that time if nothing is before. */
    synchronized void advance(long until) {
        now = Math.max(now, steps.isEmpty() ? until : Math.min(until, steps.peek().at));
    }

    /** Lets that much time pass, and does all that is due. */
    void run(long millis) {
        long until = passed() + millis;
        do {
            advance(until);
            runDue();
        } while (passed() < until);
    }
}
