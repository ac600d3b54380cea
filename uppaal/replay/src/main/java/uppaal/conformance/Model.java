package uppaal.conformance;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import uppaal.ModelException;
import uppaal.document.Document;
import uppaal.document.DocumentReader;
import uppaal.network.Automaton;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;
import uppaal.network.Slot;
import uppaal.network.Transition;

/** One automaton of a model's file, whose instances follow boards. */
final class Model {
    private static final String INSTANCE = "Instance";

    final Automaton automaton;
    private final Network network;
    private final String template;
    private final Map<String, Integer> slots = new HashMap<>();
    private final Set<String> covered = Collections.newSetFromMap(new ConcurrentHashMap<>());

    /**
     * Reads a file beside the classes.
     *
     * @param file such as {@code relay.xml}
     * @param constants that are others than in the file
     * @param arguments of the template
     */
    Model(String file, String template, Map<String, Integer> constants, int... arguments) {
        this(read(file), template, constants, arguments);
    }

    Model(Document document, String template, Map<String, Integer> constants, int... arguments) {
        this.template = template;
        String given = Arrays.toString(arguments).replaceAll("[\\[\\]]", "");
        network = NetworkBuilder.build(document.withDeclarations(with(constants, document))
                .withSystem(INSTANCE + " = " + template + "(" + given + "); system " + INSTANCE + ";"));
        automaton = network.automata().get(0);
        for (int slot = 0; slot < network.slots().size(); slot++) {
            slots.put(network.slots().get(slot).name().replace(INSTANCE + ".", ""), slot);
        }
    }

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
        Set<String> edges = new TreeSet<>();
        automaton.transitions().stream().filter(Model::isOfBoards).map(this::name).forEach(edges::add);
        return edges;
    }

    /** Those of them that its instances took. */
    Set<String> covered() {
        return new TreeSet<>(covered);
    }

    void cover(List<Transition> path) {
        path.stream().filter(Model::isOfBoards).map(this::name).forEach(covered::add);
    }

    /** Whether a board declares it by a point; what a host does has a name in small letters. */
    private static boolean isOfBoards(Transition edge) {
        return edge.points().stream().anyMatch(point -> Character.isUpperCase(point.charAt(0)));
    }

    private String name(Transition edge) {
        return template + ": " + location(edge.source()) + " -> " + location(edge.target()) + " ("
                + String.join(" ", new TreeSet<>(edge.points())) + ")";
    }

    /** A constant of the file. */
    int constant(String constant) {
        return automaton.scope().term(constant).orElseThrow(() -> new ModelException(network.file(),
                "there is no constant '" + constant + "'")).value(new int[0]);
    }

    boolean isUrgent(int location) {
        return automaton.locations().get(location).urgent();
    }

    String location(int index) {
        return automaton.locations().get(index).name();
    }

    int slot(String variable) {
        Integer slot = slots.get(variable);
        if (slot == null) {
            throw new ModelException(network.file() + ", template " + template, "there is no '" + variable + "'");
        }
        return slot;
    }

    Slot range(int slot) {
        return network.slots().get(slot);
    }

    @Override
    public String toString() {
        return template;
    }
}
