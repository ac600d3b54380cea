package uppaal.conformance;

import java.util.Locale;

/** What a board does after so much quiet air; this one at any time, as the trace does not tell enough of it. */
class Timer {
    static final Timer NONE = new Timer("");

    private final String what;

    Timer(String what) {
        this.what = what;
    }

    /** When it is due if the air stays as it is, but for a step of the clock. */
    Interval due() {
        return Interval.ANY;
    }

    /** The board's air has become busy. */
    void busy() {}

    /** The board has done nothing up to the run() before. */
    void checkNotLate(Point point) throws RefusedException {
        double latest = due().most();
        if (latest < Double.POSITIVE_INFINITY
                && latest + PhysicalLimits.MILLIS_STEP_SECONDS < point.run() - point.gap()) {
            throw new RefusedException(
                    String.format(Locale.ROOT, "%s has not done what its timer was for by %.6f s", point.board(), point.run()),
                    String.format(Locale.ROOT, "%s at its first run() after %.6f s", what, latest));
        }
    }

    /** It does it now. */
    void checkNotEarly(Point point) throws RefusedException {
        double earliest = due().least();
        if (point.run() + PhysicalLimits.MILLIS_STEP_SECONDS < earliest) {
            throw new RefusedException(point + " too early", earliest == Double.POSITIVE_INFINITY ? "quiet air"
                    : String.format(Locale.ROOT, "%.6f s or later", earliest));
        }
    }
}
