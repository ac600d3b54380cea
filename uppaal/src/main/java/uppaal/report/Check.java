package uppaal.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import uppaal.check.Exploration;
import uppaal.check.Property;
import uppaal.check.Query;
import uppaal.check.QueryFile;
import uppaal.document.Document;
import uppaal.document.DocumentReader;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;
import uppaal.promela.Spin;

/**
 * One model, checked by every engine that is there.
 *
 * @param queries what was asked
 * @param own our checker's findings
 * @param spin SPIN's, where it is installed
 * @param verifyta UPPAAL's verdicts, where it is installed
 */
record Check(Network network, List<Query> queries, Exploration own, Optional<Spin.Result> spin,
        Optional<List<Boolean>> verifyta) {
    /**
     * Checks a model.
     *
     * @param queryFiles asked in this order
     * @param folder for generated files
     */
    static Check of(Path model, List<Path> queryFiles, Path folder) throws IOException {
        Network network = NetworkBuilder.build(DocumentReader.read(model));
        Optional<Verifyta> engine = Verifyta.find();
        List<Query> queries = new ArrayList<>();
        List<Boolean> verdicts = new ArrayList<>();
        for (Path file : queryFiles) {
            List<Query> read = QueryFile.read(file);
            queries.addAll(read);
            if (engine.isPresent()) {
                verdicts.addAll(engine.get().check(model, file, read.size()));
            }
        }
        List<Property> properties = properties(network, queries);
        Optional<Spin.Result> spin = Spin.available()
                ? Optional.of(Spin.check(network, properties, folder)) : Optional.empty();
        return new Check(network, queries, Exploration.of(network, properties), spin,
                engine.map(found -> verdicts));
    }

    /**
     * Checks a scene of delivery, by our checker alone: {@code verifyta} has no file for it, and SPIN would take
     * minutes to compile its joint moves.
     */
    static Check of(Document document, List<Query> queries) {
        Network network = NetworkBuilder.build(document);
        return new Check(network, queries, Exploration.of(network, properties(network, queries)), Optional.empty(),
                Optional.empty());
    }

    /** The queries' properties, parsed for a network. */
    static List<Property> properties(Network network, List<Query> queries) {
        return queries.stream().map(query -> Property.parse(query.text(), network, query.where())).toList();
    }

    /** What is not as expected, or not the same for all engines; a line each. */
    List<String> disagreements() {
        List<String> lines = new ArrayList<>();
        for (int i = 0; i < queries.size(); i++) {
            int index = i;
            boolean expected = queries.get(i).expected();
            compare(lines, index, "our checker", expected, own.holds(i));
            spin.ifPresent(result -> compare(lines, index, "SPIN", expected, result.holds().get(index)));
            verifyta.ifPresent(verdicts -> compare(lines, index, "verifyta", expected, verdicts.get(index)));
        }
        spin.filter(result -> result.states() != own.states()).ifPresent(result -> lines.add(
                network.file() + ": our checker finds " + own.states() + " states, SPIN " + result.states()));
        spin.filter(result -> result.deadlock() != own.deadlocks() > 0).ifPresent(result -> lines.add(
                network.file() + ": our checker finds " + own.deadlocks() + " deadlocks, SPIN "
                        + (result.deadlock() ? "some" : "none")));
        return lines;
    }

    private void compare(List<String> lines, int query, String engine, boolean expected, boolean found) {
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
