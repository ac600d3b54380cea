package keyagreement;

import java.util.Comparator;
import java.util.PriorityQueue;

import diffuser.board.HostClock;

/** A time of its own, for several hosts: nothing waits. */
final class VirtualClock {

    private final PriorityQueue<Step> steps =
            new PriorityQueue<>(Comparator.comparingLong(Step::at).thenComparingLong(Step::order));
    private long now;
    private long order;

    private record Step(long at, long order, Runnable what) {
    }

    synchronized long millis() {
        return now;
    }

    private synchronized void after(long millis, Runnable step) {
        steps.add(new Step(now + millis, order++, step));
    }

    /** The clock of one more host. */
    HostClock ofHost() {
        return new HostClock() {

            private volatile boolean closed;

            @Override
            public long millis() {
                return VirtualClock.this.millis();
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
        for (Step step = next(millis()); step != null; step = next(millis())) {
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
}
