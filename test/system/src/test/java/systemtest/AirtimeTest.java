package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.file.Path;
import java.util.Map;
import javino.protocol.Counter;
import javino.protocol.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A board whose radio may send for 1 % of each hour (SPEC 7.6). */
@InEmulatedTime
class AirtimeTest {

    /** An eighth of what it may keep, and a packet of the greatest length. */
    private static final long FROM_NOTHING_SECONDS = 64 + 58;

    @TempDir
    private Path folder;

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
