package uppaal.check;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import uppaal.language.Clocks;
import uppaal.language.Labels.Assignment;
import uppaal.language.Term;
import uppaal.network.Transition;

/**
 * Finds which clocks an automaton compares from each of its locations on, before they are reset. Any other one of its
 * own is of no consequence; it is kept at 0, so that states that differ in nothing else are one.
 */
final class ActiveClocks {
    private final List<Term> invariants;
    private final List<Transition> transitions;

    ActiveClocks(List<Term> invariants, List<Transition> transitions) {
        this.invariants = invariants;
        this.transitions = transitions;
    }

    /** The slots of the active clocks, for each location. */
    List<Set<Integer>> byLocation() {
        List<Set<Integer>> active = new ArrayList<>();
        IntStream.range(0, invariants.size()).forEach(location -> active.add(compared(location)));
        boolean grows = true;
        while (grows) {
            grows = false;
            for (Transition transition : transitions) {
                Set<Integer> later = new HashSet<>(active.get(transition.target()));
                transition.assignments().forEach(assignment -> later.remove(assignment.slot()));
                grows |= active.get(transition.source()).addAll(later);
            }
        }
        return active;
    }

    /** The transitions, each of which also sets to 0 those of some clocks that matter no longer where it leads. */
    List<Transition> resetting(Set<Integer> own, List<Set<Integer>> active) {
        return transitions.stream().map(transition -> {
            List<Assignment> assignments = new ArrayList<>(transition.assignments());
            own.stream().filter(clock -> !active.get(transition.target()).contains(clock))
                    .forEach(clock -> assignments.add(new Assignment(clock, new Term.Constant(0))));
            return transition.assigning(assignments);
        }).toList();
    }

    /** An invariant behind an urgent step decides whether time may pass before it. */
    private Set<Integer> compared(int location) {
        Set<Integer> compared = in(invariants.get(location));
        transitions.stream().filter(transition -> transition.source() == location).forEach(transition -> {
            compared.addAll(in(transition.guard()));
            if (transition.urgent()) {
                Set<Integer> then = in(invariants.get(transition.target()));
                transition.assignments().forEach(assignment -> then.remove(assignment.slot()));
                compared.addAll(then);
            }
        });
        return compared;
    }

    private static Set<Integer> in(Term condition) {
        Set<Integer> slots = new HashSet<>();
        Clocks.bounds(condition, "").forEach(bound -> slots.add(bound.slot()));
        return slots;
    }
}
