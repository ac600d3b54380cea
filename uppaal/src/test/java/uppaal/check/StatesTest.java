package uppaal.check;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import uppaal.network.Slot;

class StatesTest {
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 5, 40})
    void add_randomStates_haveTheNumbersOfTheirComing(int slots) {
        Random random = new Random(slots);
        List<Slot> ranges = IntStream.range(0, slots).mapToObj(i -> slot(i, random)).toList();
        States states = new States(ranges);
        Map<List<Integer>, Integer> known = new HashMap<>();
        List<int[]> inOrder = new ArrayList<>();
        for (int i = 0; i < 20_000; i++) {
            int[] state = ranges.stream().mapToInt(range -> value(range, random)).toArray();
            List<Integer> key = IntStream.of(state).boxed().toList();
            if (known.putIfAbsent(key, known.size()) == null) {
                inOrder.add(state);
            }
            assertEquals(known.get(key), states.add(state));
        }
        assertEquals(inOrder.size(), states.size());
        int[] read = new int[slots];
        for (int number = 0; number < inOrder.size(); number++) {
            states.read(number, read);
            assertArrayEquals(inOrder.get(number), read);
        }
    }

    @Test
    void add_longestRanges_areKept() {
        Slot whole = new Slot("x", Integer.MIN_VALUE, Integer.MAX_VALUE, 0);
        States states = new States(List.of(whole, new Slot("y", 7, 8, 7), new Slot("z", 9, 9, 9), whole, whole));
        int[] state = {Integer.MIN_VALUE, 8, 9, Integer.MAX_VALUE, -1};
        assertEquals(0, states.add(state));
        int[] read = new int[5];
        states.read(0, read);
        assertArrayEquals(state, read);
    }

    /** Mostly narrow ones, so that states come again. */
    private static Slot slot(int number, Random random) {
        int low = random.nextInt(2000) - 1000;
        return new Slot("s" + number, low, low + random.nextInt(random.nextInt(8) == 0 ? 40_000 : 4), low);
    }

    private static int value(Slot range, Random random) {
        return range.low() + (random.nextBoolean() ? 0 : random.nextInt(range.high() - range.low() + 1));
    }
}
