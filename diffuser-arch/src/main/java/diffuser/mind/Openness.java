package diffuser.mind;

import java.util.Arrays;
import java.util.Set;

/**
 * How open a MAS is: the paper's definitions 2 to 5 and its table 1 (section 2), and the finite-state machine of its
 * figure 1, whose four symbols are the two abilities lost and restored.
 *
 * <pre>{@code
 *                        -mob
 *          Open  --------------------->  Closed
 *         |    ^ <---------------------  |    ^
 *    -com |    |         +mob       -com |    |
 *         |    | +com                    |    | +com
 *         v    |         -mob            v    |
 *     Limited Open  -------------->  Totally Closed
 *                   <--------------
 *                        +mob
 * }</pre>
 *
 * <p>The paper's text names the states, the symbols and, in table 1, what each state can do; the eight transitions
 * follow, as each state is one set of abilities. It is silent about a symbol that says nothing new, such as +com where
 * there is communicability: here the state stays.
 */
public enum Openness {
    /** Definition 5: agents neither enter nor leave the MAS, nor do they communicate directly with another's. */
    TOTALLY_CLOSED("totallyClosed", Set.of()),
    /**
     * Definition 4: mobile agents enter and leave the MAS, but there is no direct communication with another's agents.
     */
    LIMITED_OPEN("limitedOpen", Set.of(Ability.MOB)),
    /** Definition 3: agents neither enter nor leave the MAS, but they communicate directly with another's. */
    CLOSED("closed", Set.of(Ability.COM)),
    /** Definition 2: mobile agents enter and leave the MAS, and agents communicate directly with another's. */
    OPEN("open", Set.of(Ability.COM, Ability.MOB));

    private final String atom;
    private final Set<Ability> abilities;

    Openness(String atom, Set<Ability> abilities) {
        this.atom = atom;
        this.abilities = abilities;
    }

    /** The state of a MAS that has these abilities, and no others. */
    public static Openness of(Set<Ability> abilities) {
        return Arrays.stream(values()).filter(state -> state.abilities.equals(abilities)).findFirst().orElseThrow();
    }

    /** Its name in beliefs, as in {@code openness(totallyClosed)}. */
    public String atom() {
        return atom;
    }

    /** Abilities of a MAS in this state (table 1). */
    public Set<Ability> abilities() {
        return abilities;
    }
}
