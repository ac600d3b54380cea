package uppaal.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import uppaal.ModelException;
import uppaal.Sketch;
import uppaal.network.Network;

class PropertyTest {
    private static final Network NETWORK =
            Sketch.of("int x; const int N = 3;").template("P", "a -> b; set x = N").network();

    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {
            "A[] P.a || P.b; true", "A[] x == 0; false", "E<> x == N; true", "E<> P.b && x == 0; false",
            "A[] (P.b) imply x == 3; true", "E<> deadlock; true", "A[] not deadlock; false",
            "A[] deadlock imply P.b; true"})
    void holds_property_isAsUppaalHasIt(String text, boolean expected) {
        Property property = Property.parse(text, NETWORK, "here");
        assertEquals(expected, Exploration.of(NETWORK, java.util.List.of(property)).holds(0));
    }

    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {
            "E[] P.b; a query that neither begins with A[], E<> or A<> nor has --> is outside the subset that "
                    + "this checker "
                    + "reads",
            "A<> deadlock; 'deadlock' with A<> or --> is outside the subset that this checker reads",
            "P.a --> not deadlock; 'deadlock' with A<> or --> is outside the subset that this checker reads",
            "P.a --> P.b --> P.a; expected the end, not '--'", "--> P.b; expected a name, not the end",
            "A[] P.c; 'P.c' has no value here", "A[] Q.a; 'Q.a' has no value here", "A[] y; 'y' has no value here",
            "A[] P.a P.b; expected the end, not 'P'", "E<>; expected a name, not the end"})
    void parse_wrong_saysWhat(String text, String message) {
        assertEquals("here: " + message,
                assertThrows(ModelException.class, () -> Property.parse(text, NETWORK, "here")).getMessage());
    }

    @Test
    void implication_onlyOfAlways_isTaken() {
        assertEquals(true, Property.parse("A[] P.a imply x == 0", NETWORK, "here").implication().isPresent());
        assertEquals(false, Property.parse("E<> P.a imply x == 0", NETWORK, "here").implication().isPresent());
        assertEquals(false, Property.parse("A[] P.a", NETWORK, "here").implication().isPresent());
    }
}
