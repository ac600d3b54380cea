package uppaal.conformance;

/** How long a sender waits for an answer: rounds of quiet milliseconds, which go on after each carrier (SPEC 7.3). */
final class Patience extends Timer {
    /** PATIENCE_MILLIS in the firmware. */
    private static final double ROUND = 0.150;
    /** A run() counts no more of the time before it. */
    private static final double MOST_COUNTED = 0.255;
    /** The emulator tells a run() that comes later (emulator/README.md): 40 000 cycles of 8 MHz. */
    private static final double UNTOLD_GAP = 0.005;

    private final BoardAir air;
    private final double begun;
    private final int rounds;
    private double left;
    /** Of the milliseconds of its clock, at each begin and end of a quiet time. */
    private double error;
    /** The longest time from a run() to the next one, of which a round's end may lose as much. */
    private double longestGap = UNTOLD_GAP;
    private double uncounted;

    Patience(BoardAir air, Point point, int rounds, String what) {
        super(what);
        this.air = air;
        this.rounds = rounds;
        left = rounds * ROUND * air.second();
        // What hears a copy counts the time from the run() before.
        begun = point.run() - point.gap();
    }

    @Override
    Interval due() {
        double due = air.isBusy() ? Double.POSITIVE_INFINITY : from() + left;
        return new Interval(due - error, due + error + uncounted + (rounds - 1) * longestGap);
    }

    private double from() {
        return Math.max(begun, air.quiet().from());
    }

    @Override
    void busy() {
        left -= Math.max(0, air.quiet().last() - from());
        error += PhysicalLimits.MILLIS_STEP_SECONDS;
    }

    @Override
    void checkNotLate(Point point) throws RefusedException {
        if (!air.isBusy()) {
            longestGap = Math.max(longestGap, point.gap());
            uncounted += Math.max(0, point.gap() - MOST_COUNTED);
        }
        super.checkNotLate(point);
    }
}
