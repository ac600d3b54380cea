package uppaal.report;

import java.util.ArrayList;
import java.util.List;
import uppaal.check.Exploration;
import uppaal.check.Query;
import uppaal.document.Document;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;

/**
 * Which queries notice a fault: those whose verdict is no longer the expected one.
 *
 * @param paper of the paper's eight
 * @param stronger of those that we added
 * @param quiet of those asked of the network whose connection stays online
 */
record Kill(Fault fault, List<String> paper, List<String> stronger, List<String> quiet) {
    static Kill of(Fault fault, Suite suite) {
        Document paper = fault.in(suite.paper());
        Document quiet = fault.in(suite.quiet());
        return new Kill(fault, noticed(paper, suite.paperQueries()), noticed(paper, suite.strongerQueries()),
                noticed(quiet, suite.quietQueries()));
    }

    /** Whether any query notices the fault. */
    boolean caught() {
        return !(paper.isEmpty() && stronger.isEmpty() && quiet.isEmpty());
    }

    private static List<String> noticed(Document document, List<Query> queries) {
        Network network = NetworkBuilder.build(document);
        Exploration exploration = Exploration.of(network, Check.properties(network, queries));
        List<String> names = new ArrayList<>();
        for (int i = 0; i < queries.size(); i++) {
            if (exploration.holds(i) != queries.get(i).expected()) {
                names.add(queries.get(i).name());
            }
        }
        return names;
    }
}
