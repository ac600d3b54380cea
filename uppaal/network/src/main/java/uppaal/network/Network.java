package uppaal.network;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import uppaal.language.Names;
import uppaal.language.Scope;
import uppaal.language.Term;

/**
 * A network of automata that can run: all names resolved, all parameters filled in.
 *
 * @param file the file that it comes from, for messages
 * @param slots the parts of a state, one {@code int} each
 * @param automata in the order of the system line, in which those that hear a broadcast make their assignments
 * @param global the meanings of the global names
 */
public record Network(String file, List<Slot> slots, List<Automaton> automata, Scope global) implements Names {

    /** The name that UPPAAL's queries have for a state without a next one. */
    public static final String DEADLOCK = "deadlock";

    /** Copies the lists, so that a network never changes. */
    public Network {
        slots = List.copyOf(slots);
        automata = List.copyOf(automata);
    }

    /** The first state. */
    public int[] initial() {
        return slots.stream().mapToInt(Slot::initial).toArray();
    }

    /** Whether any time passes in it. */
    public boolean timed() {
        return slots.stream().anyMatch(Slot::clock);
    }

    /**
     * The slot that a query's term reads for {@code deadlock}. It is one past the last of {@link #slots()},
     * since no move reads it: {@link #observed(int[], boolean)} adds it.
     */
    public int deadlockSlot() {
        return slots.size();
    }

    /** A state as queries see it. */
    public int[] observed(int[] state, boolean deadlocked) {
        int[] observed = Arrays.copyOf(state, slots.size() + 1);
        observed[deadlockSlot()] = deadlocked ? 1 : 0;
        return observed;
    }

    @Override
    public Optional<Term> term(String name) {
        return name.equals(DEADLOCK) ? Optional.of(new Term.Variable(deadlockSlot())) : global.term(name);
    }

    @Override
    public Optional<Term> member(String automaton, String name) {
        return automata.stream().filter(candidate -> candidate.name().equals(automaton)).findFirst()
                .flatMap(found -> location(found, name).or(() -> found.scope().local(name)));
    }

    private static Optional<Term> location(Automaton automaton, String name) {
        for (int i = 0; i < automaton.locations().size(); i++) {
            if (automaton.locations().get(i).name().equals(name)) {
                return Optional.of(new Term.At(automaton.slot(), i));
            }
        }
        return Optional.empty();
    }
}
