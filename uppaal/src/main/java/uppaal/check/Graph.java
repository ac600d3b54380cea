package uppaal.check;

import java.util.Arrays;
import java.util.BitSet;

/** The steps from states to states, by their numbers; built in the order of the numbers. */
final class Graph {
    private int[] ends = new int[1 << 10];
    private int[] targets = new int[1 << 10];
    private final BitSet staying = new BitSet();
    private int size;
    private int steps;

    /** A step leads from the state that is being built to another. */
    void lead(int target) {
        if (steps == targets.length) {
            targets = Arrays.copyOf(targets, targets.length * 2);
        }
        targets[steps++] = target;
    }

    /**
     * The state has no more steps, and the next one is to be built.
     *
     * @param stays whether a run may end there: since nothing can happen, or nothing need
     */
    void next(boolean stays) {
        if (size == ends.length) {
            ends = Arrays.copyOf(ends, ends.length * 2);
        }
        staying.set(size, stays);
        ends[size++] = steps;
    }

    int size() {
        return size;
    }

    /** The place of the first step from a state; those of its other steps follow. */
    int begin(int state) {
        return state == 0 ? 0 : ends[state - 1];
    }

    /** The place behind the last step from a state. */
    int end(int state) {
        return ends[state];
    }

    /** The state to which the step of a place leads. */
    int target(int step) {
        return targets[step];
    }

    /** Whether a run may end in a state. */
    boolean stays(int state) {
        return staying.get(state);
    }
}
