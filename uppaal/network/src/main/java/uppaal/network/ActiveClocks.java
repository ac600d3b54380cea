package uppaal.network;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import uppaal.language.Clocks;
import uppaal.language.Labels.Assignment;
import uppaal.language.Term;

/**
 * Finds where in an automaton each of its own clocks matters: where it is compared before it is reset again. Elsewhere
 * its time is of no consequence; it is kept at 0, so that states that differ in nothing else are one.
 */
final class ActiveClocks {
    private final Set<Integer> own;
    private final List<Term> invariants;
    private final List<Transition> transitions;

    /** @param own the slots of the clocks that the automaton declares */
    ActiveClocks(Set<Integer> own, List<Term> invariants, List<Transition> transitions) {
        this.own = own;
        this.invariants = invariants;
        this.transitions = transitions;
    }

    /** The slots of the clocks that matter at each location. */
    List<Set<Integer>> byLocation() {
        List<Set<Integer>> active = new ArrayList<>();
        IntStream.range(0, invariants.size()).forEach(location -> active.add(compared(location)));
        boolean grows = true;
        while (grows) {
            grows = false;
            for (Transition transition : transitions) {
                Set<Integer> kept = new TreeSet<>(active.get(transition.target()));
                transition.assignments().forEach(assignment -> kept.remove(assignment.slot()));
                grows |= active.get(transition.source()).addAll(kept);
            }
        }
        return active;
    }

    /** The transitions, each of which also sets to 0 what matters no longer where it leads. */
    List<Transition> resetting(List<Set<Integer>> active) {
        return transitions.stream().map(transition -> {
            List<Assignment> assignments = new ArrayList<>(transition.assignments());
            own.stream().filter(clock -> !active.get(transition.target()).contains(clock))
                    .forEach(clock -> assignments.add(new Assignment(clock, new Term.Constant(0))));
            return new Transition(transition.source(), transition.target(), transition.guard(),
                    transition.synchronisation(), assignments);
        }).toList();
    }

    private Set<Integer> compared(int location) {
        Stream<Term> conditions = Stream.concat(Stream.of(invariants.get(location)), transitions.stream()
                .filter(transition -> transition.source() == location).map(Transition::guard));
        return conditions.flatMap(condition -> Clocks.bounds(condition, "").stream()).map(Clocks.Bound::slot)
                .filter(own::contains).collect(Collectors.toCollection(TreeSet::new));
    }
}
