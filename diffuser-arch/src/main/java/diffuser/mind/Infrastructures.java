package diffuser.mind;

import java.util.EnumSet;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Literal;

/**
 * The infrastructures by which the MAS communicates and its agents move, and how open it is by them: the board's radio,
 * and others as far as the agent tells. An ability is lost with the last one that gives it. For the agent's thread, but
 * for {@link #openness}.
 */
public final class Infrastructures {

    private final Map<String, Set<Ability>> infrastructures = new HashMap<>();
    private Set<Ability> radio = Set.of();
    private volatile Openness openness = Openness.TOTALLY_CLOSED;
    private Literal belief = belief(openness);

    /** Remembers what another infrastructure allows from now on. */
    public void set(String name, Set<Ability> allows) {
        infrastructures.put(name, allows);
        follow();
    }

    /**
     * {@code openness(S)}; the same object as long as it says the same. Asked in each cycle, so quick where nothing has
     * changed.
     *
     * @param byRadio the abilities by the board's radio.
     */
    public Literal belief(Set<Ability> byRadio) {
        if (!byRadio.equals(radio)) {
            radio = byRadio;
            follow();
        }
        return belief;
    }

    /** How open the MAS was when its agent last asked. */
    public Openness openness() {
        return openness;
    }

    private void follow() {
        Openness now = Openness.of(allowed());
        if (now != openness) {
            openness = now;
            belief = belief(now);
        }
    }

    private Set<Ability> allowed() {
        Set<Ability> all = EnumSet.noneOf(Ability.class);
        infrastructures.values().forEach(all::addAll);
        all.addAll(radio);
        return all;
    }

    private static Literal belief(Openness openness) {
        return ASSyntax.createLiteral("openness", ASSyntax.createAtom(openness.atom()));
    }
}
