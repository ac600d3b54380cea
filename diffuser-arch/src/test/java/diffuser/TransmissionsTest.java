package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

import javino.protocol.Outcome;

import org.junit.jupiter.api.Test;

class TransmissionsTest {

    private final Transmissions transmissions = new Transmissions();

    private CompletableFuture<Outcome> begun(int number) {
        return transmissions.begin(() -> CompletableFuture.completedFuture(number)).outcome();
    }

    @Test
    void ended_inAnyOrder_eachGetsItsOwn() {
        List<Integer> numbers = new ArrayList<>();
        List<CompletableFuture<Outcome>> outcomes = new ArrayList<>();
        for (int number = 0; number < 256; number++) {
            numbers.add(number);
            outcomes.add(begun(number));
        }
        Collections.shuffle(numbers, new Random(1));
        for (int number : numbers) {
            assertFalse(outcomes.get(number).isDone());
            Outcome outcome = number % 3 == 0 ? Outcome.DELIVERED : Outcome.UNDELIVERED;
            transmissions.ended(number, outcome);
            assertEquals(outcome, outcomes.get(number).join());
        }
    }

    @Test
    void ended_unknownOrEndedBefore_changesNothing() {
        transmissions.ended(7, Outcome.DELIVERED);
        CompletableFuture<Outcome> seven = begun(7);
        assertFalse(seven.isDone());
        transmissions.ended(7, Outcome.UNDELIVERED);
        transmissions.ended(7, Outcome.DELIVERED);
        assertEquals(Outcome.UNDELIVERED, seven.join());
    }

    @Test
    void ended_takenLater_getsItsOwn() {
        CompletableFuture<Integer> taken = new CompletableFuture<>();
        CompletableFuture<Outcome> outcome = transmissions.begin(() -> taken).outcome();
        taken.complete(3);
        transmissions.ended(3, Outcome.DELIVERED);
        assertEquals(Outcome.DELIVERED, outcome.join());
    }

    @Test
    void begin_refused_numberOfAnotherStays() {
        CompletableFuture<Outcome> three = begun(3);
        CompletableFuture<Integer> refused = CompletableFuture.failedFuture(new IllegalStateException("refused"));
        CompletableFuture<Outcome> none = transmissions.begin(() -> refused).outcome();
        transmissions.ended(3, Outcome.DELIVERED);
        assertTrue(three.isDone());
        assertFalse(none.isDone());
    }

    @Test
    void begin_numberComesAgain_formerIsUndelivered() {
        CompletableFuture<Outcome> former = begun(3);
        CompletableFuture<Outcome> latter = begun(3);
        assertEquals(Outcome.UNDELIVERED, former.join());
        transmissions.ended(3, Outcome.DELIVERED);
        assertEquals(Outcome.DELIVERED, latter.join());
    }

    @Test
    void begin_boardQuickerThanItsCaller_outcomeIsNotMissed() throws InterruptedException {
        Thread session = new Thread(() -> transmissions.ended(3, Outcome.DELIVERED));
        session.setDaemon(true);
        CompletableFuture<Outcome> outcome = transmissions.begin(() -> {
            session.start();
            awaitBlockedOrOver(session);
            return CompletableFuture.completedFuture(3);
        }).outcome();
        session.join(TimeUnit.SECONDS.toMillis(RunningAgent.PATIENCE_SECONDS));
        assertEquals(Outcome.DELIVERED, outcome.getNow(null));
    }

    private static void awaitBlockedOrOver(Thread thread) {
        while (thread.getState() != Thread.State.BLOCKED && thread.getState() != Thread.State.TERMINATED) {
            Thread.onSpinWait();
        }
    }
}
