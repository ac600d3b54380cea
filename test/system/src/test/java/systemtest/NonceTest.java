package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.TestKeys;
import harness.TraceEvent;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a board seals with over its life. */
class NonceTest {

    private static final int RUNS = 4;
    private static final int MESSAGES_A_RUN = 250;

    @Test
    void nonces_neverRepeatOverReboots(@TempDir Path folder) throws Exception {
        Set<String> nonces = new HashSet<>();
        Set<String> ivs = new HashSet<>();
        for (int run = 0; run < RUNS; run++) {
            sendMany(folder, nonces, ivs);
        }
        assertEquals(RUNS * MESSAGES_A_RUN, nonces.size());
        assertEquals(RUNS * MESSAGES_A_RUN, ivs.size());
    }

    private static void sendMany(Path folder, Set<String> nonces, Set<String> ivs) throws Exception {
        try (Emulator emulator = new Emulator.Scenario().speed("max").board("police", "Station").start(folder);
             Host police = Host.of(emulator, "police").as("SUPO", Map.of("SUPP", TestKeys.PAIR, "//SU", TestKeys.GROUP))) {
            for (int message = 0; message < MESSAGES_A_RUN; message++) {
                police.send(message % 2 == 0 ? "SUPP" : "//SU", "tell;x");
            }
            emulator.await("all packets", MESSAGES_A_RUN, event -> event.is("rf-tx", "police"));
            for (TraceEvent sent : emulator.sentBy("police")) {
                byte[] frame = HexFormat.of().parseHex(sent.text("payload"));
                String nonce = HexFormat.of().formatHex(frame, 10, 16);
                assertTrue(nonces.add(nonce), "nonce " + nonce + " was used before");
                byte[] key = frame[0] == '/' ? TestKeys.GROUP : TestKeys.PAIR;
                ivs.add(HexFormat.of().formatHex(Sealing.iv(key, frame)));
            }
        }
    }
}
