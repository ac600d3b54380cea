package uppaal.conformance;

/** The air of a board, as that declares it at each run(): busy, or quiet since when. */
final class DeclaredAir {
    private final double slot;
    private final double step;
    private final double second;
    private boolean isBusy = true;
    private double quietSince;

    /**
     * @param slot how long a slot is, in seconds; 0 where timers are not known, as of serial modules
     * @param step of the board's clock of milliseconds, in seconds
     */
    DeclaredAir(double slot, double step) {
        this(slot, step, 1);
    }

    /** @param second of the board's clock, in seconds: a clock that is fast has shorter ones */
    DeclaredAir(double slot, double step, double second) {
        this.slot = slot * second;
        this.step = step;
        this.second = second;
    }

    double second() {
        return second;
    }

    boolean isTimed() {
        return slot > 0;
    }

    double slot() {
        return slot;
    }

    double step() {
        return step;
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
        return isBusy ? 0 : Math.max(0, Math.floor((run - quietSince - step) / slot));
    }

    /** And if it counts many. */
    double slotsAtMost(double run) {
        return isBusy ? 0 : Math.max(0, Math.floor((run - quietSince + step) / slot));
    }
}
