package diffuser.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.logging.Logger;

import diffuser.report.Warnings;

import org.junit.jupiter.api.Test;

import javino.link.Time;

/** No question to the board is ever answered here, so that each one is the first of a new listening. */
class CommunicabilityTest {

    private final AtomicInteger questions = new AtomicInteger();
    private final AtomicInteger changes = new AtomicInteger();
    private final Communicability communicability = new Communicability(this::ask, changes::incrementAndGet,
            new Warnings(Logger::getAnonymousLogger), Time.REAL);

    private CompletableFuture<Long> ask() {
        questions.incrementAndGet();
        return new CompletableFuture<>();
    }

    @Test
    void usable_onlyWithBoardAddressAndOpenRadio() {
        assertFalse(communicability.isUsable());
        communicability.online(false, false);
        communicability.addressed();
        assertFalse(communicability.isUsable());
        assertEquals(0, changes.get());
        communicability.radio(true);
        assertTrue(communicability.isUsable());
        communicability.radio(false);
        assertFalse(communicability.isUsable());
        communicability.online(true, true);
        assertTrue(communicability.isUsable());
        communicability.offline();
        assertFalse(communicability.isUsable());
        communicability.online(false, true);
        assertFalse(communicability.isUsable());
        assertEquals(4, changes.get());
    }

    @Test
    void silence_notLimited_boardIsNeverAsked() {
        communicability.online(true, true);
        assertEquals(0, questions.get());
    }

    @Test
    void silence_limited_listensOnlyWhileUsable() {
        communicability.silence(Duration.ofHours(1));
        assertEquals(0, questions.get());
        communicability.online(true, true);
        assertEquals(1, questions.get());
        communicability.silence(Duration.ofHours(1));
        assertEquals(1, questions.get(), "nothing new was said");
        communicability.silence(Duration.ofMinutes(1));
        assertEquals(2, questions.get());
        communicability.offline();
        communicability.silence(Duration.ofHours(1));
        assertEquals(2, questions.get());
    }

    @Test
    void close_isForGood() {
        communicability.silence(Duration.ofHours(1));
        communicability.online(true, true);
        communicability.close();
        assertFalse(communicability.isUsable());
        communicability.online(true, true);
        assertFalse(communicability.isUsable());
        assertEquals(1, questions.get());
    }
}
