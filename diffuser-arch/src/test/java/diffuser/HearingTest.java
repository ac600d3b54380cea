package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.logging.Filter;
import java.util.logging.Logger;

import org.junit.jupiter.api.Test;

/** Each question to the board waits for the test's answer, so that nothing hangs on how long a period lasts. */
class HearingTest {

    private static final Duration SHORT = Duration.ofMillis(1);

    private final BlockingQueue<CompletableFuture<Long>> questions = new LinkedBlockingQueue<>();
    private final AtomicInteger changes = new AtomicInteger();
    private final List<String> logged = new CopyOnWriteArrayList<>();
    private final Logger logger = Logger.getAnonymousLogger();
    private final Hearing hearing = new Hearing(this::ask, changes::incrementAndGet, new Warnings(() -> logger));

    HearingTest() {
        Filter recordOnly = line -> {
            logged.add(line.getMessage());
            return false;
        };
        logger.setFilter(recordOnly);
    }

    private CompletableFuture<Long> ask() {
        CompletableFuture<Long> question = new CompletableFuture<>();
        questions.add(question);
        return question;
    }

    private CompletableFuture<Long> question() throws InterruptedException {
        CompletableFuture<Long> question = questions.poll(RunningAgent.PATIENCE_SECONDS, TimeUnit.SECONDS);
        assertTrue(question != null, "the board was asked no more");
        while (question.getNumberOfDependents() == 0) {
            // The timer's thread has asked, and does not wait for the answer yet.
            Thread.onSpinWait();
        }
        return question;
    }

    private void answer(long packets) throws InterruptedException {
        question().complete(packets);
    }

    @Test
    void count_firstAnswer_isNoSilence() throws Exception {
        hearing.begin(SHORT);
        answer(0);
        assertFalse(hearing.isSilent());
    }

    @Test
    void count_standsStillAndGoesOn_silenceBeginsAndEnds() throws Exception {
        hearing.begin(SHORT);
        answer(7);
        answer(8);
        assertFalse(hearing.isSilent());
        answer(8);
        assertTrue(hearing.isSilent());
        answer(8);
        assertEquals(1, changes.get());
        answer(9);
        assertFalse(hearing.isSilent());
        assertEquals(2, changes.get());
    }

    @Test
    void heard_inSilence_endsItAtOnceAndForTheWholePeriod() throws Exception {
        hearing.begin(SHORT);
        answer(7);
        answer(7);
        assertTrue(hearing.isSilent());
        hearing.heard();
        assertFalse(hearing.isSilent());
        answer(7);
        assertFalse(hearing.isSilent());
        answer(7);
        assertTrue(hearing.isSilent());
    }

    @Test
    void end_inSilence_endsItAndAnswersUnderWayAreNobodys() throws Exception {
        hearing.begin(SHORT);
        answer(7);
        answer(7);
        CompletableFuture<Long> late = question();
        hearing.end();
        assertFalse(hearing.isSilent());
        late.complete(7L);
        hearing.heard();
        assertFalse(hearing.isSilent());
    }

    @Test
    void begin_again_oldAnswersAreNobodysAndTheFirstNewOneIsNoSilence() throws Exception {
        hearing.begin(SHORT);
        answer(7);
        CompletableFuture<Long> late = question();
        hearing.begin(SHORT);
        late.complete(7L);
        assertFalse(hearing.isSilent());
        answer(7);
        assertFalse(hearing.isSilent());
        answer(7);
        assertTrue(hearing.isSilent());
    }

    @Test
    void question_fails_isReportedOnceAndNothingChangesUntilTheNextAnswer() throws Exception {
        hearing.begin(SHORT);
        answer(7);
        question().completeExceptionally(new IllegalStateException("no counters"));
        assertFalse(hearing.isSilent());
        answer(7);
        assertTrue(hearing.isSilent());
        question().completeExceptionally(new IllegalStateException("no counters"));
        assertTrue(hearing.isSilent());
        answer(8);
        assertFalse(hearing.isSilent());
        assertEquals(List.of("cannot tell whether the radio hears anybody: no counters"), logged);
    }
}
