package keyagreement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.security.SecureRandom;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import javino.protocol.Bytes;
import org.junit.jupiter.api.Test;

class LimitsTest {

    @Test
    void fragments_forgedOnesBetween_doNotDisplaceTheGenuine() {
        Fragments fragments = new Fragments(2);
        assertEquals(List.of(), fragments.add(0, Bytes.of(1)));
        assertEquals(1, fragments.lacking().orElseThrow());
        assertEquals(List.of(), fragments.add(0, Bytes.of(9)));
        assertEquals(List.of(Bytes.of(1, 8), Bytes.of(9, 8)), fragments.add(1, Bytes.of(8)));
        assertEquals(List.of(Bytes.of(1, 2), Bytes.of(9, 2)), fragments.add(1, Bytes.of(2)));
        assertEquals(List.of(), fragments.add(1, Bytes.of(2)), "known already");
        assertTrue(fragments.lacking().isEmpty());
    }

    @Test
    void sparingly_askedAllTheTime_keepsItsGapsAndNobodyKnowsThem() {
        RateLimiter sparingly = new RateLimiter(new SecureRandom());
        long[] taken = LongStream.range(0, 100 * RateLimiter.GAP_MILLIS).filter(sparingly::take).toArray();
        long[] gaps = IntStream.range(1, taken.length).mapToLong(i -> taken[i] - taken[i - 1]).toArray();
        assertTrue(
                LongStream.of(gaps).allMatch(gap -> gap >= RateLimiter.GAP_MILLIS && gap < 3 * RateLimiter.GAP_MILLIS));
        assertTrue(LongStream.of(gaps).distinct().count() > gaps.length / 2, () -> Arrays.toString(gaps));
    }
}
