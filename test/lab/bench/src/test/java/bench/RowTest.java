package bench;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** How figures stand in docs/results.md. */
class RowTest {

    @Test
    void claimed_withReferenceAndGoal_hasTheirRatio() {
        assertEquals("- a: **1.0 ms**, 0.50 × 2.0 ms b; goal ≤ 1",
                Row.against("a", "%.1f ms", 1, 2, "b").goal("≤ 1").claim().claimed());
        assertEquals("- a: **1 ms**", Row.of("a", "1 ms").claimed());
    }
}
