package diffuser.mind;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CompletableFuture;

import jason.asSyntax.Literal;

import org.junit.jupiter.api.Test;

class CombinedPerceptsTest {

    private final CombinedPercepts percepts = new CombinedPercepts();

    private void cycle() {
        percepts.perceiving();
        percepts.believed();
    }

    @Test
    void belief_wantedBeforeAPerception_completesWhenThatIsBelieved() {
        CompletableFuture<Void> belief = percepts.belief();
        assertFalse(belief.isDone());
        percepts.perceiving();
        assertFalse(belief.isDone());
        percepts.believed();
        assertTrue(belief.isDone());
    }

    @Test
    void belief_wantedDuringAPerception_waitsForTheNextOne() {
        percepts.perceiving();
        CompletableFuture<Void> belief = percepts.belief();
        percepts.believed();
        assertFalse(belief.isDone());
        cycle();
        assertTrue(belief.isDone());
    }

    @Test
    void perceive_changedOnOneSide_isAllOfBothAndNullIfNothingHasChanged() {
        Literal dark = Literal.parseLiteral("dark");
        Literal time = Literal.parseLiteral("time(3)");
        Literal open = Literal.parseLiteral("port(open,open)");
        Literal blocked = Literal.parseLiteral("port(open,blocked)");
        CombinedPercepts.Now first = new CombinedPercepts.Now(List.of(List.of(dark)), open);
        assertEquals(List.of(time, dark, open), percepts.perceive(List.of(time), first));
        assertNull(percepts.perceive(null, first));
        CombinedPercepts.Now second = new CombinedPercepts.Now(List.of(), open);
        assertEquals(List.of(time, open), percepts.perceive(null, second));
        assertEquals(List.of(time, blocked),
                percepts.perceive(null, new CombinedPercepts.Now(second.boards(), blocked)));
        assertEquals(List.of(dark, open), percepts.perceive(List.of(), first));
    }

    @Test
    void knows_somebodyWaits_theAgentIsNotToSleep() {
        CombinedPercepts.Now now = new CombinedPercepts.Now(List.of(), Literal.LTrue);
        percepts.perceive(List.of(), now);
        assertTrue(percepts.knows(now));
        percepts.belief();
        assertFalse(percepts.knows(now));
        cycle();
        assertTrue(percepts.knows(now));
    }
}
