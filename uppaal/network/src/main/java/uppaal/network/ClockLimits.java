package uppaal.network;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.ToIntFunction;
import java.util.stream.IntStream;
import uppaal.language.Clocks;
import uppaal.language.Labels.Assignment;
import uppaal.language.Term;

/**
 * Finds what each clock is compared with in an automaton, from each of its locations on, before it is reset again.
 * Where that is nothing, a clock of its own is of no consequence; it is kept at 0, so that states that differ in
 * nothing else are one.
 */
final class ClockLimits {
    private final List<Term> invariants;
    private final List<Transition> transitions;
    private final ToIntFunction<Term> greatest;

    /** @param greatest the greatest value that what a clock is compared with can have */
    ClockLimits(List<Term> invariants, List<Transition> transitions, ToIntFunction<Term> greatest) {
        this.invariants = invariants;
        this.transitions = transitions;
        this.greatest = greatest;
    }

    /** For each location, by the clocks' slots. */
    List<Map<Integer, Limits>> byLocation() {
        List<Map<Integer, Limits>> limits = new ArrayList<>();
        IntStream.range(0, invariants.size()).forEach(location -> limits.add(compared(location)));
        boolean grows = true;
        while (grows) {
            grows = false;
            for (Transition transition : transitions) {
                Map<Integer, Limits> later = new HashMap<>(limits.get(transition.target()));
                later.keySet().removeAll(reset(transition));
                grows |= merge(later, limits.get(transition.source()));
            }
        }
        return limits;
    }

    private static boolean merge(Map<Integer, Limits> more, Map<Integer, Limits> limits) {
        Map<Integer, Limits> before = Map.copyOf(limits);
        more.forEach((clock, limit) -> limits.merge(clock, limit, Limits::and));
        return !limits.equals(before);
    }

    private static Set<Integer> reset(Transition transition) {
        Set<Integer> reset = new HashSet<>();
        transition.assignments().forEach(assignment -> reset.add(assignment.slot()));
        return reset;
    }

    /** The transitions, each of which also sets to 0 those of some clocks that matter no longer where it leads. */
    List<Transition> resetting(Set<Integer> own, List<Map<Integer, Limits>> limits) {
        return transitions.stream().map(transition -> {
            List<Assignment> assignments = new ArrayList<>(transition.assignments());
            own.stream().filter(clock -> !limits.get(transition.target()).containsKey(clock))
                    .forEach(clock -> assignments.add(new Assignment(clock, new Term.Constant(0))));
            return transition.assigning(assignments);
        }).toList();
    }

    private Map<Integer, Limits> compared(int location) {
        Map<Integer, Limits> limits = of(invariants.get(location));
        for (Transition transition : transitions) {
            if (transition.source() == location) {
                merge(compared(transition), limits);
            }
        }
        return limits;
    }

    /**
     * Whoever can hear a broadcast must, and no time passes where a step on an urgent channel is possible: so a clock
     * that decides about that may hinder as well as allow.
     */
    private Map<Integer, Limits> compared(Transition transition) {
        Map<Integer, Limits> limits = of(transition.guard());
        if (transition.urgent()) {
            Map<Integer, Limits> then = of(invariants.get(transition.target()));
            then.keySet().removeAll(reset(transition));
            merge(then, limits);
        }
        if (transition.urgent() || transition.mustHear()) {
            limits.replaceAll((clock, limit) -> limit.exact());
        }
        return limits;
    }

    private Map<Integer, Limits> of(Term condition) {
        Map<Integer, Limits> limits = new HashMap<>();
        for (Clocks.Bound bound : Clocks.bounds(condition, "")) {
            limits.merge(bound.slot(), Limits.of(bound.operator(), greatest.applyAsInt(bound.limit())), Limits::and);
        }
        return limits;
    }
}
