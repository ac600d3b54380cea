package uppaal.report;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import uppaal.document.Document;
import uppaal.document.Edge;
import uppaal.document.Template;

/**
 * A deliberate mistake in a model, to see which properties notice it.
 *
 * @param name two or three words
 * @param sentence what is wrong, in plain words
 * @param change makes the mistake
 */
record Fault(String name, String sentence, UnaryOperator<Document> change) {
    /**
     * The model with the mistake.
     *
     * @throws IllegalArgumentException when the mistake changes nothing, since the model is no longer as it was
     */
    Document in(Document sound) {
        Document faulty = change.apply(sound);
        if (faulty.equals(sound)) {
            throw new IllegalArgumentException("the fault '" + name + "' changes nothing in " + sound.file());
        }
        return faulty;
    }

    /** A change of every edge that leads so; {@code path} as in {@link Edge#path()}. */
    static UnaryOperator<Document> edge(String template, String path, UnaryOperator<Edge> change) {
        return edges(template, edges -> edges.replaceAll(edge -> edge.path().equals(path) ? change.apply(edge) : edge));
    }

    /** A new edge without guard and assignment. */
    static UnaryOperator<Document> added(String template, String source, String target, String synchronisation) {
        return edges(template, edges -> edges.add(new Edge(source, target, "", synchronisation, "")));
    }

    /** The edges that lead so, taken away. */
    static UnaryOperator<Document> removed(String template, String path) {
        return edges(template, edges -> edges.removeIf(edge -> edge.path().equals(path)));
    }

    /** Two changes, one after the other. */
    static UnaryOperator<Document> both(UnaryOperator<Document> first, UnaryOperator<Document> second) {
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
