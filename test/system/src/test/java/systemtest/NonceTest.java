package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/** The nonces that a board seals with over its life. */
@InEmulatedTime
class NonceTest {

    private static final int RUNS = 4;
    private static final int MESSAGES_A_RUN = 100;

    @Test
    @Tag("soak")
    void nonces_neverRepeatOverReboots(@TempDir Path folder) throws Exception {
        Map<String, String> frames = new HashMap<>();
        for (int run = 0; run < RUNS; run++) {
            sendMany(folder, run, frames);
        }
        assertEquals(RUNS * MESSAGES_A_RUN, frames.size());
    }

    // Nobody hears the unicasts, so they are sent again and again: with the same nonce, but byte for byte.
    private static void sendMany(Path folder, int run, Map<String, String> frames) throws Exception {
        try (Emulator emulator = new Emulator.Scenario().board("police", "Station").start(folder);
                Host police =
                        Host.of(emulator, "police").as("SUPO", Map.of("SUPP", TestKeys.PAIR, "//SU", TestKeys.GROUP))) {
            for (int message = 0; message < MESSAGES_A_RUN; message++) {
                police.send(message % 50 == 0 ? "SUPP" : "//SU", "tell;x(" + run + ")");
            }
            emulator.await("the last outcome", MESSAGES_A_RUN, event -> event.is("host-outcome", "police"));
            for (TraceEvent sent : emulator.sentBy("police")) {
                byte[] frame = sent.bytes("payload");
                String nonce = HexFormat.of().formatHex(frame, 10, 16);
                String before = frames.putIfAbsent(nonce, sent.text("payload"));
                assertTrue(before == null || before.equals(sent.text("payload")),
                        "nonce " + nonce + " was used for another frame");
            }
        }
    }
}
