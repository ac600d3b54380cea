package uppaal.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import uppaal.check.Exploration;
import uppaal.check.Property;
import uppaal.check.Query;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;

/**
 * A scene, checked by every engine that is there.
 *
 * @param queries the queries that were asked
 * @param own our checker's findings
 * @param verifyta UPPAAL's verdicts, where it is installed
 */
record Check(Scene scene, Network network, List<Query> queries, Exploration own, Optional<List<Boolean>> verifyta) {
    /**
     * Checks a scene.
     *
     * @param folder gets the scene's files, for other tools
     */
    static Check of(Scene scene, Path models, Path folder) throws IOException {
        Path written = scene.write(models, folder);
        Network network = NetworkBuilder.build(scene.document(models));
        List<Query> queries = scene.queries(models);
        Optional<Verifyta> engine = Verifyta.find();
        Optional<List<Boolean>> verifyta = engine.isEmpty() ? Optional.empty()
                : Optional.of(engine.get().check(written, folder.resolve(scene.name() + ".q"), queries.size()));
        return new Check(scene, network, queries, Exploration.of(network, properties(network, queries)), verifyta);
    }

    /** The queries' properties, parsed for a network. */
    static List<Property> properties(Network network, List<Query> queries) {
        return queries.stream().map(query -> Property.parse(query.text(), network, query.where())).toList();
    }

    /** The verdicts that are not as expected; a line each. */
    List<String> disagreements() {
        List<String> lines = new ArrayList<>();
        for (int i = 0; i < queries.size(); i++) {
            int index = i;
            compare(lines, index, "our checker", own.holds(i));
            verifyta.ifPresent(verdicts -> compare(lines, index, "verifyta", verdicts.get(index)));
        }
        return lines;
    }

    private void compare(List<String> lines, int query, String engine, boolean found) {
        boolean expected = queries.get(query).expected();
        if (found != expected) {
            lines.add(network.file() + ", " + queries.get(query).name() + ": expected that it " + word(expected)
                    + ", for " + engine + " it " + word(found));
        }
    }

    /** A verdict as the tables write it. */
    static String word(boolean holds) {
        return holds ? "holds" : "fails";
    }
}
