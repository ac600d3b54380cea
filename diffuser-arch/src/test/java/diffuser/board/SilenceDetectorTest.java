package diffuser.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.logging.Filter;
import java.util.logging.Logger;

import diffuser.RunningAgent;
import diffuser.report.Warnings;

import org.junit.jupiter.api.Test;

import javino.link.Time;

/** Each question to the board waits for the test's answer, so that nothing hangs on how long a period lasts. */
class SilenceDetectorTest {

    private static final Duration SHORT = Duration.ofMillis(1);

    private final BlockingQueue<CompletableFuture<Long>> questions = new LinkedBlockingQueue<>();
    private final AtomicInteger changes = new AtomicInteger();
    private final List<String> logged = new CopyOnWriteArrayList<>();
    private final Logger logger = Logger.getAnonymousLogger();
    private final SilenceDetector watch =
            new SilenceDetector(this::ask, changes::incrementAndGet, new Warnings(() -> logger), Time.REAL);

    SilenceDetectorTest() {
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
        CompletableFuture<Long> question = RunningAgent.next(questions, "a question to the board");
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
        watch.begin(SHORT);
        answer(0);
        assertFalse(watch.isSilent());
    }

    @Test
    void count_standsStillAndGoesOn_silenceBeginsAndEnds() throws Exception {
        watch.begin(SHORT);
        answer(7);
        answer(8);
        assertFalse(watch.isSilent());
        answer(8);
        assertTrue(watch.isSilent());
        answer(8);
        assertEquals(1, changes.get());
        answer(9);
        assertFalse(watch.isSilent());
        assertEquals(2, changes.get());
    }

    @Test
    void heard_inSilence_endsItAtOnceAndForTheWholePeriod() throws Exception {
        watch.begin(SHORT);
        answer(7);
        answer(7);
        assertTrue(watch.isSilent());
        watch.heard();
        assertFalse(watch.isSilent());
        answer(7);
        assertFalse(watch.isSilent());
        answer(7);
        assertTrue(watch.isSilent());
    }

    @Test
    void end_inSilence_endsItAndAnswersUnderWayAreNobodys() throws Exception {
        watch.begin(SHORT);
        answer(7);
        answer(7);
        CompletableFuture<Long> late = question();
        watch.end();
        assertFalse(watch.isSilent());
        late.complete(7L);
        watch.heard();
        assertFalse(watch.isSilent());
    }

    @Test
    void begin_again_oldAnswersAreNobodysAndTheFirstNewOneIsNoSilence() throws Exception {
        watch.begin(SHORT);
        answer(7);
        CompletableFuture<Long> late = question();
        watch.begin(SHORT);
        late.complete(7L);
        assertFalse(watch.isSilent());
        answer(7);
        assertFalse(watch.isSilent());
        answer(7);
        assertTrue(watch.isSilent());
    }

    @Test
    void question_fails_isReportedOnceAndNothingChangesUntilTheNextAnswer() throws Exception {
        watch.begin(SHORT);
        answer(7);
        question().completeExceptionally(new IllegalStateException("no counters"));
        assertFalse(watch.isSilent());
        answer(7);
        assertTrue(watch.isSilent());
        question().completeExceptionally(new IllegalStateException("no counters"));
        assertTrue(watch.isSilent());
        answer(8);
        assertFalse(watch.isSilent());
        assertEquals(List.of("cannot tell whether the radio hears anybody: no counters"), logged);
    }
}
