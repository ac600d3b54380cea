package uppaal.language;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import uppaal.ModelException;

class LabelsTest {
    private final Scope scope = Scope.global();

    @BeforeEach
    void declare() {
        scope.declare("x", new Symbol.Variable(0), "here");
        scope.declare("N", new Symbol.Number(3), "here");
        scope.declare("send", new Symbol.Channel("send", false), "here");
    }

    @Test
    void labels_empty_meanTrueAndNothing() {
        assertEquals(Term.TRUE, Labels.guard("  ", scope, "here"));
        assertEquals(Optional.empty(), Labels.synchronisation("", scope, "here"));
        assertEquals(List.of(), Labels.assignments(" // nothing", scope, "here"));
    }

    @Test
    void synchronisation_bothDirections_areTold() {
        assertTrue(Labels.synchronisation("send!", scope, "here").orElseThrow().sends());
        assertEquals(new Labels.Synchronisation(new Symbol.Channel("send", false), false),
                Labels.synchronisation("send ?", scope, "here").orElseThrow());
    }

    @Test
    void labels_elementsOfArrays_areTheirOwn() {
        Declarations.global("chan line[4];", scope, null, "here");
        assertEquals(new Symbol.Channel("line[3]", false),
                Labels.synchronisation("line[N]?", scope, "here").orElseThrow().channel());
        scope.declare("a[3]", new Symbol.Variable(7), "here");
        scope.declare("a", new Symbol.Array(4), "here");
        assertEquals(7, Labels.assignments("a[N] = a[N] + 1", scope, "here").get(0).slot());
    }

    @ParameterizedTest
    @CsvSource(delimiter = ';',
            value = {"x = N; 3", "x := x * 2; 10", "x++; 6", "x--; 4", "x = 1, x++; 2", "x++, x = x + x; 12"})
    void assignments_performed_giveTheValue(String text, int expected) {
        int[] state = {5};
        Labels.assignments(text, scope, "here").forEach(one -> state[one.slot()] = one.value().value(state));
        assertEquals(expected, state[0]);
    }

    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {
            "x += 1; expected ':=', not '+='", "N = 1; 'N' is no variable", "y = 1; 'y' is no variable",
            "x = 1,; expected a name, not the end", "x = 1 x = 2; expected the end, not 'x'",
            "send = 1; 'send' is no variable"})
    void assignments_wrong_saysWhat(String text, String message) {
        assertEquals("here: " + message,
                assertThrows(ModelException.class, () -> Labels.assignments(text, scope, "here")).getMessage());
    }

    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {
            "send; expected '?', not the end", "x!; 'x' is no channel", "lost?; 'lost' is no channel",
            "send[1]!; 'send[1]' is no channel",
            "line[x]!; 'line[...]' with an index that is not constant is outside the "
                    + "subset that this checker reads",
            "line!; 'line' is no channel", "send!!; expected the end, not '!'"})
    void synchronisation_wrong_saysWhat(String text, String message) {
        assertEquals("here: " + message,
                assertThrows(ModelException.class, () -> Labels.synchronisation(text, scope, "here")).getMessage());
    }
}
