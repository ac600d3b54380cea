package fuzz;

import java.util.Objects;

/** The checks of targets. */
final class Holds {

    private Holds() {
    }

    /** @throws AssertionError naming both, unless they are equal. */
    static void equal(Object expected, Object found, String what) {
        if (!Objects.equals(expected, found)) {
            throw new AssertionError(what + ": expected " + expected + ", found " + found);
        }
    }

    /** @throws AssertionError unless it is so. */
    static void always(boolean condition, String what) {
        if (!condition) {
            throw new AssertionError(what);
        }
    }
}
