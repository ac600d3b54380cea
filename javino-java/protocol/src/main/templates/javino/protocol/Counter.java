package javino.protocol;

import java.util.Optional;

/** The counters of a board since its boot (SPEC 4.5). */
public enum Counter {
    @Counters.def: /** $2 */ $1("$camel"),
    ;

    private static final Counter[] VALUES = values();

    private final String specName;

    Counter(String specName) {
        this.specName = specName;
    }

    /** The counter of a number on the line, if there is one. */
    public static Optional<Counter> of(int number) {
        return number >= 1 && number <= VALUES.length ? Optional.of(VALUES[number - 1]) : Optional.empty();
    }

    /** The number on the line, from 1. */
    public int number() {
        return ordinal() + 1;
    }

    /** Whether it counts nothing, but is a time: the longest since the boot, or how long the radio has sent or waits. */
    public boolean isTime() {
        return compareTo(LOOP_MILLIS) >= 0;
    }

    /** The name as in SPEC 4.5, such as {@code serialRequests}. */
    @Override
    public String toString() {
        return specName;
    }
}
