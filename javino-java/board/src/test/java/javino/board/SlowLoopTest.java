package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.locks.LockSupport;
import javino.link.Link;
import javino.link.LinkOpener;
import javino.protocol.Counter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Boards whose sketch has a {@code delay()} in {@code loop()}, as examples of slow sensors have it. */
class SlowLoopTest extends BoardFixture {

    private static final Duration LOOP = Duration.ofMillis(600);

    @ParameterizedTest
    @CsvSource({"2000, 2.0", "1960, 2.0", "600, 0.6"})
    void open_boardThatAnswersHelloLate_tellsHowLongItsLoopTook(long millis, String seconds) throws Exception {
        fake.setCounter(Counter.LOOP_MILLIS, millis);
        fake.line.setDelay(LOOP);
        openPatiently();
        assertEquals(List.of("warning the sketch's loop took " + seconds
                + " s, and delays all requests so long: no delay() in loop()", "online 1"), listener.until("online"));
    }

    @Test
    void open_boardThatAnswersLateButLoopsOften_isNotWarnedOf() throws Exception {
        fake.setCounter(Counter.LOOP_MILLIS, 200);
        fake.line.setDelay(LOOP);
        openPatiently();
        assertEquals(List.of("online 1"), listener.until("online"));
    }

    @Test
    void open_boardThatAsksAgainAndIsLate_isWaitedForAtItsSpeed() throws Exception {
        AskingLink link = new AskingLink();
        // So that only the number of hellos ends them, on a busy machine too.
        board = Board.open(link, quick(config -> config.setActionTime(Duration.ofHours(1))), listener);
        for (int i = 0; i < 60; i++) {
            assertEquals("hello", link.events.take(), "of the host, number " + i);
        }
    }

    /** A board that asks again for each hello, and answers none. */
    private static final class AskingLink implements LinkOpener, Link {

        private final BlockingQueue<String> events = new LinkedBlockingQueue<>();
        private boolean asks;
        private int speed = 115_200;

        @Override
        public Link open() {
            return this;
        }

        @Override
        public String name() {
            return "asking";
        }

        @Override
        public void write(byte[] bytes) {
            events.add("hello");
            asks = true;
        }

        @Override
        public int read(byte[] into, Duration timeout) {
            if (!asks) {
                LockSupport.parkNanos(timeout.toNanos());
                return 0;
            }
            asks = false;
            System.arraycopy(new byte[] {0, 1, 0}, 0, into, 0, 3);
            return 3;
        }

        @Override
        public void wake() {
            // A read ends soon.
        }

        @Override
        public int baud() {
            return speed;
        }

        @Override
        public void setBaud(int baud) {
            if (baud != speed) {
                speed = baud;
                events.add("speed " + baud);
            }
        }

        @Override
        public void close() {
            // There is nothing to free.
        }
    }

    @Test
    void request_ofABoardThatAnswersHelloLate_isSaidToWaitForItsLoop() throws Exception {
        fake.line.setDelay(LOOP);
        fake.line.setLoses(message -> message.at(0) != 'H');
        open(listener, config -> config.setHelloInterval(Duration.ofSeconds(1)).setAttempts(1)
                .setActionTime(Duration.ofMillis(1)));
        assertEquals("offline fake: the board left a request unanswered; is there a delay() in its sketch's loop()?",
                listener.next());
    }

    private void openPatiently() {
        open(listener,
                config -> config.setHelloInterval(Duration.ofSeconds(1)).setReplyTimeout(Duration.ofSeconds(10)));
    }
}
