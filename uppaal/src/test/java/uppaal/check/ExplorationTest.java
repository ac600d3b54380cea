package uppaal.check;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import uppaal.ModelException;
import uppaal.Sketch;
import uppaal.TinyNetworks;
import uppaal.document.Document;
import uppaal.document.DocumentReader;
import uppaal.document.Location;
import uppaal.document.Template;
import uppaal.language.Symbol;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;

class ExplorationTest {
    private static final Document PAPER = DocumentReader.read(Path.of("models/paper.xml"));

    private static Exploration explore(Network network, String... properties) {
        return Exploration.of(network,
                Arrays.stream(properties).map(text -> Property.parse(text, network, "here")).toList());
    }

    @ParameterizedTest
    @MethodSource("uppaal.TinyNetworks#all")
    void explore_tinyNetwork_followsTheRule(TinyNetworks.Tiny tiny) {
        Exploration exploration = explore(tiny.sketch().network(), tiny.property());
        assertEquals(tiny.states(), exploration.states());
        assertEquals(tiny.deadlocks(), exploration.deadlocks());
        assertEquals(tiny.holds(), exploration.holds(0));
    }

    @ParameterizedTest
    @CsvSource({"paper.xml, 232", "quiet.xml, 117"})
    void explore_paper_hasTheKnownStates(String model, int states) {
        Network network = NetworkBuilder.build(DocumentReader.read(Path.of("models", model)));
        Exploration exploration = explore(network);
        assertEquals(states, exploration.states());
        assertEquals(0, exploration.deadlocks());
    }

    @Test
    void quietModel_comparedWithThePaper_differsInItsConnectionAndHasteOnly() {
        Document quiet = DocumentReader.read(Path.of("models/quiet.xml"));
        for (Template template : quiet.templates()) {
            quiet = quiet.withTemplate(unhurried(template));
        }
        List<Template> same = quiet.templates();
        assertEquals(PAPER.system(), quiet.system());
        assertEquals(withoutComments(PAPER.declarations()), withoutComments(quiet.declarations()));
        assertEquals(List.of("Connection"), PAPER.templates().stream()
                .filter(template -> !same.contains(template)).map(template -> template.name()).toList());
        assertEquals(PAPER.templates().size(), quiet.templates().size());
    }

    private static Template unhurried(Template template) {
        return new Template(template.name(), template.parameters(), template.declarations(),
                template.locations().stream()
                        .map(location -> new Location(location.name(), false, location.invariant()))
                        .toList(),
                template.initial(), template.edges());
    }

    @Test
    void holds_whatWasBegunEnds_inTheQuietModelOnly() {
        Network network = NetworkBuilder.build(PAPER);
        List<Query> queries = QueryFile.read(Path.of("models/quiet.q")).stream()
                .filter(query -> query.text().contains("-->")).toList();
        Exploration exploration = explore(network, queries.stream().map(Query::text).toArray(String[]::new));
        assertEquals(4, queries.size());
        for (int i = 0; i < queries.size(); i++) {
            assertFalse(exploration.holds(i), queries.get(i).name());
        }
    }

    @Test
    void evidence_counterexample_isPlayableAndEndsInARefutingState() {
        Network network = NetworkBuilder.build(PAPER);
        Property property = Property.parse("A[] !(Bus_Sender.Broadcast_Sent && Bus_Sender.acks == 4)", network, "here");
        DiagnosticTrace trace = Exploration.of(network, List.of(property)).evidence(0).orElseThrow();

        int[] state = network.initial();
        for (JointMove move : trace.moves()) {
            int[] before = state;
            assertTrue(new Successors(network).of(before).stream()
                    .anyMatch(possible -> possible.parts().equals(move.parts())
                            && Arrays.equals(possible.target(), move.target())));
            state = move.target();
        }
        assertArrayEquals(trace.last(), state);
        assertTrue(property.settledBy(network.observed(state, false)));
        assertEquals(8, trace.moves().size(), "online, is_online, acquire, send and four acknowledgements");
    }

    @Test
    void evidence_lines_canBeRead() {
        Network network = Sketch.of("chan c; int[0,9] x;").template("P", "a -> b; sync c!; set x = 7")
                .template("Q", "a -> b; sync c?").network();
        assertEquals(List.of("  1  c                  P a -> b, Q a -> b", "  => P.b, Q.b, x = 7"),
                explore(network, "E<> x == 7").evidence(0).orElseThrow().lines());
        assertEquals(List.of("  => the first state"), explore(network, "A[] x == 7").evidence(0).orElseThrow().lines());
        assertTrue(explore(network, "E<> x == 8").evidence(0).isEmpty());
    }

    @Test
    void explore_variableLeavesItsRange_isSaid() {
        Network network = Sketch.of("int[0,2] x;").template("P", "a -> a; set x++").network();
        assertEquals("sketch: P a -> a would make 'x' 3, outside its range [0,2]",
                assertThrows(ModelException.class, () -> explore(network)).getMessage());
    }

    @Test
    void explore_overflow_isSaid() {
        Network network = Sketch.of("int x = 2;").template("P", "a -> b; guard x * 2147483647 > 0").network();
        assertEquals("sketch: a value does not fit 32 bits, or is divided by 0",
                assertThrows(ModelException.class, () -> explore(network)).getMessage());
    }

    @Test
    void paper_highwaysMessages_canComeInTheirOrder() {
        Network network = NetworkBuilder.build(PAPER);
        List<String> heard = List.of("sendBroadcast", "encryptUnicast", "sendUnicast",
                "encryptMulticast", "sendMulticast", "sendBroadcast");
        assertTrue(accepts(network, heard));
        assertTrue(!accepts(network, List.of("sendUnicast")), "nothing is sent that was not encrypted");
        assertTrue(!accepts(network, List.of("encryptUnicast", "sendBroadcast")), "nobody else sends in between");
    }

    /** Whether these messages can be seen in this order, whatever else happens between them. */
    private static boolean accepts(Network network, List<String> messages) {
        Set<List<Integer>> states = new LinkedHashSet<>(List.of(boxed(network.initial())));
        for (String message : messages) {
            Set<List<Integer>> after = new LinkedHashSet<>();
            for (List<Integer> state : closure(network, states)) {
                steps(network, state).stream().filter(move -> name(move).equals(message))
                        .forEach(move -> after.add(boxed(move.target())));
            }
            states = after;
        }
        return !states.isEmpty();
    }

    private static List<List<Integer>> closure(Network network, Set<List<Integer>> states) {
        List<List<Integer>> found = new ArrayList<>(states);
        for (int i = 0; i < found.size(); i++) {
            for (JointMove move : steps(network, found.get(i))) {
                boolean hidden = !name(move).startsWith("send") && !name(move).startsWith("encrypt");
                if (hidden && !found.contains(boxed(move.target()))) {
                    found.add(boxed(move.target()));
                }
            }
        }
        return found;
    }

    private static List<JointMove> steps(Network network, List<Integer> state) {
        return new Successors(network).of(state.stream().mapToInt(Integer::intValue).toArray());
    }

    private static String name(JointMove move) {
        return move.channel().map(Symbol.Channel::name).orElse("");
    }

    private static List<Integer> boxed(int[] state) {
        return Arrays.stream(state).boxed().toList();
    }

    private static String withoutComments(String text) {
        return text.lines().filter(line -> !line.startsWith("//")).collect(Collectors.joining("\n"));
    }
}
