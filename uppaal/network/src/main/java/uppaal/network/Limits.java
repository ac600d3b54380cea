package uppaal.network;

import uppaal.language.Operator;

/**
 * The largest numbers that a clock is compared with before it is reset; -1 where there is none.
 *
 * @param lower as in {@code clock >= lower}: it may be waited for
 * @param upper as in {@code clock <= upper}: it may be too late for it
 */
record Limits(int lower, int upper) {
    private static final int NOTHING = -1;
    /** Those of a clock that nothing is compared with. */
    static final Limits NONE = new Limits(NOTHING, NOTHING);

    static Limits of(Operator operator, int number) {
        return new Limits(operator == Operator.AT_MOST ? NOTHING : number,
                operator == Operator.AT_LEAST ? NOTHING : number);
    }

    Limits and(Limits other) {
        return new Limits(Math.max(lower, other.lower), Math.max(upper, other.upper));
    }

    /** With these a time allows what another does only where both are past all that the clock is compared with. */
    Limits exact() {
        int largest = Math.max(lower, upper);
        return new Limits(largest + 1, largest);
    }

    /** Whether a time of the clock allows all that another one does, at once and after any wait. */
    boolean allows(int time, int other) {
        return time == other || (time < other ? time >= lower : other > upper);
    }
}
