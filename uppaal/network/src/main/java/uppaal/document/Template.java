package uppaal.document;

import java.util.List;

/**
 * One automaton, not yet instantiated.
 *
 * @param parameters the formal parameters, empty for none
 * @param declarations the local declarations, empty for none
 * @param initial the name of the initial location
 */
public record Template(String name, String parameters, String declarations, List<Location> locations,
        String initial, List<Edge> edges) {
    /** Copies the lists, so that a template never changes. */
    public Template {
        locations = List.copyOf(locations);
        edges = List.copyOf(edges);
    }

    /** This template with other edges. */
    public Template withEdges(List<Edge> changed) {
        return new Template(name, parameters, declarations, locations, initial, changed);
    }
}
