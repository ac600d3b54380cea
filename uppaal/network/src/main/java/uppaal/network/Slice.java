package uppaal.network;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import uppaal.language.Labels.Assignment;
import uppaal.language.Term;

/**
 * A network that does not set variables that nobody asks for: neither a formula, a guard or an invariant, nor the value
 * of another variable that is asked for.
 */
final class Slice {
    private final Network network;
    private final Set<Integer> read = new HashSet<>();

    private Slice(Network network) {
        this.network = network;
    }

    /** @param observed the formulas that are asked of its states */
    static Network of(Network network, Collection<Term> observed) {
        return new Slice(network).without(observed);
    }

    private Network without(Collection<Term> observed) {
        List<Assignment> assignments = new ArrayList<>();
        observed.forEach(this::read);
        for (Automaton automaton : network.automata()) {
            IntStream.range(0, automaton.locations().size()).forEach(location -> read(automaton.invariant(location)));
            automaton.transitions().forEach(transition -> {
                read(transition.guard());
                assignments.addAll(transition.assignments());
            });
        }
        while (assignments.removeIf(assignment -> read.contains(assignment.slot()) && read(assignment.value()))) {
            // What was read now may be what another one sets.
        }
        return new Network(network.file(), network.slots(),
                network.automata().stream().map(automaton -> automaton.setting(read)).toList(), network.global());
    }

    private boolean read(Term term) {
        if (term instanceof Term.Variable variable) {
            read.add(variable.slot());
        } else if (term instanceof Term.Clock clock) {
            read.add(clock.slot());
        }
        term.operands().forEach(this::read);
        return true;
    }
}
