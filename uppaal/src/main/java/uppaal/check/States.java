package uppaal.check;

import java.util.Arrays;
import java.util.List;
import uppaal.network.Slot;

/**
 * A set of states, numbered in the order in which they came. Each takes as many bits as its slots' ranges need, in a
 * few {@code long}s of one large array, so that millions fit.
 */
public final class States {
    private static final int NOWHERE = -1;

    /**
     * For each slot: its least value, the {@code long} that holds it, the place of its lowest bit there, and its
     * bits.
     */
    private final int[] low;
    private final int[] word;
    private final int[] shift;
    private final long[] mask;
    private final int width;
    private final long[] packed;
    private long[] data = new long[1 << 10];
    /** The numbers of states, each near where its hash points to. */
    private int[] table = filled(1 << 10);
    private int size;

    /** No states yet, of a network with these slots. */
    public States(List<Slot> slots) {
        low = new int[slots.size()];
        word = new int[slots.size()];
        shift = new int[slots.size()];
        mask = new long[slots.size()];
        int at = 0;
        for (int i = 0; i < slots.size(); i++) {
            Slot slot = slots.get(i);
            int bits = Long.SIZE - Long.numberOfLeadingZeros((long) slot.high() - slot.low());
            if (at / Long.SIZE != (at + Math.max(bits, 1) - 1) / Long.SIZE) {
                at = (at / Long.SIZE + 1) * Long.SIZE;
            }
            low[i] = slot.low();
            word[i] = at / Long.SIZE;
            shift[i] = at % Long.SIZE;
            mask[i] = (1L << bits) - 1;
            at += bits;
        }
        width = Math.max(1, (at + Long.SIZE - 1) / Long.SIZE);
        packed = new long[width];
    }

    private static int[] filled(int length) {
        int[] table = new int[length];
        Arrays.fill(table, NOWHERE);
        return table;
    }

    /** How many there are. */
    public int size() {
        return size;
    }

    /** Adds a state if it is new, and then its number is the size that the set had. */
    public int add(int[] state) {
        Arrays.fill(packed, 0);
        for (int i = 0; i < low.length; i++) {
            packed[word[i]] |= ((long) state[i] - low[i]) << shift[i];
        }
        int at = hash(packed, 0) & table.length - 1;
        while (table[at] != NOWHERE) {
            if (isAt(table[at] * width)) {
                return table[at];
            }
            at = at + 1 & table.length - 1;
        }
        table[at] = size;
        if ((size + 1) * width > data.length) {
            data = Arrays.copyOf(data, data.length * 2);
        }
        System.arraycopy(packed, 0, data, size * width, width);
        size++;
        if (size > table.length / 2) {
            enlarge();
        }
        return size - 1;
    }

    private boolean isAt(int place) {
        for (int i = 0; i < width; i++) {
            if (data[place + i] != packed[i]) {
                return false;
            }
        }
        return true;
    }

    /** Reads the state of a number into the first places of an array. */
    public void read(int number, int[] state) {
        for (int i = 0; i < low.length; i++) {
            state[i] = (int) (data[number * width + word[i]] >>> shift[i] & mask[i]) + low[i];
        }
    }

    private void enlarge() {
        table = filled(table.length * 2);
        for (int number = 0; number < size; number++) {
            int at = hash(data, number * width) & table.length - 1;
            while (table[at] != NOWHERE) {
                at = at + 1 & table.length - 1;
            }
            table[at] = number;
        }
    }

    private int hash(long[] words, int place) {
        long hash = 0;
        for (int i = 0; i < width; i++) {
            hash = (hash ^ words[place + i]) * 0x9E3779B97F4A7C15L;
            hash ^= hash >>> 32;
        }
        return (int) hash;
    }
}
