package uppaal.conformance;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import uppaal.ModelException;
import uppaal.document.Document;
import uppaal.document.DocumentReader;
import uppaal.document.Location;
import uppaal.language.Term;
import uppaal.network.Automaton;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;
import uppaal.network.Slot;
import uppaal.network.Transition;

/** One automaton of a model's file, whose instances follow boards. */
final class Model {
    final Automaton automaton;
    private final Network network;
    private final String template;
    private final Set<String> covered = new TreeSet<>();

    /**
     * Makes it of a file.
     *
     * @param constants that are others than in the file
     * @param arguments of the template
     */
    Model(Document document, String template, Map<String, Integer> constants, int... arguments) {
        this.template = template;
        String given = Arrays.toString(arguments).replaceAll("[\\[\\]]", "");
        network = NetworkBuilder.build(document.withDeclarations(with(constants, document))
                .withSystem("Instance = " + template + "(" + given + "); system Instance;"));
        automaton = network.automata().get(0);
    }

    /** Reads a file beside the classes, such as {@code relay.xml}. */
    static Document read(String file) {
        try (InputStream bytes = Model.class.getResourceAsStream("/" + file)) {
            return DocumentReader.read(file, bytes);
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private static String with(Map<String, Integer> constants, Document document) {
        String declarations = document.declarations();
        for (Map.Entry<String, Integer> constant : constants.entrySet()) {
            Matcher declared = Pattern.compile("\\b" + constant.getKey() + " = [^,;]+").matcher(declarations);
            if (!declared.find()) {
                throw new ModelException(document.file(), "there is no constant '" + constant.getKey() + "'");
            }
            declarations = declared.replaceFirst(constant.getKey() + " = " + constant.getValue());
        }
        return declarations;
    }

    /** An instance at its initial location. */
    Instance instance(String name) {
        return new Instance(this, name, network.initial());
    }

    /** All edges that boards declare, as {@link #covered} names them. */
    Set<String> edges() {
        return ofBoards(automaton.transitions());
    }

    /** Those of them that its instances took. */
    Set<String> covered() {
        return covered;
    }

    void cover(List<Transition> path) {
        covered.addAll(ofBoards(path));
    }

    /** Those that a board declares by a point; what a host does has a name in small letters. */
    private Set<String> ofBoards(List<Transition> edges) {
        return edges.stream()
                .filter(edge -> edge.points().stream().anyMatch(point -> Character.isUpperCase(point.charAt(0))))
                .map(edge -> template + ": " + location(edge.source()).name() + " -> "
                        + location(edge.target()).name() + " (" + String.join(" ", new TreeSet<>(edge.points())) + ")")
                .collect(Collectors.toCollection(TreeSet::new));
    }

    Location location(int index) {
        return automaton.locations().get(index);
    }

    /** The meaning of a name in the template: a constant, a variable or a clock. */
    Term term(String name) {
        return automaton.scope().term(name).orElseThrow(
                () -> new ModelException(network.file() + ", template " + template, "there is no '" + name + "'"));
    }

    /** A constant of the file. */
    int constant(String constant) {
        return term(constant).value(new int[0]);
    }

    /** The place of a variable or a clock in a state. */
    int slot(String variable) {
        Term term = term(variable);
        return term instanceof Term.Clock clock ? clock.slot() : ((Term.Variable) term).slot();
    }

    Slot range(int slot) {
        return network.slots().get(slot);
    }

    @Override
    public String toString() {
        return template;
    }
}
