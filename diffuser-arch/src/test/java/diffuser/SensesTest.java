package diffuser;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CompletableFuture;

import jason.asSyntax.Literal;

import org.junit.jupiter.api.Test;

class SensesTest {

    private final Senses senses = new Senses();

    private void cycle() {
        senses.perceiving();
        senses.believed();
    }

    @Test
    void belief_wantedBeforeAPerception_completesWhenThatIsBelieved() {
        CompletableFuture<Void> belief = senses.belief();
        assertFalse(belief.isDone());
        senses.perceiving();
        assertFalse(belief.isDone());
        senses.believed();
        assertTrue(belief.isDone());
    }

    @Test
    void belief_wantedDuringAPerception_waitsForTheNextOne() {
        senses.perceiving();
        CompletableFuture<Void> belief = senses.belief();
        senses.believed();
        assertFalse(belief.isDone());
        cycle();
        assertTrue(belief.isDone());
    }

    @Test
    void knows_somebodyWaits_theAgentIsNotToSleep() {
        Senses.Now now = new Senses.Now(List.of(), Literal.LTrue);
        senses.perceive(List.of(), now);
        assertTrue(senses.knows(now));
        senses.belief();
        assertFalse(senses.knows(now));
        cycle();
        assertTrue(senses.knows(now));
    }
}
