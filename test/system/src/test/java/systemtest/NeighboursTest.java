package systemtest;

import static harness.Host.get;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.TestKeys;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javino.protocol.Counter;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What sketches do beside the library: print, wait, keep things in the EEPROM, miss what lasts for a moment. */
@Tag("verify")
class NeighboursTest {

    private static final int PRESSES = 3;

    @TempDir
    private Path folder;

    private static Emulator.Scenario uno(List<Map<String, Object>> sensors) {
        return new Emulator.Scenario().board("uno", "Neighbour", Map.of("model", "uno", "sensors", sensors));
    }

    private static Map<String, Object> light(int value) {
        return Map.of("type", "ldr", "pin", "A0", "light", List.of(List.of(0, value)));
    }

    /** A button that is pressed for a moment every other second, from when percepts are wanted. */
    private static Map<String, Object> button() {
        List<List<Number>> series = new ArrayList<>(List.of(List.of(0, 0)));
        for (int i = 1; i <= PRESSES; i++) {
            series.add(List.of(2 * i, 1));
            series.add(List.of(2 * i + 0.2, 0));
        }
        return Map.of("type", "digital", "pin", 2, "level", series, "after", Map.of("pin", 13));
    }

    @Test
    void textOnTheLine_delaysNoPerceptAndLosesNoAction() throws Exception {
        try (Emulator emulator = uno(List.of(light(100))).start(folder); Host host = Host.of(emulator, "uno")) {
            host.board.percepts(true);
            for (int millis : List.of(100, 5)) {
                get(host.board.act("print(" + millis + ")"));
                for (int kept = millis; kept < millis + 5; kept++) {
                    get(host.board.act("keep(" + kept + ")"));
                    String percept = "kept(" + kept + ")";
                    host.percepts(percepts -> percepts.contains(percept));
                }
            }
            host.awaitOnline(1);
            assertEquals(0, host.counter(Counter.SERIAL_DAMAGED));
        }
    }

    @Test
    void actionThatTakesSeconds_succeedsOnceAndLosesNothing() throws Exception {
        try (Emulator emulator = new Emulator.Scenario().board("slow", "NeighbourStation").start(folder);
                Host host = Host.of(emulator, "slow").as("ROMA", Map.of("SUPO", TestKeys.PAIR))) {
            host.board.percepts(true);
            get(host.board.act("wait(1000)"));
            get(host.board.act("wait(8000)"));
            host.percepts(List.of("waited(2)")::equals);
            assertEquals(8000, host.counter(Counter.ACTION_MILLIS), 100);
            host.awaitOnline(1);
            assertEquals(1, get(host.board.keys()).size());
        }
    }

    @Test
    void numbers_haveTwoDecimalsAndDeadBands() throws Exception {
        try (Emulator emulator = uno(List.of(light(83))).start(folder); Host host = Host.of(emulator, "uno")) {
            host.board.percepts(true);
            List<String> percepts = host.percepts(any -> true);
            assertTrue(percepts.containsAll(List.of("precise(20.75)", "steady(20.75)", "text(83)")),
                    percepts::toString);
        }
    }

    @Test
    void pressForAMoment_isToldThoughPerceptsAreRare() throws Exception {
        try (Emulator emulator = uno(List.of(light(0), button())).speed("0.3").start(folder);
                Host host = Host.of(emulator, "uno")) {
            host.board.perceptInterval(Duration.ofSeconds(1));
            host.board.percepts(true);
            for (int i = 0; i < PRESSES; i++) {
                host.percepts(percepts -> percepts.contains("pressed"));
                host.percepts(percepts -> !percepts.contains("pressed"));
            }
        }
    }

    @Test
    void eepromOfTheSketch_andIdAndKeys_outliveABoot() throws Exception {
        try (Emulator emulator = new Emulator.Scenario().board("station", "NeighbourStation").start(folder)) {
            try (Host host = Host.of(emulator, "station").as("ROMA", Map.of("SUPO", TestKeys.PAIR))) {
                get(host.board.act("keep(123456)"));
            }
            try (Host host = Host.of(emulator, "station")) {
                assertEquals("ROMA", get(host.board.greeted()).rfId().orElseThrow().toString());
                assertFalse(get(host.board.keys()).isEmpty());
            }
        }
    }

    @Test
    void longestTimes_sayWhichFunctionItWas() throws Exception {
        try (Emulator emulator = uno(List.of(light(0))).start(folder); Host host = Host.of(emulator, "uno")) {
            get(host.board.act("wait(300)"));
            get(host.board.act("slowLoop(100)"));
            get(host.board.act("slowPercepts(200)"));
            host.board.percepts(true);
            host.percepts(any -> true);
            assertEquals(300, host.counter(Counter.ACTION_MILLIS), 5);
            assertEquals(200, host.counter(Counter.PERCEPTS_MILLIS), 20);
            assertEquals(100, host.counter(Counter.LOOP_MILLIS), 5);
        }
    }

    @Test
    void interruptsThatASketchHoldsUp_areMeasured() throws Exception {
        try (Emulator emulator = new Emulator.Scenario().board("strip", "NeighbourStation").unmodelled().start(folder);
                Host host = Host.of(emulator, "strip").as("ROMA", Map.of())) {
            host.send("////", "tell;hello");
            long alone = host.counter(Counter.RADIO_LATE_MICROS);
            assertTrue(alone < 200, alone + " µs");
            get(host.board.act("strip(1800)"));
            host.send("////", "tell;hello");
            assertEquals(1800, host.counter(Counter.RADIO_LATE_MICROS), 300);
        }
    }
}
