package uppaal.network;

import java.util.ArrayList;
import java.util.List;
import uppaal.document.Location;
import uppaal.language.Scope;

/** An instance of a template: what UPPAAL calls a process. */
public final class Automaton {
    private final String name;
    private final int slot;
    private final List<Location> locations;
    private final List<List<Transition>> outgoing;
    private final Scope scope;

    /**
     * @param slot where the state holds its location
     * @param transitions in the order of the file
     * @param scope what the names in the template stand for in this instance
     */
    Automaton(String name, int slot, List<Location> locations, List<Transition> transitions, Scope scope) {
        this.name = name;
        this.slot = slot;
        this.locations = List.copyOf(locations);
        this.scope = scope;
        this.outgoing = new ArrayList<>();
        for (int i = 0; i < locations.size(); i++) {
            int source = i;
            outgoing.add(transitions.stream().filter(transition -> transition.source() == source).toList());
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

    /** The transitions that leave the location where it is in a state. */
    public List<Transition> outgoing(int[] state) {
        return outgoing.get(state[slot]);
    }

    /** All its transitions. */
    public List<Transition> transitions() {
        return outgoing.stream().flatMap(List::stream).toList();
    }

    /** Whether it is at a committed location in a state. */
    public boolean committed(int[] state) {
        return locations.get(state[slot]).committed();
    }

    /** What the names in its template stand for. */
    public Scope scope() {
        return scope;
    }
}
