package javino.protocol;

import java.util.Optional;

/** How a board answers a request (SPEC 4.4). The ordinal is the value on the line. */
public enum Status {
    @Statuses.def: /** $2 */ $1("$3"),
    ;

    private static final Status[] VALUES = values();

    private final String explanation;

    Status(String explanation) {
        this.explanation = explanation;
    }

    /** The status of a value on the line, if there is one. */
    public static Optional<Status> of(int value) {
        return value >= 0 && value < VALUES.length ? Optional.of(VALUES[value]) : Optional.empty();
    }

    /** Its meaning and, where something can be done, what; for people. */
    public String explanation() {
        return explanation;
    }
}
