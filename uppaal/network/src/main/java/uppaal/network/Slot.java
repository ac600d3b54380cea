package uppaal.network;

/**
 * One number of a state: the location of an automaton, a variable or a clock.
 *
 * @param name {@code Police_Sender} for a location, {@code x} or {@code Bus_Sender.acks} for a variable or a clock
 * @param low the least value
 * @param high the greatest value; a clock's stands for itself and all later times
 * @param initial the first value
 * @param clock whether it rises with time
 */
public record Slot(String name, int low, int high, int initial, boolean clock) {
    /** A location or a variable. */
    public Slot(String name, int low, int high, int initial) {
        this(name, low, high, initial, false);
    }

    /**
     * A clock.
     *
     * @param largest the greatest number that it is compared with
     */
    static Slot clock(String name, int largest) {
        return new Slot(name, 0, largest + 1, 0, true);
    }

    /** Whether a value is in the range. */
    public boolean holds(int value) {
        return low <= value && value <= high;
    }
}
