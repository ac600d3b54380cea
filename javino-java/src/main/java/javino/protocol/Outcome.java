package javino.protocol;

import java.util.Optional;

/** What became of a transmission (SPEC 4.3, record {@code T}). The ordinal is the value on the line. */
public enum Outcome {
    /** The packet has been on the air. */
    SENT;

    private static final Outcome[] VALUES = values();

    /** The outcome of a value on the line, if there is one. */
    public static Optional<Outcome> of(int value) {
        return value >= 0 && value < VALUES.length ? Optional.of(VALUES[value]) : Optional.empty();
    }
}
