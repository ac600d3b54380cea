package uppaal.report;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import uppaal.check.Exploration;
import uppaal.check.Query;
import uppaal.check.QueryFile;
import uppaal.document.Document;
import uppaal.document.Edge;
import uppaal.document.Template;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;

/**
 * The outcome of the paper's network if its text is read in another way than {@code paper.xml} does.
 *
 * @param sentence the difference in words
 * @param failing the names of the paper's properties that fail
 */
record Interpretation(String sentence, int states, List<String> failing) {

    private static final UnaryOperator<Document> BINARY =
            document -> document.withDeclarations(document.declarations().replace("broadcast chan", "chan"));
    private static final UnaryOperator<Document> ONE_OF_MANY =
            document -> document.withSystem(document.system().replace("(2)", "(1)").replace("(4)", "(1)"));
    private static final UnaryOperator<Document> OFFLINE = both(removed("Connection", "Online -> Online"),
            added("Connection", "Offline", "Offline", "is_online!"));

    private record Change(String sentence, UnaryOperator<Document> change) {
    }

    private static final List<Change> CHANGES = List.of(
            new Change("as drawn", document -> document),
            new Change("a sender asks whether the connection is *offline*, as the text has it", OFFLINE),
            new Change("all channels are binary: a message to many reaches one", BINARY),
            new Change("the first acknowledgement of many is enough", ONE_OF_MANY),
            new Change("the channel is only looked at, not acquired, and comes and goes as the connection does",
                    Interpretation::lookedAt),
            new Change("the same, with binary channels", both(BINARY, Interpretation::lookedAt)),
            new Change("the letter of the text: the same, and a sender is done with one acknowledgement",
                    both(both(BINARY, Interpretation::lookedAt), Interpretation::doneAtOnce)));

    /** All of them, asked the paper's queries. */
    static List<Interpretation> all(Path models) {
        return CHANGES.stream().map(change -> of(change, models)).toList();
    }

    private static Interpretation of(Change change, Path models) {
        Network network = NetworkBuilder.build(change.change.apply(Scene.PAPER.document(models)));
        List<Query> queries = QueryFile.read(models.resolve("paper.q"));
        Exploration exploration = Exploration.of(network, Check.properties(network, queries));
        List<String> failing = new ArrayList<>();
        for (int i = 0; i < queries.size(); i++) {
            if (!exploration.holds(i)) {
                failing.add(queries.get(i).name());
            }
        }
        return new Interpretation(change.sentence, exploration.states(), failing);
    }

    private static Document lookedAt(Document document) {
        return Stream.of(removed("Channel", "Released -> Not_Released"),
                removed("Channel", "Not_Released -> Released"), added("Channel", "Released", "Not_Released", ""),
                added("Channel", "Not_Released", "Released", ""), added("Channel", "Released", "Released", "acquire?"),
                edge("Sender_Unicast", "Unicast_Acknowledged -> Idle", edge -> edge.withSynchronisation("")),
                edge("Sender_Multicast", "Multicast_Sent -> Idle", edge -> edge.withSynchronisation("")),
                edge("Sender_Broadcast", "Broadcast_Sent -> Idle", edge -> edge.withSynchronisation("")))
                .reduce(document, (before, change) -> change.apply(before), (one, other) -> other);
    }

    /** Nothing lies between the acknowledgement and the first location. */
    private static Document doneAtOnce(Document document) {
        return Stream.of(removed("Sender_Unicast", "Unicast_Sent -> Unicast_Acknowledged"),
                removed("Sender_Unicast", "Unicast_Acknowledged -> Idle"),
                added("Sender_Unicast", "Unicast_Sent", "Idle", "unicast_received?"),
                removed("Sender_Multicast", "Multicast_Sent -> Multicast_Sent"),
                removed("Sender_Multicast", "Multicast_Sent -> Idle"),
                added("Sender_Multicast", "Multicast_Sent", "Idle", "multicast_received?"),
                removed("Sender_Broadcast", "Broadcast_Sent -> Broadcast_Sent"),
                removed("Sender_Broadcast", "Broadcast_Sent -> Idle"),
                added("Sender_Broadcast", "Broadcast_Sent", "Idle", "broadcast_received?"))
                .reduce(document, (before, change) -> change.apply(before), (one, other) -> other);
    }

    /** A change of every edge that leads so; {@code path} as in {@link Edge#path()}. */
    private static UnaryOperator<Document> edge(String template, String path, UnaryOperator<Edge> change) {
        return edges(template, edges -> edges.replaceAll(edge -> edge.path().equals(path) ? change.apply(edge) : edge));
    }

    /** A new edge without guard and assignment. */
    private static UnaryOperator<Document> added(String template, String source, String target,
            String synchronisation) {
        return edges(template, edges -> edges.add(new Edge(source, target, "", synchronisation, "")));
    }

    /** The edges that lead so, taken away. */
    private static UnaryOperator<Document> removed(String template, String path) {
        return edges(template, edges -> edges.removeIf(edge -> edge.path().equals(path)));
    }

    private static UnaryOperator<Document> both(UnaryOperator<Document> first, UnaryOperator<Document> second) {
        return document -> second.apply(first.apply(document));
    }

    private static UnaryOperator<Document> edges(String template, Consumer<List<Edge>> change) {
        return document -> {
            Template old = document.template(template);
            List<Edge> edges = new ArrayList<>(old.edges());
            change.accept(edges);
            return document.withTemplate(old.withEdges(edges));
        };
    }
}
