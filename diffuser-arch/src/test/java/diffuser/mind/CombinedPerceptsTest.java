package diffuser.mind;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;

import jason.asSyntax.Literal;

import org.junit.jupiter.api.Test;

class CombinedPerceptsTest {

    private static final Literal DARK = Literal.parseLiteral("dark");
    private static final Literal OPEN = Literal.parseLiteral("port(open,open)");

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
        Literal time = Literal.parseLiteral("time(3)");
        Literal blocked = Literal.parseLiteral("port(open,blocked)");
        CombinedPercepts.Now first = new CombinedPercepts.Now(List.of(List.of(DARK)), OPEN);
        assertEquals(List.of(time, DARK, OPEN), percepts.perceive(List.of(time), first));
        assertNull(percepts.perceive(null, first));
        CombinedPercepts.Now second = new CombinedPercepts.Now(List.of(), OPEN);
        assertEquals(List.of(time, OPEN), percepts.perceive(null, second));
        assertEquals(List.of(time, blocked),
                percepts.perceive(null, new CombinedPercepts.Now(second.boards(), blocked)));
        assertEquals(List.of(DARK, OPEN), percepts.perceive(List.of(), first));
    }

    /** As of a port that was left and opened anew while the agent did not look. */
    @Test
    void perceive_boardThatCameInAnothersPlace_isToldEvenIfItSaysTheSame() {
        CombinedPercepts.Now first = new CombinedPercepts.Now(List.of(List.of(DARK)), OPEN);
        CombinedPercepts.Now second = new CombinedPercepts.Now(List.of(new ArrayList<>(List.of(DARK))), OPEN);
        percepts.perceive(List.of(), first);
        assertFalse(percepts.knows(second));
        assertEquals(List.of(DARK, OPEN), percepts.perceive(null, second));
        assertNull(percepts.perceive(null, second));
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
