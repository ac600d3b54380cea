package javino.protocol;

import java.util.Optional;

/** How a transmission ended (SPEC 4.3, record {@code T}). The ordinal is the value on the line. */
public enum Outcome {
    /** A broadcast or multicast has been on the air; nobody knows which devices received it. */
    SENT,
    /** The receiver's host has taken a unicast, and its board has proved it (SPEC 7.2). */
    DELIVERED,
    /** There is no proof that a unicast was delivered; it may have arrived all the same. */
    UNDELIVERED;

    private static final Outcome[] VALUES = values();

    /** The outcome of a value on the line, if there is one. */
    public static Optional<Outcome> of(int value) {
        return value >= 0 && value < VALUES.length ? Optional.of(VALUES[value]) : Optional.empty();
    }
}
