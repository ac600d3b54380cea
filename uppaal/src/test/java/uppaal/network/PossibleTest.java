package uppaal.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Set;
import org.junit.jupiter.api.Test;
import uppaal.Sketch;

class PossibleTest {
    private static Possible door() {
        return Possible.first(Sketch.of("broadcast chan open, close, ring;")
                .template("Door", "Shut -> Locked", "Shut -> Ajar; sync open!", "Ajar -> Shut; sync close!",
                        "Locked -> Locked; sync ring!")
                .network());
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
    void after_timedNetwork_timePassesUnseen() {
        Possible timed = Possible.first(Sketch.of("broadcast chan late; clock x;")
                .template("Clock", "A{x<=3} -> B; guard x >= 2; sync late!").network());
        assertTrue(timed.after("late").isPresent());
    }
}
