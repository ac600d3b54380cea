package uppaal.report;

import java.util.List;
import uppaal.check.Exploration;
import uppaal.check.Property;
import uppaal.check.Query;
import uppaal.check.Trace;
import uppaal.document.Document;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;

/**
 * A deliberate mistake in {@code renewal.xml}, and a property that it breaks.
 *
 * @param query the name of a query of {@code renewal.q}
 */
record Flaw(Fault fault, String query) {
    /** One for each condition of the steps in which a key is renewed or deleted. */
    static final List<Flaw> OF_RENEWAL = List.of(
            new Flaw(guard("seal too early", "a board seals with the next key before all accept it",
                    "Board", "Accepts -> Seals", "accepting == BOARDS && ", ""), "R1"),
            new Flaw(guard("forget too early", "a board deletes the previous key before all seal with the next one",
                    "Board", "Seals -> Finished", "sealing == BOARDS", ""), "R1"),
            new Flaw(guard("never busy",
                    "a board takes the next key into use though a message sealed with the old one is under way",
                    "Board", "Accepts -> Seals", " && underWay[me] != OLD", ""), "R1"),
            new Flaw(assignment("current key first",
                    "a board deletes its current key before the next one, which a loss of power then brings into use",
                    "Accepts -> Leaving", "second[me] = NOTHING", "current[me] = second[me], second[me] = NOTHING"),
                    "R1"),
            new Flaw(assignment("gone in word only", "a board says that its keys are deleted, and they are not",
                    "Leaving -> Gone", "current[me] = NOTHING, ", ""), "R1"),
            new Flaw(assignment("sent to nobody", "a board that deletes a key goes on with what is sealed with it",
                    "Leaving -> Gone", "underWay[me] = NOTHING, ", ""), "R2"));

    private static Fault assignment(String name, String sentence, String path, String from, String to) {
        return new Fault(name, sentence,
                Fault.edge("Board", path, edge -> edge.withAssignment(edge.assignment().replace(from, to))));
    }

    private static Fault guard(String name, String sentence, String template, String path, String from, String to) {
        return new Fault(name, sentence,
                Fault.edge(template, path, edge -> edge.withGuard(edge.guard().replace(from, to))));
    }

    /** A shortest way to where the query fails. */
    Trace counterexample(Document sound, List<Query> queries) {
        Network network = NetworkBuilder.build(fault.in(sound));
        Query asked = queries.stream().filter(candidate -> candidate.name().equals(query)).findFirst().orElseThrow();
        return Exploration.untilSettled(network, List.of(Property.parse(asked.text(), network, asked.where())))
                .evidence(0)
                .orElseThrow(
                        () -> new IllegalStateException("the fault '" + fault.name() + "' is not noticed by " + query));
    }
}
