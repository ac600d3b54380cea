package uppaal.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import uppaal.ModelException;
import uppaal.RandomNetworks;
import uppaal.Sketch;
import uppaal.language.Expressions;
import uppaal.language.Symbol;
import uppaal.language.Term;

class StateSetTest {
    private static final int DEPTH = 3;

    private static StateSet of(Network network) {
        return StateSet.first(network, List.of(), (state, move) -> move.channel().map(channel -> channel.name()));
    }

    private static StateSet of(Sketch sketch) {
        return of(sketch.network());
    }

    private static Network doors() {
        return Sketch.of("broadcast chan open, close, ring;")
                .template("Door", "Shut -> Locked", "Shut -> Ajar; sync open!", "Ajar -> Shut; sync close!",
                        "Locked -> Locked; sync ring!")
                .network();
    }

    private static StateSet door() {
        return of(doors());
    }

    private static StateSet clock() {
        return of(Sketch.of("broadcast chan late; clock x;")
                .template("Clock", "A{x<=3} -> B; guard x >= 2; sync late!").network());
    }

    @Test
    void after_aMoveThatIsPossible_knowsWhatFollows() {
        StateSet open = door().after("open").orElseThrow();
        assertEquals(Set.of("close"), open.next());
        assertEquals(Set.of("open", "ring"), open.after("close").orElseThrow().next());
    }

    @Test
    void after_aMoveThatOnlyAnUnseenOneAllows_isPossibleAndRulesOthersOut() {
        StateSet rung = door().after("ring").orElseThrow();
        assertEquals(Set.of("ring"), rung.next());
        assertFalse(rung.after("open").isPresent());
    }

    @Test
    void after_whatCannotBe_isNothing() {
        assertFalse(door().after("close").isPresent());
        assertFalse(door().after("no such channel").isPresent());
    }

    @Test
    void perhaps_keepsBoth() {
        assertEquals(Set.of("open", "ring", "close"), door().perhaps("open").next());
        assertEquals(door().next(), door().perhaps("close").next());
    }

    @Test
    void where_movesThoseThatCan_andKeepsTheOthers() {
        assertEquals(Set.of("close", "ring"), door().where("open").next());
        assertEquals(door().next(), door().where("close").next());
    }

    /** What is known, found without any of what {@link StateSet} leaves out. */
    private record Plain(Successors steps, Set<List<Integer>> states) {
        static Plain of(Network network) {
            return new Plain(new Successors(network), Set.of()).closed(List.of(listed(network.initial())));
        }

        private static List<Integer> listed(int[] state) {
            return IntStream.of(state).boxed().toList();
        }

        /** Where a move of this name leads; of an empty one, what passes unseen. */
        private List<List<Integer>> after(List<Integer> state, String name) {
            List<List<Integer>> targets = new ArrayList<>();
            int[] from = state.stream().mapToInt(Integer::intValue).toArray();
            boolean idle = steps.each(from, (parts, target) -> {
                JointMove move = new JointMove(parts, target);
                String seen = move.passesTime() ? StateSet.SLOT : move.channel().map(Symbol.Channel::name).orElse("");
                if (seen.equals(name)) {
                    targets.add(listed(target));
                }
            });
            if (idle && name.equals(StateSet.SLOT)) {
                targets.add(state);
            }
            return targets;
        }

        private Plain closed(Collection<List<Integer>> some) {
            Set<List<Integer>> closed = new HashSet<>(some);
            Deque<List<Integer>> open = new ArrayDeque<>(closed);
            while (!open.isEmpty()) {
                after(open.remove(), "").stream().filter(closed::add).forEach(open::add);
            }
            return new Plain(steps, closed);
        }

        Plain after(String name) {
            return closed(states.stream().flatMap(state -> after(state, name).stream()).toList());
        }

        Plain or(Plain other) {
            Set<List<Integer>> both = new HashSet<>(states);
            both.addAll(other.states);
            return new Plain(steps, both);
        }

        Plain elapse(int least, int most) {
            Plain now = this;
            Plain all = new Plain(steps, Set.of());
            for (int units = 0; units <= most; units++, now = now.after(StateSet.SLOT)) {
                all = units < least ? all : all.or(now);
            }
            return all;
        }
    }

    /** Both know the same: what can be seen next, in each of so many steps. */
    private static void compare(String before, Plain plain, StateSet possible, int steps) {
        for (String name : List.of("one", "all")) {
            Plain next = plain.after(name);
            assertEquals(!next.states.isEmpty(), possible.after(name).isPresent(), before + name);
            if (steps > 0 && !next.states.isEmpty()) {
                compare(before + name + " ", next, possible.after(name).orElseThrow(), steps - 1);
                compare(before + name + "? ", plain.or(next), possible.perhaps(name), steps - 1);
            }
        }
        if (steps == DEPTH - 1) {
            possible.forget();
        }
        for (int least = 0; least <= 2; least++) {
            Plain next = plain.elapse(least, 2);
            assertEquals(!next.states.isEmpty(), possible.elapse(least, 2).possible().isPresent(), before + least);
            if (steps > 0 && !next.states.isEmpty()) {
                compare(before + least + "-2 ", next, possible.elapse(least, 2).possible().orElseThrow(), steps - 1);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void first_ofRandomNetworks_knowsWhatAllStatesTogetherAllow(long seed) {
        Network network = RandomNetworks.network(seed);
        compare("", Plain.of(network), of(network), DEPTH);
    }

    private static LongStream seeds() {
        return LongStream.range(0, 300);
    }

    private static Sketch clocked() {
        return Sketch.of("broadcast chan go, late, early; urgent broadcast chan hurry; clock x;");
    }

    @Test
    void forget_whatWasFound_isFoundAgain() {
        StateSet door = door();
        int before = door.size();
        door.after("open");
        assertTrue(door.size() > before);
        door.forget();
        assertEquals(0, door.size());
        assertEquals(Set.of("close"), door.after("open").orElseThrow().next());
        assertTrue(door.size() > 0);
    }

    @Test
    void elapse_upToABound_keepsWhatHasMostTimeLeft() {
        StateSet first = of(clocked().template("Clock", "A{x<=9} -> B; sync late!"));
        assertSame(first, first.elapse(0, 4).possible().orElseThrow());
        assertTrue(first.elapse(9, 9).possible().isPresent());
        assertFalse(first.elapse(10, 10).possible().isPresent());
    }

    @Test
    void elapse_upToWhatMayBeWaitedFor_keepsTheLatest() {
        StateSet waited = of(clocked().template("Clock", "A -> B; guard x >= 3; sync late!")).elapse(0, 3)
                .possible().orElseThrow();
        assertTrue(waited.after("late").isPresent());
    }

    @Test
    void elapse_upToABroadcastThatMustBeHeard_keepsWhoIsTooLateForIt() {
        StateSet waited = of(clocked().template("Caller", "A -> B; sync go!")
                .template("Clock", "C -> D; guard x <= 1; sync go?", "C -> C; sync late!", "D -> D; sync early!"))
                .elapse(0, 2).possible().orElseThrow();
        assertEquals(Set.of("early", "late"), waited.after("go").orElseThrow().next());
    }

    @Test
    void elapse_upToAnUrgentStep_keepsWhoIsTooLateForIt() {
        StateSet waited = of(clocked().template("Clock", "A -> B; sync go!", "B -> C{x<=1}; sync hurry!"))
                .elapse(0, 2).possible().orElseThrow();
        assertTrue(waited.after("go").orElseThrow().elapse(9, 9).possible().isPresent());
    }

    @Test
    void elapse_whereAClockIsComparedLater_counts() {
        StateSet first = of(clocked().local("clock y;").template("Clock", "A -> B{y<=3}; sync go!"));
        assertTrue(first.elapse(3, 3).possible().orElseThrow().after("go").isPresent());
        assertFalse(first.elapse(4, 4).possible().orElseThrow().after("go").isPresent());
    }

    @Test
    void elapse_whereAClockIsResetBeforeItIsCompared_doesNotCount() {
        StateSet first = of(Sketch.of("broadcast chan go;").local("clock y;")
                .template("Clock", "A -> B{y<=3}; sync go!; set y = 0"));
        assertSame(first, first.elapse(4, 4).possible().orElseThrow());
    }

    @Test
    void first_variableThatNobodyAsksFor_isNotCounted() {
        Sketch sketch = Sketch.of("broadcast chan ring; int[0,1] rung, known;")
                .template("Door", "Shut -> Shut; sync ring!; set rung++, known = rung");
        StateSet once = of(sketch.network()).after("ring").orElseThrow();
        assertTrue(once.after("ring").isPresent());
        StateSet asked = StateSet.first(sketch.network(),
                List.of(Expressions.parse("known", sketch.network(), "here")),
                (state, move) -> move.channel().map(channel -> channel.name()));
        assertThrows(ModelException.class, () -> asked.after("ring"));
    }

    @Test
    void only_knowsWhereAFormulaIsTrue_andTellsTheWaysThere() {
        Network doors = doors();
        StateSet.Seen locked = of(doors).only(Expressions.parse("Door.Locked", doors, "test"));
        assertEquals(Set.of("ring"), locked.possible().orElseThrow().next());
        assertEquals(Set.of("Door: Shut -> Locked, 1"), locked.edges());
        StateSet.Seen ajar = of(doors).only(Expressions.parse("Door.Ajar", doors, "test"));
        assertEquals(Set.of("open", "ring"), ajar.possible().orElseThrow().next());
        assertEquals(Set.of(), ajar.edges());
    }

    @Test
    void see_tellsTheEdgesThatMayHaveBeenTaken() {
        assertEquals(Set.of("Door: Shut -> Ajar, 1"), door().see("open").edges());
        assertEquals(Set.of("Door: Shut -> Locked, 1", "Door: Locked -> Locked, 1"), door().see("ring").edges());
    }

    @Test
    void isCertain_onlyWhereItIsTrueInAllStates() {
        Term shut = Expressions.parse("Door.Shut", doors(), "here");
        assertFalse(door().isCertain(shut));
        assertTrue(door().isCertain(Expressions.parse("Door.Shut || Door.Locked", doors(), "here")));
        assertFalse(door().after("open").orElseThrow().isCertain(shut));
    }

    @Test
    void elapse_asLongAsTheInvariantAllows() {
        assertFalse(clock().after("late").isPresent());
        assertFalse(clock().elapse(0, 1).possible().orElseThrow().after("late").isPresent());
        assertTrue(clock().elapse(0, 2).possible().orElseThrow().after("late").isPresent());
        assertTrue(clock().elapse(3, 9).possible().isPresent());
        assertFalse(clock().elapse(4, 9).possible().isPresent());
    }

    @Test
    void elapse_whereNothingChanges_goesOnForEver() {
        StateSet late = clock().elapse(2, 2).possible().flatMap(known -> known.after("late")).orElseThrow();
        assertTrue(late.elapse(1000, 1000).possible().isPresent());
    }
}
