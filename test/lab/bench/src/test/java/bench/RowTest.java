package bench;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** How figures stand in docs/results.md. */
class RowTest {

    @Test
    void compared_withReferenceAndGoal_hasTheirRatio() {
        assertEquals("0.50 × 2.0 ms b; goal ≤ 1",
                Row.against("a", "%.1f ms", 1, 2, "b").goal("≤ 1").compared());
        assertEquals("", Row.of("a", "1 ms").compared());
    }
}
