package uppaal.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import uppaal.RandomNetworks;
import uppaal.Sketch;
import uppaal.network.Network;

class LivenessCheckTest {
    private static final List<String> PROPERTIES =
            List.of("x == 2 --> y == 2", "y == 1 --> x != 1", "y == 2 --> x == 0", "y != 0 --> !P.a || x == 2");

    private static Exploration explore(Network network, String property) {
        return Exploration.of(network, List.of(Property.parse(property, network, "here")));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "nobody need move                      | a -> b                        | false",
            "no time passes at an urgent location  | a~ -> b                       | true",
            "nor at a committed one                | a! -> b                       | true",
            "an invariant ends                     | a{x<=3} -> b; guard x >= 2    | true",
            "a guard alone makes nobody move       | a -> b; guard x >= 2          | false",
            "an invariant may stop time            | a{x<=1} -> b; guard x >= 3    | false",
            "a goal that is there is enough        | b -> a                        | true",
            "moves may go on without time          | a~ -> a, a~ -> b              | false",
            "a round may lie ahead                 | a~ -> c~, c~ -> d~, d~ -> c~, c~ -> b | false",
            "a round of some steps                 | a~ -> c~, c~ -> a~, c~ -> b   | false",
            "each way may end                      | a~ -> b, a~ -> c              | false",
            "all ways may come together            | a~ -> c~, a~ -> d~, c~ -> b, d~ -> b | true",
            "a round that begins at the goal       | a~ -> b, b -> c~, c~ -> c~    | true",
            "a committed one that cannot be left   | a~ -> c!, b -> a              | false",
            "time goes round with a reset          | a{x<=2} -> a; guard x >= 2; set x = 0, a{x<=2} -> b | false"})
    void holds_eventually_isAsUppaalHasIt(String rule, String edges, boolean expected) {
        Network network = Sketch.of("clock x;").template("P", edges.split(", (?=\\S+ -> )")).network();
        Exploration exploration = explore(network, "A<> P.b");
        assertEquals(expected, exploration.holds(0), rule);
        assertEquals(expected, exploration.evidence(0).isEmpty(), rule);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "n == 1 --> P.d                        | true",
            "n == 2 --> P.d                        | true",
            "n == 0 --> P.d                        | false",
            "P.b --> P.b                           | true",
            "P.d --> P.b                           | false",
            "P.b --> P.a                           | false",
            "P.b or P.c --> P.d && n == 2          | true"})
    void holds_leadsTo_isAsUppaalHasIt(String property, boolean expected) {
        Network network = Sketch.of("int[0,2] n;").template("P", "a -> b~; set n = 1", "b~ -> c~; set n = 2", "c~ -> d")
                .network();
        assertEquals(expected, explore(network, property).holds(0));
    }

    @Test
    void evidence_lines_tellWhatComesAfter() {
        Network network = Sketch.of("clock x;").template("P", "a -> b{x<=1}; guard x >= 1; set x = 0", "b -> c~",
                "c~ -> b; set x = 0", "a -> d").network();
        assertEquals(List.of("  1     1: (alone)            P a -> b", "  2     1: (alone)            P b -> c",
                "  3     1: (alone)            P c -> b", "  => P.b", "  and so again for ever, from step 2 on"),
                explore(network, "P.b --> P.d").evidence(0).orElseThrow().lines());
        network = Sketch.of("").template("P", "a! -> b", "b -> a!").network();
        assertEquals(List.of("  1  (alone)            P a -> b", "  => P.b", "  and so it may stay for ever"),
                explore(network, "P.b --> P.a").evidence(0).orElseThrow().lines());
    }

    /** On networks that nobody drew, against the definition: what stays out of the goal as long as one looks. */
    @Test
    void holds_randomNetworks_isAsDefined() {
        int refuted = 0;
        for (int seed = 0; seed < 300; seed++) {
            Network network = RandomNetworks.network(seed);
            Property property = Property.parse(PROPERTIES.get(seed % PROPERTIES.size()), network, "here");
            Exploration exploration = Exploration.of(network, List.of(property));
            assertEquals(byDefinition(network, property), exploration.holds(0), "seed " + seed);
            if (!exploration.holds(0)) {
                refuted++;
                assertRun(network, property, exploration.evidence(0).orElseThrow());
            }
        }
        assertTrue(refuted > 50 && refuted < 250, "refuted " + refuted);
    }

    private static void assertRun(Network network, Property property, DiagnosticTrace trace) {
        Successors successors = new Successors(network);
        int[] state = network.initial();
        boolean begun = property.premise().holds(state);
        for (JointMove move : trace.moves()) {
            assertTrue(successors.of(state).stream().anyMatch(one -> Arrays.equals(one.target(), move.target())));
            state = move.target();
            begun |= property.premise().holds(state);
        }
        assertTrue(begun);
        assertFalse(property.formula().holds(state));
        if (trace.ending() == DiagnosticTrace.Ending.LOOPS) {
            int[] first =
                    trace.loopStart() == 0 ? network.initial() : trace.moves().get(trace.loopStart() - 1).target();
            assertTrue(Arrays.equals(first, state) && trace.loopStart() < trace.moves().size());
            trace.moves().subList(trace.loopStart(), trace.moves().size())
                    .forEach(move -> assertFalse(property.formula().holds(move.target())));
        } else {
            assertTrue(successors.of(state).isEmpty() || stays(successors, state));
        }
    }

    private static boolean byDefinition(Network network, Property property) {
        Successors successors = new Successors(network);
        Set<List<Integer>> all = new LinkedHashSet<>(List.of(boxed(network.initial())));
        List<List<Integer>> open = new java.util.ArrayList<>(all);
        for (int i = 0; i < open.size(); i++) {
            for (JointMove move : successors.of(unboxed(open.get(i)))) {
                if (all.add(boxed(move.target()))) {
                    open.add(boxed(move.target()));
                }
            }
        }
        Set<List<Integer>> lost = new HashSet<>(all);
        lost.removeIf(state -> property.formula().holds(unboxed(state)));
        boolean shrinks = true;
        while (shrinks) {
            Set<List<Integer>> before = Set.copyOf(lost);
            shrinks = lost.removeIf(state -> {
                List<JointMove> moves = successors.of(unboxed(state));
                return !moves.isEmpty() && !stays(successors, unboxed(state))
                        && moves.stream().noneMatch(move -> before.contains(boxed(move.target())));
            });
        }
        return lost.stream().noneMatch(state -> property.premise().holds(unboxed(state)));
    }

    private static boolean stays(Successors successors, int[] state) {
        return successors.each(state, (parts, target) -> {
        });
    }

    private static List<Integer> boxed(int[] state) {
        return Arrays.stream(state).boxed().toList();
    }

    private static int[] unboxed(List<Integer> state) {
        return state.stream().mapToInt(Integer::intValue).toArray();
    }
}
