package uppaal.document;

/**
 * A location of a template.
 *
 * @param name its name, or its id where the file gives no name
 * @param haste whether time may pass here
 * @param invariant the condition that must be true as long as an automaton is here, empty for none
 */
public record Location(String name, Haste haste, String invariant) {
    /** How soon a location must be left. */
    public enum Haste {
        /** Whenever its invariant lets it. */
        NONE,
        /** Before any time passes. */
        URGENT,
        /** By the very next move. */
        COMMITTED
    }

    /** An ordinary location or a committed one. */
    public Location(String name, boolean committed, String invariant) {
        this(name, committed ? Haste.COMMITTED : Haste.NONE, invariant);
    }

    /** Whether no time passes while an automaton is here. */
    public boolean urgent() {
        return haste != Haste.NONE;
    }

    /** Whether it must be left by the very next move. */
    public boolean committed() {
        return haste == Haste.COMMITTED;
    }
}
