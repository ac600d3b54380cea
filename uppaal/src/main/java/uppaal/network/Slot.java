package uppaal.network;

/**
 * One number of a state: the location of an automaton or a variable.
 *
 * @param name {@code Police_Sender} for a location, {@code x} or {@code Bus_Sender.acks} for a variable
 * @param low the least value
 * @param high the greatest value
 * @param initial the first value
 */
public record Slot(String name, int low, int high, int initial) {
    /** Whether a value is in the range. */
    public boolean holds(int value) {
        return low <= value && value <= high;
    }
}
