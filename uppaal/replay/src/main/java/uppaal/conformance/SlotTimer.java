package uppaal.conformance;

/**
 * What a board does after so many quiet slots in a row and some that it has drawn, which it counts on after each
 * carrier (SPEC 7.4).
 */
final class SlotTimer extends Timer {
    private final BoardAir air;
    private final int first;
    private final double begun;
    /** The slots of the present quiet that do not count. */
    private Interval passed;
    /** The drawn ones that are left behind them. */
    private Interval left;

    /** @param first the slots in a row, of which the present quiet's may be some */
    SlotTimer(BoardAir air, Point point, int first, int drawn, String what) {
        super(what);
        this.air = air;
        this.first = first;
        begun = point.seconds();
        passed = air.isBusy() ? Interval.of(first) : air.slots(air.quiet().from(), point.run()).atLeast(first);
        left = Interval.of(drawn);
    }

    @Override
    Interval due() {
        if (air.isBusy()) {
            return Interval.NEVER;
        }
        Interval due = passed.plus(left).times(air.slot()).plus(Interval.of(air.quiet().from()));
        return new Interval(due.least(), Math.max(begun, due.most()));
    }

    @Override
    void busy() {
        Interval counted = air.slots(air.quiet().from(), air.quiet().last()).atLeast(first).minus(passed).atLeast(0);
        left = left.minus(counted).atLeast(0);
        passed = Interval.of(first);
    }
}
