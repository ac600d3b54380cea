package uppaal.network;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import uppaal.document.Location;
import uppaal.language.Scope;
import uppaal.language.Term;

/** An instance of a template: what UPPAAL calls a process. */
public final class Automaton {
    private final String name;
    private final int slot;
    private final List<Location> locations;
    private final List<Term> invariants;
    private final Set<Integer> clocks;
    private final List<Set<Integer>> active;
    private final List<List<Transition>> outgoing;
    private final Scope scope;

    /**
     * @param slot the place of its location in the state
     * @param invariants those of the locations, in their order
     * @param clocks the slots of its own clocks
     * @param transitions in the order of the file
     * @param scope the meanings of the names in the template, in this instance
     */
    Automaton(String name, int slot, List<Location> locations, List<Term> invariants, Set<Integer> clocks,
            List<Transition> transitions, Scope scope) {
        this.name = name;
        this.slot = slot;
        this.locations = List.copyOf(locations);
        this.invariants = List.copyOf(invariants);
        this.clocks = Set.copyOf(clocks);
        this.scope = scope;
        ActiveClocks analysis = new ActiveClocks(invariants, transitions);
        this.active = analysis.byLocation();
        List<Transition> resetting = analysis.resetting(clocks, active);
        this.outgoing = new ArrayList<>();
        for (int i = 0; i < locations.size(); i++) {
            int source = i;
            outgoing.add(resetting.stream().filter(transition -> transition.source() == source).toList());
        }
    }

    /** The name of the instance. */
    public String name() {
        return name;
    }

    /** The slot of the state that holds the index of its location. */
    public int slot() {
        return slot;
    }

    /** Its locations; a state holds their indices. */
    public List<Location> locations() {
        return locations;
    }

    /** The transitions that leave the location of this index. */
    public List<Transition> outgoing(int location) {
        return outgoing.get(location);
    }

    /** All its transitions. */
    public List<Transition> transitions() {
        return outgoing.stream().flatMap(List::stream).toList();
    }

    /** Whether it is at a committed location in a state. */
    public boolean committed(int[] state) {
        return locations.get(state[slot]).committed();
    }

    /** Whether it is at a location, urgent or committed, where no time passes. */
    public boolean urgent(int[] state) {
        return locations.get(state[slot]).urgent();
    }

    /** Whether the clock of this slot is one of its own. */
    boolean owns(int clock) {
        return clocks.contains(clock);
    }

    /** The locations, by index, where the clock of this slot, one of its own, matters. */
    public List<Integer> active(int clock) {
        return IntStream.range(0, active.size()).filter(location -> active.get(location).contains(clock)).boxed()
                .toList();
    }

    /** The condition that must be true as long as it is at the location of this index. */
    public Term invariant(int location) {
        return invariants.get(location);
    }

    /** The meanings of the names in its template. */
    public Scope scope() {
        return scope;
    }
}
