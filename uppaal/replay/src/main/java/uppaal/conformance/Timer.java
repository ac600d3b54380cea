package uppaal.conformance;

import java.util.Locale;

/** A wait of a board for some quiet slots or milliseconds in a row, and others that count on after each carrier. */
final class Timer {
    /** None, or one of which the trace does not tell enough. */
    static final Timer NONE = new Timer(null, 0, 0, 0, 0, 0, "");
    /** The emulator tells a run() that comes later (emulator/README.md): 40 000 cycles of 8 MHz. */
    private static final double UNTOLD_GAP = 0.005;

    private final BoardAir air;
    private final double begun;
    private final double unit;
    private final int first;
    private final int rounds;
    private final String what;
    /** The units of the present quiet that do not count. */
    private Interval passed;
    /** The others that are left behind them. */
    private Interval left;
    /** The longest time from a run() to the next one, of which each round's end but the last may lose as much. */
    private double longestGap = UNTOLD_GAP;

    /** @param first the units in a row, of which the present quiet's may be some */
    Timer(BoardAir air, double begun, double unit, int first, int further, int rounds, String what) {
        this.air = air;
        this.begun = begun;
        this.unit = unit;
        this.first = first;
        this.rounds = rounds;
        this.what = what;
        passed = air == null || air.isBusy() || begun <= air.quiet().from() ? Interval.of(first) : counted(begun);
        left = Interval.of(further);
    }

    private Interval counted(double until) {
        return BoardAir.units(air.quiet().from(), until, unit).atLeast(first);
    }

    /** When it is due if the air stays as it is, but for a step of the clock. */
    private Interval due() {
        if (air == null || air.isBusy()) {
            return air == null ? Interval.ANY : Interval.NEVER;
        }
        Interval due = passed.plus(left).times(unit).plus(Interval.of(air.quiet().from()));
        return new Interval(due.least(), Math.max(begun, due.most()) + (rounds - 1) * longestGap);
    }

    /** The board's air has become busy; in a run() that sends, what comes behind the send counts none of its units. */
    void busy(Point point) {
        if (air != null) {
            Interval all = new Interval(counted(point.runBefore()).least(), counted(air.quiet().last()).most());
            left = left.minus(all.minus(passed).atLeast(0)).atLeast(0);
            passed = Interval.of(first);
        }
    }

    /** The board has done nothing up to the run() before. */
    void checkNotLate(Point point) throws RefusedException {
        if (air == null || air.isBusy() || first != 0 && air.isLimited()) {
            return;
        }
        longestGap = Math.max(longestGap, point.gap());
        double latest = due().most();
        if (latest + PhysicalLimits.MILLIS_STEP_SECONDS < point.runBefore()) {
            throw new RefusedException(String.format(Locale.ROOT, "%s has not done what its timer was for by %.6f s",
                    point.board(), point.run()),
                    String.format(Locale.ROOT, "%s at its first run() after %.6f s", what, latest));
        }
    }

    /** It does it now; what waits for no slots may be over as a carrier begins. */
    void checkNotEarly(Point point) throws RefusedException {
        boolean isOver = first == 0 && left.least() * unit <= PhysicalLimits.MILLIS_STEP_SECONDS;
        if (air != null && air.isBusy() && isOver) {
            return;
        }
        double earliest = due().least();
        if (point.run() + PhysicalLimits.MILLIS_STEP_SECONDS < earliest) {
            throw new RefusedException(point + " too early", earliest == Double.POSITIVE_INFINITY ? "quiet air"
                    : String.format(Locale.ROOT, "%.6f s or later", earliest));
        }
    }
}
