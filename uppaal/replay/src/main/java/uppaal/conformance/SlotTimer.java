package uppaal.conformance;

import java.util.Locale;

/**
 * What a board does after so many quiet slots in a row and some that it has drawn, which it counts on after each
 * carrier (SPEC 7.4). A board counts the slots by its clock of milliseconds, so that it may count one more or less
 * before a carrier.
 */
final class SlotTimer implements Timer {
    private final DeclaredAir air;
    private final int first;
    private final double begun;
    private final String what;
    /** The drawn ones that are left, at the least and at the most, before the present quiet. */
    private double least;
    private double most;
    /** The slots of the present quiet that passed before the timer began. */
    private double passedLeast;
    private double passedMost;

    /** @param first the slots in a row, of which the present quiet's may be some */
    SlotTimer(DeclaredAir air, Point point, int first, int drawn, String what) {
        this.what = what;
        this.air = air;
        this.first = first;
        begun = point.seconds();
        least = drawn;
        most = drawn;
        passedLeast = Math.max(first, air.slotsAtLeast(point.run()));
        passedMost = Math.max(first, air.slotsAtMost(point.run()));
    }

    @Override
    public void busy(Point point) {
        double before = point.run() - point.gap();
        if (!air.isBusy()) {
            most -= Math.max(0, Math.max(first, air.slotsAtLeast(before)) - passedMost);
            least -= Math.max(0, Math.max(first, air.slotsAtMost(before)) - passedLeast);
            least = Math.max(0, least);
            most = Math.max(0, most);
        }
        passedLeast = first;
        passedMost = first;
    }

    @Override
    public void checkNotLate(Point point) throws RefusedException {
        double latest = Math.max(begun, air.quietSince() + (passedMost + most) * air.slot());
        if (!air.isBusy() && latest + PhysicalLimits.MILLIS_STEP_SECONDS < point.run() - point.gap()) {
            throw new RefusedException(String.format(Locale.ROOT, "%s has not done what its timer was for by %.6f s",
                    point.board(), point.run()),
                    String.format(Locale.ROOT, "%s at its first run() after %.6f s", what,
                            latest));
        }
    }

    @Override
    public void checkNotEarly(Point point) throws RefusedException {
        double earliest = air.isBusy() ? Double.POSITIVE_INFINITY
                : air.quietSince() + (passedLeast + least) * air.slot();
        if (point.run() + PhysicalLimits.MILLIS_STEP_SECONDS < earliest) {
            throw new RefusedException(point.board() + " declares " + point.name() + " too early",
                    earliest == Double.POSITIVE_INFINITY ? "quiet air"
                            : String.format(Locale.ROOT, "%.6f s or later", earliest));
        }
    }
}
