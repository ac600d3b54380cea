package uppaal.conformance;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/**
 * When a board found the air busy, by its own declaration: from BUSY or a send of its own to QUIET. Quiet slots count
 * from QUIET (SPEC 7.4).
 */
final class QuietAir {
    private static final int KEPT = 64;

    /**
     * A change.
     *
     * @param before when the run() before found it as it was before, in seconds
     */
    private record Change(Point point, boolean isBusy, double before, double seconds) {}

    private final Deque<Change> changes = new ArrayDeque<>();
    private boolean isBusy = true;
    private double since;

    /** Takes notice of a point of this board. */
    void point(Point point) {
        boolean sends = AirCheck.SENDS.contains(point.name());
        boolean isNews = sends || (isBusy ? point.is("QUIET") : point.is("BUSY"));
        if (isNews) {
            isBusy = !point.is("QUIET");
            since = point.run();
            changes.addLast(new Change(point, isBusy, sends ? point.run() : point.run() - point.gap(), point.run()));
            if (changes.size() > KEPT) {
                changes.removeFirst();
            }
        }
    }

    /** The board begins anew: it takes the air for busy. */
    void reset(double seconds) {
        changes.clear();
        isBusy = true;
        since = seconds;
    }

    boolean isBusy() {
        return isBusy;
    }

    /** Since when it is as it is, in seconds. */
    double since() {
        return since;
    }

    /** A send of the board's whose run() began in a time when it should have heard another's carrier. */
    Optional<Point> sentWithin(double from, double to) {
        return changes.stream().map(Change::point)
                .filter(point -> AirCheck.SENDS.contains(point.name()) && point.run() > from && point.run() < to)
                .findFirst();
    }

    /** When it should have found the air busy that it has found busy before a moment; infinite if it never did. */
    double busySince(double moment) {
        double since = changes.isEmpty() || changes.getFirst().seconds() > moment ? Double.NEGATIVE_INFINITY
                : Double.POSITIVE_INFINITY;
        for (Change change : changes) {
            if (change.seconds() > moment) {
                break;
            }
            since = change.isBusy() ? Math.min(since, change.before()) : Double.POSITIVE_INFINITY;
        }
        return since;
    }
}
