package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Locale;
import java.util.Set;

import diffuser.mind.Ability;
import diffuser.mind.Openness;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The paper's table 1 and figure 1. */
class OpennessTest {

    @ParameterizedTest
    @CsvSource({
            // state,          mobility, communicability, as an atom
            "TOTALLY_CLOSED,   false,    false,           totallyClosed",
            "LIMITED_OPEN,     true,     false,           limitedOpen",
            "CLOSED,           false,    true,            closed",
            "OPEN,             true,     true,            open",
    })
    void state_allowsWhatTableOneSays(Openness state, boolean mobility, boolean communicability, String atom) {
        assertEquals(mobility, state.abilities().contains(Ability.MOB));
        assertEquals(communicability, state.abilities().contains(Ability.COM));
        assertEquals(atom, state.atom());
    }

    @ParameterizedTest
    @FigureOne
    void of_abilitiesAfterASymbol_isTheStateOfFigureOne(Openness from, String symbol, Openness to) {
        Set<Ability> abilities = new HashSet<>(from.abilities());
        Ability ability = Ability.valueOf(symbol.substring(1).toUpperCase(Locale.ROOT));
        assertTrue(symbol.startsWith("+") ? abilities.add(ability) : abilities.remove(ability));
        assertEquals(to, Openness.of(abilities));
    }
}
