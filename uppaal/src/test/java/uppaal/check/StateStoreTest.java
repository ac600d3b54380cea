package uppaal.check;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import uppaal.network.Slot;

class StateStoreTest {
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 5, 40})
    void add_randomStates_keepsEachOnce(int slotCount) {
        Random random = new Random(slotCount);
        List<Slot> slots = IntStream.range(0, slotCount).mapToObj(i -> slot(random)).toList();
        StateStore store = new StateStore(slots);
        Set<List<Integer>> known = new HashSet<>();
        List<int[]> inOrder = new ArrayList<>();
        for (int i = 0; i < 20000; i++) {
            int[] state = slots.stream().mapToInt(slot -> slot.low() + random.nextInt(slot.high() - slot.low() + 1)).toArray();
            if (known.add(Arrays.stream(state).boxed().toList())) {
                inOrder.add(state);
            }
            store.add(state, i - 1);
        }
        assertEquals(inOrder.size(), store.size());
        for (int i = 0; i < inOrder.size(); i++) {
            assertArrayEquals(inOrder.get(i), store.get(i));
        }
    }

    @Test
    void add_wholeRangeOfInt_isKept() {
        StateStore store = new StateStore(List.of(new Slot("x", Short.MIN_VALUE, Short.MAX_VALUE, 0), new Slot("y", 7, 7, 7)));
        for (int x = Short.MIN_VALUE; x <= Short.MAX_VALUE; x++) {
            store.add(new int[] {x, 7}, -1);
        }
        assertEquals(1 << 16, store.size());
        assertArrayEquals(new int[] {Short.MAX_VALUE, 7}, store.get(store.size() - 1));
    }

    @Test
    void parent_knownState_staysTheFirst() {
        StateStore store = new StateStore(List.of(new Slot("x", 0, 1, 0)));
        store.add(new int[] {0}, -1);
        store.add(new int[] {1}, 0);
        store.add(new int[] {0}, 1);
        assertEquals(-1, store.parent(0));
        assertEquals(0, store.parent(1));
    }

    private static Slot slot(Random random) {
        int low = random.nextInt(7) - 3;
        return new Slot("s", low, low + random.nextInt(random.nextBoolean() ? 3 : 1000), low);
    }
}
