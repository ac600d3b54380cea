package systemtest;

import static harness.Host.get;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javino.protocol.Counter;
import javino.protocol.Outcome;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Sketches do other things beside the library: wait, keep things in the EEPROM, hold up interrupts, limit airtime. */
@InEmulatedTime
class NeighboursTest {

    /** An eighth of what a limit may keep, and a packet of the greatest length, at 1 %. */
    private static final long FROM_NOTHING_SECONDS = 64 + 58;

    @TempDir
    private Path folder;

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
    @Tag("verify")
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
        try (Emulator emulator =
                new Emulator.Scenario().board("uno", "Neighbour", Map.of("model", "uno")).start(folder);
                Host host = Host.of(emulator, "uno")) {
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

    @Test
    void limit_delaysMessages_outlivesAResetAndBeginsSpentAfterAPowerCut() throws Exception {
        try (Emulator emulator = new Emulator.Scenario().board("limited", "LimitedStation").board("other", "Station")
                .start(folder);
                Host other = Host.of(emulator, "other").as("SUPO", Map.of("ROMA", TestKeys.PAIR)).listen()) {
            try (Host host = Host.of(emulator, "limited").as("ROMA", Map.of("SUPO", TestKeys.PAIR))) {
                assertEquals(FROM_NOTHING_SECONDS, host.counter(Counter.AIRTIME_WAIT), 3);
                assertEquals(Outcome.DELIVERED, host.send("SUPO", "tell;one"));
                assertEquals("tell;one", other.content());
                assertEquals(0, host.counter(Counter.RADIO_RESENT));
            }
            try (Host host = Host.of(emulator, "limited").listen()) { // opening the port resets the board
                long wait = host.counter(Counter.AIRTIME_WAIT);
                assertTrue(wait > 0 && wait <= 58 + 1, "about a packet: " + wait);
                emulator.command(Map.of("do", "power-cut", "board", "limited", "duration", 1));
                host.awaitOnline(1);
                assertEquals(FROM_NOTHING_SECONDS, host.counter(Counter.AIRTIME_WAIT), 15);
            }
        }
    }
}
