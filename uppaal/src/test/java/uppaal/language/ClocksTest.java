package uppaal.language;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import uppaal.ModelException;
import uppaal.Sketch;
import uppaal.check.Property;
import uppaal.network.Network;

class ClocksTest {
    private static final String SUBSET =
            "what is said of a clock here (only 'clock <= n', 'clock >= n' and 'clock == n', joined by '&&', are read)";

    private static Network network(String edge) {
        return Sketch.of("clock x, y; int[0,5] n;").template("P", edge).network();
    }

    private static String refusal(String edge) {
        return assertThrows(ModelException.class, () -> network(edge)).getMessage();
    }

    @ParameterizedTest
    @ValueSource(strings = {"x < 3", "x > 3", "x != 3", "x <= y", "x <= y + 1", "!(x <= 3)", "n == 1 || x <= 3", "x",
            "3 >= x",
            "x + 1 <= 3", "x <= 3 imply n == 1", "-x <= 3", "n == 1 && x < 2"})
    void guard_openOrDiagonal_isRefused(String guard) {
        assertEquals(
                "sketch, template P, edge a -> b, guard: " + SUBSET + " is outside the subset that this checker reads",
                refusal("a -> b; guard " + guard));
    }

    @ParameterizedTest
    @CsvSource({"x>=3", "x==3", "n==0&&x>=1"})
    void invariant_otherThanAtMost_isRefused(String invariant) {
        assertEquals("sketch, template P, location a, invariant: an invariant that compares a clock by other than '<='"
                + " is outside the subset that this checker reads", refusal("a{" + invariant + "} -> b"));
    }

    @ParameterizedTest
    @CsvSource({"x = 1, a clock that is set to other than 0", "x = y, a clock that is set to other than 0",
            "n = x, a clock whose time is stored", "n = n + x, a clock whose time is stored"})
    void assignment_otherThanAReset_isRefused(String assignment, String what) {
        assertEquals(
                "sketch, template P, edge a -> b, assignment: " + what
                        + " is outside the subset that this checker reads",
                refusal("a -> b; set " + assignment));
    }

    @ParameterizedTest
    @CsvSource({"x <= 3, 4", "x >= 2 && x <= n + 2, 8", "n == 4, 1", "x == 0 && y <= 9, 1"})
    void clock_isCountedOnePastItsLargestNumber(String guard, int high) {
        assertEquals(high, network("a -> b; guard " + guard).slots().get(0).high());
    }

    @Test
    void clock_comparedWithADifference_isRefused() {
        assertEquals("sketch: a clock that is compared with other than a sum of numbers and variables"
                + " is outside the subset that this checker reads", refusal("a -> b; guard x <= n - 1"));
    }

    @Test
    void query_ofAClock_isRefused() {
        assertEquals("here: a clock in a query is outside the subset that this checker reads",
                assertThrows(ModelException.class,
                        () -> Property.parse("A[] x <= 3", network("a -> b; guard x <= 3"), "here")).getMessage());
    }
}
