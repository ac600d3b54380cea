package uppaal.conformance;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import uppaal.ModelException;
import uppaal.language.Labels.Assignment;
import uppaal.network.Slot;
import uppaal.network.Transition;

/**
 * One automaton that follows what a board declares: it is at one location, and each point takes one edge. What the rest
 * of the model would do is set from outside; clocks do not run by themselves.
 */
final class Instance {
    private final String name;
    private Model model;
    private int[] state;

    Instance(Model model, String name, int[] state) {
        this.model = model;
        this.name = name;
        this.state = state;
    }

    /** Goes on where it is as an instance of the same template with other arguments. */
    void become(Instance other) {
        model = other.model;
    }

    /** One way from the current location: through urgent ones, and by the edge of a point at last. */
    private record Way(List<Transition> path, int[] state) {}

    /** The name of its location. */
    String location() {
        return model.location(state[model.automaton.slot()]).name();
    }

    /** Whether it is at one of these locations. */
    boolean isAt(String... locations) {
        return Arrays.asList(locations).contains(location());
    }

    /** The value of a variable or clock. */
    int get(String variable) {
        return model.term(variable).value(state);
    }

    /** Sets a variable; a clock that is past all that it is compared with stays there. */
    void set(String variable, int value) {
        int slot = model.slot(variable);
        Slot range = model.range(slot);
        state[slot] = checked(slot, range.clock() ? Math.min(value, range.high()) : value);
    }

    void take(Point point) throws RefusedException {
        take(point, point.name(), Map.of());
    }

    void take(Point point, String label, Map<String, Integer> externals) throws RefusedException {
        take(point, label, externals, Map.of());
    }

    /**
     * Takes the one edge that has a point's name and whose guard is true, from the current location or, through edges
     * without points, from behind urgent ones; and on through urgent ones, by edges of the same name.
     *
     * @param label the name, if an edge's is another than the point's
     * @param externals variables and clocks that are set first
     * @param effect what variables must hold behind it
     * @throws ModelException if two edges with different effects can be meant
     */
    void take(Point point, String label, Map<String, Integer> externals, Map<String, Integer> effect)
            throws RefusedException {
        externals.forEach(this::set);
        List<Way> ways = ways(label).stream().filter(way -> effect.entrySet().stream()
                .allMatch(wanted -> way.state[model.slot(wanted.getKey())] == wanted.getValue())).toList();
        if (ways.isEmpty()) {
            throw new RefusedException(point.board() + " declares " + label + ", but its " + model + " " + name + " is "
                    + location(), expected());
        }
        Way way = ways.get(0);
        if (ways.stream().anyMatch(other -> !Arrays.equals(other.state, way.state))) {
            throw new ModelException(model + ", " + location(), "the point " + label + " can mean two edges");
        }
        state = way.state;
        model.cover(way.path);
    }

    /** Its board's air is busy, or quiet, which may mean something where it is. */
    void hear(Point point, boolean isBusy) throws RefusedException {
        String heard = isBusy ? "BUSY" : "QUIET";
        if (!ways(heard).isEmpty()) {
            take(point, heard, Map.of());
        }
    }

    /** The points that are possible now, in words. */
    private String expected() {
        Set<String> points = new TreeSet<>();
        List<Way> all = new ArrayList<>();
        walk(null, new Way(List.of(), state), all);
        all.forEach(way -> points.addAll(way.path.get(way.path.size() - 1).points()));
        return points.isEmpty() ? "nothing" : String.join(", ", points);
    }

    private List<Way> ways(String label) {
        List<Way> found = new ArrayList<>();
        walk(label, new Way(List.of(), state), found);
        return found;
    }

    private void walk(String label, Way so, List<Way> found) {
        int location = so.state[model.automaton.slot()];
        boolean passes = model.location(location).urgent();
        for (Transition edge : model.automaton.outgoing(location)) {
            boolean isPoint = label == null ? !edge.points().isEmpty() : edge.points().contains(label);
            boolean isPassed = passes && edge.points().isEmpty() && !so.path.contains(edge);
            if ((isPoint || isPassed) && edge.guard().holds(so.state)) {
                List<Transition> path = new ArrayList<>(so.path);
                path.add(edge);
                Way way = new Way(path, behind(edge, so.state));
                int before = found.size();
                if (!isPoint || label != null && model.location(edge.target()).urgent()) {
                    walk(label, way, found);
                }
                if (isPoint && found.size() == before) {
                    found.add(way);
                }
            }
        }
    }

    private int[] behind(Transition edge, int[] before) {
        int[] after = before.clone();
        after[model.automaton.slot()] = edge.target();
        for (Assignment assignment : edge.assignments()) {
            after[assignment.slot()] = checked(assignment.slot(), assignment.value().value(after));
        }
        return after;
    }

    private int checked(int slot, int value) {
        Slot range = model.range(slot);
        if (!range.holds(value)) {
            throw new ModelException(model + " " + name, "'" + range.name() + "' would become " + value
                    + ", outside its range [" + range.low() + "," + range.high() + "]");
        }
        return value;
    }
}
