package uppaal.conformance;

import java.util.Locale;

/** How long a sender waits for an answer: rounds of quiet milliseconds, which go on after each carrier (SPEC 7.3). */
final class Patience implements Timer {
    /** PATIENCE_MILLIS in the firmware. */
    private static final double ROUND = 0.150;
    /** A run() counts no more of the time before it. */
    private static final double MOST_COUNTED = 0.255;
    /** The emulator tells a run() that comes later (emulator/README.md): 40 000 cycles of 8 MHz. */
    private static final double UNTOLD_GAP = 0.005;

    private final DeclaredAir air;
    private final int rounds;
    private double from;
    private double passed;
    private int periods = 1;
    /** The longest time from a run() to the next one, of which a round's end may lose as much. */
    private double longestGap = UNTOLD_GAP;
    private double uncounted;

    Patience(DeclaredAir air, Point point, int rounds) {
        this.air = air;
        this.rounds = rounds;
        // What hears a copy counts the time from the run() before.
        from = air.isBusy() ? point.run() : Math.max(air.quietSince(), point.run() - point.gap());
    }

    @Override
    public void busy(Point point) {
        passed += quiet(point.run() - point.gap());
    }

    @Override
    public void quiet(Point point) {
        from = point.run();
        periods++;
    }

    private double quiet(double until) {
        return air.isBusy() ? 0 : Math.max(0, until - from);
    }

    @Override
    public void checkNotLate(Point point) throws RefusedException {
        if (!air.isBusy()) {
            longestGap = Math.max(longestGap, point.gap());
            uncounted += Math.max(0, point.gap() - MOST_COUNTED);
        }
        double least = passed + quiet(point.run() - point.gap()) - uncounted - (rounds - 1) * longestGap
                - periods * PhysicalLimits.MILLIS_STEP_SECONDS;
        if (least > rounds * ROUND * air.second()) {
            throw new RefusedException(
                    String.format(Locale.ROOT, "%s still waits after %.3f s of quiet air", point.board(), least),
                    words("ATTEMPT_FAILED after"));
        }
    }

    @Override
    public void checkNotEarly(Point point) throws RefusedException {
        double most = passed + quiet(point.run()) + periods * PhysicalLimits.MILLIS_STEP_SECONDS;
        if (most < rounds * ROUND * air.second()) {
            throw new RefusedException(String.format(Locale.ROOT, "%s declares %s after %.3f s of quiet air",
                    point.board(), point.name(), most), words("it after"));
        }
    }

    private String words(String what) {
        return String.format(Locale.ROOT, "%s %.3f s", what, rounds * ROUND);
    }
}
