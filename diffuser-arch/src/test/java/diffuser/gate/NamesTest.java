package diffuser.gate;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Term;
import jason.asSyntax.UnnamedVar;
import jason.asSyntax.VarTerm;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NamesTest {

    @ParameterizedTest
    @CsvSource(quoteCharacter = '\0', value = {"COM5,COM5", "ttyACM0,ttyACM0", "\"/dev/x y\",/dev/x y", "'COM5',COM5"})
    void of_nameInAnyForm_isRead(String text, String name) throws Exception {
        assertEquals(Optional.of(name), Names.of(ASSyntax.parseTerm(text)));
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '\0', value = {"_", "_X", "''", "5", "p(1)", "[a]", "\"\""}, delimiter = '|')
    void of_noName_isEmpty(String text) throws Exception {
        assertEquals(Optional.empty(), Names.of(ASSyntax.parseTerm(text)));
    }

    @Test
    void of_variableRenamedByJason_keepsItsName() {
        Term once = UnnamedVar.create("COM5");
        Term twice = UnnamedVar.create(((VarTerm) once).getFunctor());
        assertEquals(Optional.of("COM5"), Names.of(once));
        assertEquals(Optional.of("COM5"), Names.of(twice));
    }

    @Test
    void of_variableWhoseNameJasonDropped_isEmpty() {
        assertEquals(Optional.empty(), Names.of(new UnnamedVar()));
    }
}
