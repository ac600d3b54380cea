package uppaal.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import uppaal.check.Exploration;
import uppaal.check.Property;
import uppaal.check.Query;
import uppaal.language.Term;
import uppaal.network.Network;

/**
 * Whether {@code A[] when imply then} says anything.
 *
 * @param query its name
 * @param reached whether some state has the left side; otherwise the property holds of nothing
 * @param needless whether the right side holds in all states by itself; then the left side says nothing
 */
record VacuityCheck(String query, boolean reached, boolean needless) {
    /** Asks it of each query that is an implication. */
    static List<VacuityCheck> of(Network network, List<Query> queries) {
        List<Property> properties = Check.properties(network, queries);
        List<VacuityCheck> found = new ArrayList<>();
        for (int i = 0; i < queries.size(); i++) {
            Optional<Term.Binary> implication = properties.get(i).implication();
            if (implication.isPresent()) {
                found.add(of(network, queries.get(i).name(), implication.get()));
            }
        }
        return found;
    }

    private static VacuityCheck of(Network network, String name, Term.Binary implication) {
        Exploration exploration = Exploration.of(network, List.of(
                Property.possibly(implication.left(), "left side"),
                Property.always(implication.right(), "right side")));
        return new VacuityCheck(name, exploration.holds(0), exploration.holds(1));
    }
}
