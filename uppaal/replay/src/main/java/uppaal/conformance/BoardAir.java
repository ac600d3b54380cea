package uppaal.conformance;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.stream.Stream;

/** The air of a board, as that declares it: busy from BUSY or a send of its own on, quiet from QUIET on (SPEC 7.4). */
final class BoardAir {
    private static final int KEPT = 32;
    /** PATIENCE_MILLIS in the firmware. */
    private static final int ROUND = 150;
    private static final double MILLIS = 1000;

    /**
     * A quiet time, in seconds.
     *
     * @param last when the last run() began that found it quiet; infinite while it goes on
     * @param until and the one that ended it
     * @param isSentInto whether by a send
     */
    record Quiet(double from, double last, double until, boolean isSentInto) {
        boolean isOver() {
            return until < Double.POSITIVE_INFINITY;
        }
    }

    private final Deque<Quiet> quiets = new ArrayDeque<>();
    private final double slot;
    private final double second;
    private boolean isLimited;

    BoardAir(Header header, String board) {
        second = header.second(board);
        slot = header.slot() * second;
    }

    /** Takes notice of a point of the board, and tells whether the air becomes busy or quiet by it. */
    boolean changes(Point point) {
        isLimited |= point.is("AIRTIME_LIMIT");
        if (isBusy() && point.is("QUIET")) {
            quiets.addLast(new Quiet(point.run(), Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, false));
            if (quiets.size() > KEPT) {
                quiets.removeFirst();
            }
            return true;
        }
        boolean isSend = AirCheck.SENDS.contains(point.name());
        if (!isBusy() && (isSend || point.is("BUSY"))) {
            double last = isSend ? point.run() : point.runBefore();
            quiets.addLast(new Quiet(quiets.removeLast().from, last, point.run(), isSend));
            return true;
        }
        return false;
    }

    /** The board begins anew: it takes the air for busy. */
    void reset() {
        quiets.clear();
    }

    boolean isBusy() {
        return quiets.isEmpty() || quiets.getLast().isOver();
    }

    /** The present quiet time, or the last one. */
    Quiet quiet() {
        return quiets.getLast();
    }

    /** The ends of quiet times that the board's sends made. */
    Stream<Double> sends() {
        return quiets.stream().filter(Quiet::isSentInto).map(Quiet::until);
    }

    /** When it should have found the air busy that it found busy before a moment; infinite if it found it quiet. */
    double busySince(double moment) {
        return quiets.stream().filter(quiet -> quiet.from <= moment).reduce((earlier, later) -> later)
                .map(quiet -> quiet.until <= moment ? quiet.last : Double.POSITIVE_INFINITY)
                .orElse(Double.NEGATIVE_INFINITY);
    }

    /** A wait of so many quiet slots in a row, and so many drawn ones. */
    Timer slots(Point point, int first, int drawn, String what) {
        return isTimed() ? new Timer(this, point.run(), slot, first, drawn, 1, what) : Timer.NONE;
    }

    /** An answer that is waited for; what hears a copy counts the time from the run() before. */
    Timer patience(Point point, int rounds, String what) {
        return isTimed() ? new Timer(this, point.runBefore(), second / MILLIS, 0, rounds * ROUND, rounds, what)
                : Timer.NONE;
    }

    /** How long a second of the board's clock is. */
    double second() {
        return second;
    }

    /** Whether what is due may wait on for its airtime (SPEC 7.6). */
    boolean isLimited() {
        return isLimited;
    }

    /** Whether timers are known: not of serial modules. */
    boolean isTimed() {
        return slot > 0;
    }

    double slot() {
        return slot;
    }

    /** The slots or milliseconds that a board counts by its clock from one moment to another. */
    static Interval units(double from, double until, double unit) {
        return new Interval(Math.floor((until - from - PhysicalLimits.MILLIS_STEP_SECONDS) / unit),
                Math.floor((until - from + PhysicalLimits.MILLIS_STEP_SECONDS) / unit)).atLeast(0);
    }

    Interval slots(double from, double until) {
        return units(from, until, slot);
    }
}
