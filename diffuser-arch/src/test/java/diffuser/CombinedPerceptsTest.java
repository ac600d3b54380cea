package diffuser;

import static org.junit.jupiter.api.Assertions.assertFalse;
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
