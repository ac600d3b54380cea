package systemtest;

import static harness.Host.get;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import javino.protocol.Counter;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/** The radio on the timer that a sketch names, beside what the other timers are for. */
@InEmulatedTime
class TimersTest {

    private static final double SERVO_PERIOD_SECONDS = 0.020;
    private static final int SERVO_MICROS = 2000;
    /** Between that and the 1500 µs that the sketch begins with. */
    private static final double TURNED_SECONDS = 0.00175;
    private static final int TONE_HERTZ = 1000;
    /** An interrupt may hold up another for so long. */
    private static final double LATENESS_SECONDS = 0.0003;

    @Test
    void onTimer0OfAMega_servoAndToneGoOnWhileItTalks(@TempDir Path folder) throws Exception {
        talksBesideServoAndTone(folder);
    }

    @Test
    @Tag("verify")
    void onTimer3OfAMega_itTalks(@TempDir Path folder) throws Exception {
        try (Emulator emulator = onTimer3().start(folder);
                Host one = Host.of(emulator, "one");
                Host other = Host.of(emulator, "other")) {
            exchange(one, other);
        }
    }

    @Test
    void onTimer3OfAMega_allIsHeard(@TempDir Path folder) throws Exception {
        try (Emulator emulator = onTimer3().start(folder);
                Host one = Host.of(emulator, "one");
                Host other = Host.of(emulator, "other")) {
            exchange(one, other);
            assertAllHeard(emulator, "one", other);
            assertAllHeard(emulator, "other", one);
        }
    }

    private static Emulator.Scenario onTimer3() {
        return new Emulator.Scenario().board("one", "Timer3Station").board("other", "Station");
    }

    private static void talksBesideServoAndTone(Path folder) throws Exception {
        Map<String, Object> watched = Map.of(
                "watch", List.of(Map.of("pin", 9, "name", "servo"), Map.of("pin", 8, "name", "buzzer")));
        try (Emulator emulator =
                new Emulator.Scenario().board("arm", "ServoAndTone", watched).board("other", "Station").start(folder);
                Host arm = Host.of(emulator, "arm");
                Host other = Host.of(emulator, "other")) {
            get(arm.board.act("turn(" + SERVO_MICROS + ")"));
            get(arm.board.act("beep(" + TONE_HERTZ + ")"));
            exchange(arm, other);
            assertAllHeard(emulator, "arm", other);
            assertAllHeard(emulator, "other", arm);

            List<TraceEvent> servo = turned(edges(emulator, "servo"));
            assertTrue(servo.size() > 20, "the servo stood still");
            assertGaps(servo, 1, SERVO_MICROS / 1e6);
            assertGaps(servo, 0, SERVO_PERIOD_SECONDS - SERVO_MICROS / 1e6);
            List<TraceEvent> tone = edges(emulator, "buzzer");
            assertTrue(tone.size() > 200, "the buzzer was silent");
            assertGaps(tone, 1, 0.5 / TONE_HERTZ);
            assertGaps(tone, 0, 0.5 / TONE_HERTZ);
        }
    }

    private static List<TraceEvent> edges(Emulator emulator, String pin) {
        return emulator.trace().stream().filter(event -> event.is("pin", "arm") && event.text("name").equals(pin))
                .toList();
    }

    /** The events from the first pulse of the new length on. */
    private static List<TraceEvent> turned(List<TraceEvent> servo) {
        int first = IntStream.range(0, servo.size() - 1).filter(i -> servo.get(i).number("level") == 1)
                .filter(i -> servo.get(i + 1).seconds() - servo.get(i).seconds() > TURNED_SECONDS)
                .findFirst().orElseThrow();
        return servo.subList(first, servo.size());
    }

    /** How long the pin stays at a level: each time but for what interrupts take, and on the whole as it should. */
    private static void assertGaps(List<TraceEvent> edges, int level, double seconds) {
        List<Double> gaps = IntStream.range(0, edges.size() - 1).filter(i -> edges.get(i).number("level") == level)
                .mapToObj(i -> edges.get(i + 1).seconds() - edges.get(i).seconds()).toList();
        gaps.forEach(gap -> assertEquals(seconds, gap, LATENESS_SECONDS, "level " + level));
        double mean = gaps.stream().mapToDouble(Double::doubleValue).average().orElseThrow();
        assertEquals(seconds, mean, seconds / 100, "level " + level);
    }

    private static void assertAllHeard(Emulator emulator, String sender, Host receiver) {
        assertEquals(emulator.sentBy(sender).size(), receiver.counter(Counter.RADIO_RECEIVED));
    }

    private static void exchange(Host one, Host other) throws Exception {
        one.as("ROMA", Map.of("SUPO", TestKeys.PAIR));
        other.as("SUPO", Map.of("ROMA", TestKeys.PAIR));
        one.send("SUPO", "tell;here");
        assertEquals("tell;here", other.content());
        other.send("ROMA", "tell;there");
        assertEquals("tell;there", one.content());
        assertEquals(1, one.counter(Counter.RADIO_ACKNOWLEDGED));
        assertEquals(1, other.counter(Counter.RADIO_ACKNOWLEDGED));
    }
}
