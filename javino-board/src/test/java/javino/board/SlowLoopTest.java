package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
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
        port.setBaud(115_200);
        AtomicInteger hellos = new AtomicInteger();
        fake.line.setLoses(message -> {
            if (message.at(0) == 'H' && hellos.incrementAndGet() == 1) {
                fake.line.askAgain();
            }
            return hellos.get() < 60;
        });
        open(listener);
        assertEquals(List.of("online 1"), listener.until("online"));
        assertEquals(List.of(), port.awaitSpeeds(0));
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
