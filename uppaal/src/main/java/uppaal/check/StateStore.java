package uppaal.check;

import java.util.Arrays;
import java.util.List;
import uppaal.network.Slot;

/**
 * The set of states that have been found, numbered in the order of finding.
 * Each state takes the bits that its ranges need, in one array for all, so that millions fit.
 */
final class StateStore {
    private static final int FIRST_CAPACITY = 1 << 10;
    private static final int NONE = -1;

    private final int[] low;
    private final int[] bits;
    private final int words;
    private long[] states = new long[0];
    private int[] parents = new int[FIRST_CAPACITY];
    private int[] table = emptyTable(2 * FIRST_CAPACITY);
    private int size;

    StateStore(List<Slot> slots) {
        low = slots.stream().mapToInt(Slot::low).toArray();
        bits = slots.stream().mapToInt(slot -> Integer.SIZE - Integer.numberOfLeadingZeros(slot.high() - slot.low())).toArray();
        words = Math.max(1, countWords());
        states = new long[words * FIRST_CAPACITY];
    }

    /** How many states there are. */
    int size() {
        return size;
    }

    /** The number of the state that a state was first reached from; -1 for the first. */
    int parent(int number) {
        return parents[number];
    }

    /** Adds a state unless it is there already. */
    void add(int[] state, int parent) {
        if (size == parents.length) {
            grow();
        }
        pack(state);
        int place = place(size);
        if (table[place] == NONE) {
            table[place] = size;
            parents[size] = parent;
            size++;
        }
    }

    /** The state of a number. */
    int[] get(int number) {
        int[] state = new int[bits.length];
        int word = number * words;
        int used = 0;
        for (int i = 0; i < bits.length; i++) {
            if (used + bits[i] > Long.SIZE) {
                word++;
                used = 0;
            }
            state[i] = low[i] + (int) (states[word] >>> used & mask(bits[i]));
            used += bits[i];
        }
        return state;
    }

    /** Writes a state behind the last one; no value is divided between two words. */
    private void pack(int[] state) {
        int word = size * words;
        int used = 0;
        Arrays.fill(states, word, word + words, 0);
        for (int i = 0; i < bits.length; i++) {
            if (used + bits[i] > Long.SIZE) {
                word++;
                used = 0;
            }
            states[word] |= (long) (state[i] - low[i]) << used;
            used += bits[i];
        }
    }

    private int countWords() {
        int word = 1;
        int used = 0;
        for (int width : bits) {
            if (used + width > Long.SIZE) {
                word++;
                used = 0;
            }
            used += width;
        }
        return word;
    }

    /** Where in the table the packed state of a number is, or would be. */
    private int place(int number) {
        int place = hash(number) & table.length - 1;
        while (table[place] != NONE && !same(table[place], number)) {
            place = place + 1 & table.length - 1;
        }
        return place;
    }

    private boolean same(int one, int other) {
        return Arrays.equals(states, one * words, (one + 1) * words, states, other * words, (other + 1) * words);
    }

    private int hash(int number) {
        long hash = 0;
        for (int i = number * words; i < (number + 1) * words; i++) {
            hash = (hash ^ states[i]) * 0x9E3779B97F4A7C15L;
            hash ^= hash >>> 32;
        }
        return (int) hash;
    }

    private void grow() {
        int capacity = 2 * parents.length;
        states = Arrays.copyOf(states, Math.multiplyExact(words, capacity));
        parents = Arrays.copyOf(parents, capacity);
        table = emptyTable(2 * capacity);
        for (int number = 0; number < size; number++) {
            table[place(number)] = number;
        }
    }

    private static long mask(int width) {
        return (1L << width) - 1;
    }

    private static int[] emptyTable(int length) {
        int[] table = new int[length];
        Arrays.fill(table, NONE);
        return table;
    }
}
