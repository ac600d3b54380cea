package uppaal.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import uppaal.ModelException;

class QueryFileTest {
    @Test
    void parse_queries_haveNameVerdictAndSentence() {
        assertEquals(List.of(
                new Query("P1", true, "it never stops.", "A[] not deadlock", "m.q, line 3"),
                new Query("P2", false, "x: nothing, or so.", "E<> a && b", "m.q, line 7")),
                QueryFile.parse("m.q", "// a file\n/* P1 holds: it never stops. */\nA[] not deadlock\n\n"
                        + "/* P2 fails: x: nothing, or so. */\nE<> a \\\n   && b\n"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '#', quoteCharacter = '"', value = {
            "A[] x # m.q, line 1: a comment must stand before it: /* NAME holds|fails: what it says. */",
            "/* P1 is nice. */ # m.q, line 1: a comment must be one line: /* NAME holds|fails: what it says. */",
            "/* P1 holds: over two # m.q, line 1: a comment must be one line: /* NAME holds|fails: what it says. */",
            "/* P1 holds: something. */ # m.q: no property follows its last comment",
            "/* P1 holds: a. */;E<> x \\ # m.q: its last line promises another one"})
    void parse_wrong_saysWhat(String text, String message) {
        assertEquals(message, assertThrows(ModelException.class,
                () -> QueryFile.parse("m.q", text.replace(';', '\n'))).getMessage());
    }
}
