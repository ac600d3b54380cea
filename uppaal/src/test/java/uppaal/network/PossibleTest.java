package uppaal.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Set;
import org.junit.jupiter.api.Test;
import uppaal.Sketch;
import uppaal.language.Expressions;
import uppaal.language.Term;

class PossibleTest {
    private static Possible of(Network network) {
        return Possible.first(network, true, (state, move) -> move.channel().map(channel -> channel.name()));
    }

    private static Network doors() {
        return Sketch.of("broadcast chan open, close, ring;")
                .template("Door", "Shut -> Locked", "Shut -> Ajar; sync open!", "Ajar -> Shut; sync close!",
                        "Locked -> Locked; sync ring!")
                .network();
    }

    private static Possible door() {
        return of(doors());
    }

    private static Possible clock() {
        return of(Sketch.of("broadcast chan late; clock x;")
                .template("Clock", "A{x<=3} -> B; guard x >= 2; sync late!").network());
    }

    @Test
    void after_aMoveThatIsPossible_knowsWhatFollows() {
        Possible open = door().after("open").orElseThrow();
        assertEquals(Set.of("close"), open.next());
        assertEquals(Set.of("open", "ring"), open.after("close").orElseThrow().next());
    }

    @Test
    void after_aMoveThatOnlyAnUnseenOneAllows_isPossibleAndRulesOthersOut() {
        Possible rung = door().after("ring").orElseThrow();
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

    @Test
    void only_knowsWhereAFormulaIsTrue_andTellsTheWaysThere() {
        Network doors = doors();
        Possible.Seen locked = of(doors).only(Expressions.parse("Door.Locked", doors, "test"));
        assertEquals(Set.of("ring"), locked.possible().orElseThrow().next());
        assertEquals(Set.of("Door: Shut -> Locked, 1"), locked.edges());
        Possible.Seen ajar = of(doors).only(Expressions.parse("Door.Ajar", doors, "test"));
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
        Possible late = clock().elapse(2, 2).possible().flatMap(known -> known.after("late")).orElseThrow();
        assertTrue(late.elapse(1000, 1000).possible().isPresent());
    }
}
