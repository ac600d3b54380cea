package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.file.Path;
import java.util.Map;
import javino.protocol.Address;
import javino.protocol.Airtime;
import javino.protocol.Content;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Boards that begin anew within the last bits of their first packets. */
@InEmulatedTime
class BrokenOffTest {

    private static final double BIT_RATE = 2000;
    private static final int MISSING_BITS = 5;
    private static final Map<String, Object> SENDING = Map.of("pin", 12, "level", 1);

    /** When the board has begun to send and all is out but for its last bits; the first bit is no carrier. */
    private static double end(int bytes) {
        return (Airtime.bits(bytes) - 1 - MISSING_BITS) / BIT_RATE;
    }

    private static Map<String, Object> reset(String board, int bytes) {
        return Map.of("t", end(bytes), "board", board, "do", "reset", "after", SENDING);
    }

    private static Map<String, Object> powerCut(String board, int bytes) {
        return Map.of("t", end(bytes), "board", board, "do", "power-cut", "duration", 0.001, "after", SENDING);
    }

    @Test
    @Tag("verify")
    void packet_thatLacksItsLastBits_isMended(@TempDir Path folder) throws Exception {
        Map<String, Object> more = Map.of("resetOnOpen", false);
        try (Emulator emulator = new Emulator.Scenario()
                .board("police", "Station", more).fault(reset("police", 30))
                .board("support", "Station", more).fault(powerCut("support", 18))
                .board("bus", "Station", more).fault(reset("bus", 77))
                .board("hospital", "Station", more).fault(reset("hospital", 18)).start(folder);
                Host police = Host.of(emulator, "police").as("SUPO", Map.of("SUPP", TestKeys.PAIR));
                Host support = Host.of(emulator, "support").as("SUPP", Map.of("SUPO", TestKeys.PAIR));
                Host bus = Host.of(emulator, "bus").as("ROMA", Map.of("SUHO", TestKeys.PAIR));
                Host hospital = Host.of(emulator, "hospital").as("SUHO", Map.of("ROMA", TestKeys.PAIR))) {
            bus.awaitOnline(1);
            police.board.transmit(Address.parse("SUPP"), Content.parse("tell;x"));
            assertEquals("tell;x", support.content());
            emulator.await("the loss of power", 2, event -> event.is("reset", "support"));

            bus.board.transmit(Address.parse("SUHO"), Content.parse("tell;long(\"" + "x".repeat(60) + "\")"));
            bus.awaitOnline(1);
            bus.send("SUHO", "tell;x");
            assertEquals("tell;x", hospital.content());
        }
    }
}
