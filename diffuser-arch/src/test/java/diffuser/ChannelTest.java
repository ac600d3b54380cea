package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.logging.Logger;

import org.junit.jupiter.api.Test;

/** No question to the board is ever answered here, so that each one is the first of a new listening. */
class ChannelTest {

    private final AtomicInteger questions = new AtomicInteger();
    private final AtomicInteger changes = new AtomicInteger();
    private final Channel channel = new Channel(this::ask, changes::incrementAndGet,
            new Warnings(Logger::getAnonymousLogger));

    private CompletableFuture<Long> ask() {
        questions.incrementAndGet();
        return new CompletableFuture<>();
    }

    @Test
    void usable_onlyWithBoardAddressAndOpenRadio() {
        assertFalse(channel.isUsable());
        channel.online(false, false);
        channel.addressed();
        assertFalse(channel.isUsable());
        assertEquals(0, changes.get());
        channel.radio(true);
        assertTrue(channel.isUsable());
        channel.radio(false);
        assertFalse(channel.isUsable());
        channel.online(true, true);
        assertTrue(channel.isUsable());
        channel.offline();
        assertFalse(channel.isUsable());
        channel.online(false, true);
        assertFalse(channel.isUsable());
        assertEquals(4, changes.get());
    }

    @Test
    void silence_notLimited_boardIsNeverAsked() {
        channel.online(true, true);
        assertEquals(0, questions.get());
    }

    @Test
    void silence_limited_listensOnlyWhileUsable() {
        channel.silence(Duration.ofHours(1));
        assertEquals(0, questions.get());
        channel.online(true, true);
        assertEquals(1, questions.get());
        channel.silence(Duration.ofHours(1));
        assertEquals(1, questions.get(), "nothing new was said");
        channel.silence(Duration.ofMinutes(1));
        assertEquals(2, questions.get());
        channel.offline();
        channel.silence(Duration.ofHours(1));
        assertEquals(2, questions.get());
    }

    @Test
    void close_isForGood() {
        channel.silence(Duration.ofHours(1));
        channel.online(true, true);
        channel.close();
        assertFalse(channel.isUsable());
        channel.online(true, true);
        assertFalse(channel.isUsable());
        assertEquals(1, questions.get());
    }
}
