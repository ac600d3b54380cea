package uppaal.network;

import java.util.List;
import java.util.Set;
import uppaal.document.Location;
import uppaal.language.Scope;
import uppaal.language.Term;

/**
 * An instance of a template: what UPPAAL calls a process.
 *
 * @param slot where the state holds the index of its location
 * @param invariants what must be true as long as it is at a location, one for each
 * @param clocks the slots of its own clocks
 * @param transitions in the order of the file
 * @param scope what the names in the template stand for in this instance
 */
public record Automaton(String name, int slot, List<Location> locations, List<Term> invariants, Set<Integer> clocks,
        List<Transition> transitions, Scope scope) {
    /** Copies the collections, so that an automaton never changes. */
    public Automaton {
        locations = List.copyOf(locations);
        invariants = List.copyOf(invariants);
        clocks = Set.copyOf(clocks);
        transitions = List.copyOf(transitions);
    }

    /** The automaton's location in a state. */
    public Location at(int[] state) {
        return locations.get(state[slot]);
    }

    /** The transitions that leave the location of this index. */
    public List<Transition> outgoing(int location) {
        return transitions.stream().filter(transition -> transition.source() == location).toList();
    }
}
