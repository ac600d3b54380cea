package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class BoundedMapTest {
    @Test
    void put_whatIsInAlready_isForgottenLast() {
        Map<Integer, Integer> recent = new BoundedMap<>();
        IntStream.range(0, 1024).forEach(number -> recent.put(number, number));
        recent.put(0, -1);
        recent.put(1024, 1024);
        Set<Integer> wanted = new TreeSet<>(recent.keySet());
        assertEquals(1024, wanted.size());
        assertEquals(-1, recent.get(0));
        assertEquals(null, recent.get(1));
    }
}
