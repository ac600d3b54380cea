package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.Arrays;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** The paper's table 1 and figure 1. */
class OpennessTest {

    private static final int TRANSITIONS = 8;

    /** The state after a symbol of the figure's alphabet, such as {@code -com}. */
    static Openness after(Openness state, String symbol) {
        Ability ability = Ability.valueOf(symbol.substring(1).toUpperCase());
        return symbol.charAt(0) == '+' ? state.restored(ability) : state.lost(ability);
    }

    @ParameterizedTest
    @CsvSource({
        // state,          mobility, communicability, as an atom
        "TOTALLY_CLOSED,   false,    false,           totallyClosed",
        "LIMITED_OPEN,     true,     false,           limitedOpen",
        "CLOSED,           false,    true,            closed",
        "OPEN,             true,     true,            open",
    })
    void state_allowsWhatTableOneSays(Openness state, boolean mobility, boolean communicability, String atom) {
        assertEquals(mobility, state.allows(Ability.MOB));
        assertEquals(communicability, state.allows(Ability.COM));
        assertEquals(atom, state.atom());
    }

    @ParameterizedTest
    @FigureOne
    void symbol_changesTheStateAsInFigureOne(Openness from, String symbol, Openness to) {
        assertSame(to, after(from, symbol));
    }

    @ParameterizedTest
    @CsvSource({
        "OPEN, +com", "OPEN, +mob", "CLOSED, +com", "CLOSED, -mob",
        "LIMITED_OPEN, -com", "LIMITED_OPEN, +mob", "TOTALLY_CLOSED, -com", "TOTALLY_CLOSED, -mob",
    })
    void symbol_saysNothingNew_stateStays(Openness state, String symbol) {
        assertSame(state, after(state, symbol));
    }

    @Test
    void figure_hasEightTransitions() {
        long count = Arrays.stream(Openness.values()).flatMap(state -> Arrays.stream(new String[] {
            "-com", "+com", "-mob", "+mob"}).filter(symbol -> after(state, symbol) != state)).count();
        assertEquals(TRANSITIONS, count);
    }

    @ParameterizedTest
    @EnumSource
    void lostAndRestored_oneAfterTheOther_leadBack(Openness state) {
        for (Ability ability : Ability.values()) {
            assertSame(state, state.allows(ability) ? state.lost(ability).restored(ability)
                    : state.restored(ability).lost(ability));
        }
    }
}
