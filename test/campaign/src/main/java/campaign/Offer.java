package campaign;

import java.util.Random;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/** Something that happens at random times, as often as told on average, each time independent of the others (Poisson). */
final class Offer {

    private final ScheduledExecutorService clock;
    private final Random random;
    private final double meanSeconds;
    private final long end;
    private final Runnable what;
    private long due;

    /**
     * @param meanSeconds from one time to the next.
     * @param end         the time of {@link System#nanoTime} after which it happens no more.
     */
    Offer(ScheduledExecutorService clock, long seed, double meanSeconds, long end, Runnable what) {
        this.clock = clock;
        this.random = new Random(seed);
        this.meanSeconds = meanSeconds;
        this.end = end;
        this.what = what;
        this.due = System.nanoTime();
        next();
    }

    private void next() {
        // From when it was due, not from when it happened: a clock that is late must not lower the rate.
        due += (long) (-Math.log(1 - random.nextDouble()) * meanSeconds * 1e9);
        if (due - end < 0) clock.schedule(this::happen, due - System.nanoTime(), TimeUnit.NANOSECONDS);
    }

    private void happen() {
        what.run();
        next();
    }
}
