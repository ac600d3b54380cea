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
 * A deliberate mistake in {@code delivery.xml} or {@code renewal.xml}, and a property that it breaks.
 *
 * @param query the name of a query of the scene {@code unicast}, or of {@code renewal}
 */
record Flaw(Fault fault, String query) {
    private static final String REPEAT = " && waits1 == 0 && waits2 == 0";

    /** One for each check that a board makes of messages. */
    static final List<Flaw> ALL = List.of(
            new Flaw(guard("no nonce check", "a receiver does not ask whether the host has had something newer",
                    "Receiver", "Listening -> Listening", " && taken < 1", ""), "D4"),
            new Flaw(guard("no duplicate check", "a receiver does not ask whether the message waits already",
                    "Receiver", "Listening -> Listening", REPEAT, " && waits1 < 2 && waits2 == 0"), "D1"),
            new Flaw(guard("no tag check", "a receiver takes frames with a wrong tag",
                    "Receiver", "Listening -> Listening", " && genuine", ""), "D2"),
            new Flaw(guard("no proof check", "a sender takes acknowledgements with a wrong proof",
                    "Sender", "Held -> Idle", " && genuine", ""), "D3"),
            new Flaw(guard("proof without nonce", "a sender takes an acknowledgement of another message",
                    "Sender", "Held -> Idle", " && nonce == current", ""), "D3"),
            new Flaw(new Fault("hasty acknowledgement", "a receiver acknowledges before its host has the message",
                    Fault.added("Receiver", "Listening", "Pending", "heard?").andThen(document -> Fault.edge("Receiver",
                            "Listening -> Pending",
                            edge -> edge.guard().isEmpty() ? edge.withGuard("kind == DATA && nonce == 1")
                                    .withAssignment("answer = 1") : edge)
                            .apply(document))::apply),
                    "D3"),
            new Flaw(new Fault("endless patience", "a sender waits for ever for its last acknowledgement",
                    Fault.removed("Sender", "Awaiting -> Idle")), "D5"));

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
