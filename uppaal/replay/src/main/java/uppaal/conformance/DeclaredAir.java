package uppaal.conformance;

/** The air of a board, as that declares it at each run(): busy, or quiet since when. */
final class DeclaredAir {
    private final double slot;
    private final double second;
    private boolean isBusy = true;
    private double quietSince;

    DeclaredAir(Header header, String board) {
        second = header.second(board);
        slot = header.slot() * second;
    }

    /** What comes after so many quiet slots in a row, and so many drawn ones. */
    Timer slots(Point point, int first, int drawn, String what) {
        return isTimed() ? new SlotTimer(this, point, first, drawn, what) : Timer.NONE;
    }

    /** An answer that is waited for. */
    Timer patience(Point point, int rounds) {
        return isTimed() ? new Patience(this, point, rounds) : Timer.NONE;
    }

    double second() {
        return second;
    }

    /** Whether timers are known: not of serial modules. */
    boolean isTimed() {
        return slot > 0;
    }

    double slot() {
        return slot;
    }

    boolean isBusy() {
        return isBusy;
    }

    /** When the air was found quiet, in seconds; only while it is. */
    double quietSince() {
        return quietSince;
    }

    void busy() {
        isBusy = true;
    }

    void quiet(Point point) {
        isBusy = false;
        quietSince = point.run();
    }

    /** The slots that a board has counted at that time, if it counts few. */
    double slotsAtLeast(double run) {
        return isBusy ? 0 : Math.max(0, Math.floor((run - quietSince - PhysicalLimits.MILLIS_STEP_SECONDS) / slot));
    }

    /** And if it counts many. */
    double slotsAtMost(double run) {
        return isBusy ? 0 : Math.max(0, Math.floor((run - quietSince + PhysicalLimits.MILLIS_STEP_SECONDS) / slot));
    }
}
