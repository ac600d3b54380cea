package campaign;

import java.util.SplittableRandom;

/**
 * Something that happens at random times, as often as told on average, each time independent of the others (Poisson).
 */
final class Offer {

    private final Timetable timetable;
    private final SplittableRandom random;
    private final double meanSeconds;
    private final double end;
    private final Runnable what;
    private double due;

    /**
     * @param meanSeconds from one time to the next, emulated.
     * @param end         the emulated time after which it happens no more.
     */
    Offer(Timetable timetable, long seed, double meanSeconds, double end, Runnable what) {
        this.timetable = timetable;
        // Unlike those of Random, its first numbers for seeds in a row are independent of each other.
        this.random = new SplittableRandom(seed);
        this.meanSeconds = meanSeconds;
        this.end = end;
        this.what = what;
        this.due = timetable.now();
        next();
    }

    private void next() {
        // The time counts from when it was due, not from when it happened: lateness must not lower the rate.
        due += -Math.log(1 - random.nextDouble()) * meanSeconds;
        if (due < end) {
            timetable.at(due, this::happen);
        }
    }

    private void happen() {
        what.run();
        next();
    }
}
