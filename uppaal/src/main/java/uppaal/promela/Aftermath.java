package uppaal.promela;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import uppaal.language.Labels.Assignment;
import uppaal.language.Operator;
import uppaal.language.Term;
import uppaal.network.Automaton;
import uppaal.network.Network;
import uppaal.network.Transition;

/**
 * What would be true after a step, said of the state before it: Promela has no way to take a step back that has led to
 * where an invariant is false.
 */
final class Aftermath {
    private final Network network;
    private final Map<Integer, Term> changed = new HashMap<>();
    private final Map<Automaton, Integer> moved = new HashMap<>();

    Aftermath(Network network) {
        this.network = network;
    }

    /** An automaton makes its part of the step. */
    void take(Automaton automaton, Transition transition) {
        moved.put(automaton, transition.target());
        for (Assignment assignment : transition.assignments()) {
            assign(assignment.slot(), assignment.value());
        }
    }

    /** What a slot holds is replaced, after all that was replaced before. */
    void assign(int slot, Term value) {
        changed.put(slot, before(value));
    }

    /** All invariants that are to be true afterwards. */
    List<Term> invariants() {
        return network.automata().stream().flatMap(this::invariants).toList();
    }

    private Stream<Term> invariants(Automaton automaton) {
        if (moved.containsKey(automaton)) {
            return said(automaton, moved.get(automaton));
        }
        return IntStream.range(0, automaton.locations().size()).boxed().flatMap(location -> said(automaton, location)
                .map(invariant -> new Term.Binary(Operator.IMPLY, new Term.At(automaton.slot(), location), invariant)));
    }

    private Stream<Term> said(Automaton automaton, int location) {
        Term invariant = automaton.invariant(location);
        return invariant.equals(Term.TRUE) ? Stream.empty() : Stream.of(before(invariant));
    }

    /** A term of the state after the step, as one of the state before it. No invariant asks where an automaton is. */
    private Term before(Term term) {
        if (term instanceof Term.Variable variable) {
            return changed.getOrDefault(variable.slot(), term);
        } else if (term instanceof Term.Clock clock) {
            return changed.getOrDefault(clock.slot(), term);
        } else if (term instanceof Term.Not not) {
            return new Term.Not(before(not.operand()));
        } else if (term instanceof Term.Negative negative) {
            return new Term.Negative(before(negative.operand()));
        } else if (term instanceof Term.Choice choice) {
            return new Term.Choice(before(choice.condition()), before(choice.yes()), before(choice.no()));
        } else if (term instanceof Term.Binary binary) {
            return new Term.Binary(binary.operator(), before(binary.left()), before(binary.right()));
        }
        return term;
    }
}
