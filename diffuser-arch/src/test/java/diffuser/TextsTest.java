package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TextsTest {

    @ParameterizedTest
    @ValueSource(strings = {"p", "p(1)", "~p(a,\"b c\")", "proximity(17.5)", "p([1,2],q(r))", "p(-3)", "p[source(self)]"})
    void readPercept_belief_readsBackAsItself(String text) throws Exception {
        assertEquals(text, Texts.readPercept(text).toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", " ", "p(", "p)", "p(1) q(2)", "p,q", "p.", "p;q", "X", "p(X)", "_", "3", "\"p\"", "[p]",
        "1+2", "p & q", "not p", "p :- q", ".print(p)", "{ +!p <- q }", "{ !p; !q }", "+!p", "!p", "\u0000", "p(\u0001)",
        "\"", "/*", "p\n)", "java.lang.System.exit(0)",
        "true", "ns::X"})
    void readPercept_anythingElse_isMalformed(String text) {
        assertThrows(MalformedTextException.class, () -> Texts.readPercept(text));
    }

    @Test
    void readContent_randomText_isReadOrMalformedAndNothingElse() {
        Random random = new Random(7);
        String alphabet = "pqX_(),.[]~\"' 19+-*/&|{}<>!?;:@#\\\u0000ü\n";
        for (int i = 0; i < 5_000; i++) {
            StringBuilder text = new StringBuilder();
            for (int length = random.nextInt(12); length > 0; length--) {
                text.append(alphabet.charAt(random.nextInt(alphabet.length())));
            }
            try {
                Texts.readContent(text.toString());
            } catch (MalformedTextException e) {
                assertTrue(e.getMessage().startsWith("\"" + text + "\": "), e.getMessage());
            }
        }
    }

    @Test
    void readContent_deeplyNested_isReadOrMalformed() throws Exception {
        Texts.readContent("p(".repeat(160) + "1" + ")".repeat(160));
    }
}
