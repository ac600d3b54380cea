package diffuser;

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
 * follow. It is silent about a symbol that says nothing new, such as +com where there is communicability: here the
 * state stays.
 */
public enum Openness {
    /** Definition 5: agents neither enter nor leave the MAS, nor do they communicate directly with another's. */
    TOTALLY_CLOSED("totallyClosed", false, false),
    /** Definition 4: mobile agents enter and leave the MAS, but there is no direct communication with another's agents. */
    LIMITED_OPEN("limitedOpen", false, true),
    /** Definition 3: agents neither enter nor leave the MAS, but they communicate directly with another's. */
    CLOSED("closed", true, false),
    /** Definition 2: mobile agents enter and leave the MAS, and agents communicate directly with another's. */
    OPEN("open", true, true);

    private final String atom;
    private final boolean communicability;
    private final boolean mobility;

    Openness(String atom, boolean communicability, boolean mobility) {
        this.atom = atom;
        this.communicability = communicability;
        this.mobility = mobility;
    }

    /** What an agent calls it, as in {@code openness(totallyClosed)}. */
    public String atom() {
        return atom;
    }

    /** Whether a MAS in this state has an ability (table 1). */
    public boolean allows(Ability ability) {
        return switch (ability) {
            case COM -> communicability;
            case MOB -> mobility;
        };
    }

    /** The state after -com or -mob. */
    public Openness lost(Ability ability) {
        return with(ability, false);
    }

    /** The state after +com or +mob. */
    public Openness restored(Ability ability) {
        return with(ability, true);
    }

    private Openness with(Ability ability, boolean allowed) {
        return switch (ability) {
            case COM -> of(allowed, mobility);
            case MOB -> of(communicability, allowed);
        };
    }

    private static Openness of(boolean communicability, boolean mobility) {
        if (communicability) {
            return mobility ? OPEN : CLOSED;
        }
        return mobility ? LIMITED_OPEN : TOTALLY_CLOSED;
    }
}
