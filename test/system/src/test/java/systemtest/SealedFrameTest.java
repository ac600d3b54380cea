package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import harness.Transmitter;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javino.protocol.Counter;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * An attacker between two devices that do not hear each other: what it lets through, changes or repeats is its choice.
 */
@InEmulatedTime
class SealedFrameTest {

    private static final Set<Counter> DROPPED = EnumSet.of(Counter.RADIO_BAD_FRAMES, Counter.RADIO_RESERVED,
            Counter.RADIO_NOT_FOR_US, Counter.RADIO_OWN, Counter.RADIO_NO_KEY, Counter.RADIO_BAD_TAG);

    @AutoClose
    private Emulator emulator;
    private Transmitter attacker;
    private Host support;
    private byte[] frame;

    @BeforeEach
    void recordSealedFrame(@TempDir Path folder) throws Exception {
        emulator = new Emulator.Scenario()
                .board("police", "Station", Map.of("position", List.of(0, 0)))
                .board("attacker", "Transmitter", Map.of("position", List.of(90, 0)))
                .board("support", "Station", Map.of("position", List.of(180, 0)))
                .start(folder);
        attacker = Transmitter.of(emulator, "attacker");
        support = Host.of(emulator, "support").as("SUPP", Map.of("SUPO", TestKeys.PAIR));
        try (Host police = Host.of(emulator, "police").as("SUPO", Map.of("SUPP", TestKeys.PAIR))) {
            police.send("SUPP", "tell;x");
        }
        frame = HexFormat.of()
                .parseHex(emulator.await("the sealed frame", event -> event.is("rf-tx", "police")).text("payload"));
    }

    @Test
    @Tag("soak")
    void changedBit_isDroppedAndCounted() throws Exception {
        for (int bit = 0; bit < 8 * frame.length; bit++) {
            byte[] changed = frame.clone();
            changed[bit / 8] ^= (byte) (1 << bit % 8);
            attacker.send(changed);
        }
        attacker.send(frame);

        assertEquals("tell;x", support.content());
        assertEquals(List.of(), support.messages());
        Map<Counter, Long> counters = Host.get(support.board.statistics());
        assertEquals(8 * frame.length, DROPPED.stream().mapToLong(counters::get).sum());
        assertEquals(8 * frame.length + 1, counters.get(Counter.RADIO_RECEIVED));
    }

    @Test
    @Tag("verify")
    void sameFrameAgain_isDroppedAndCounted() throws Exception {
        attacker.send(frame);
        attacker.send(frame);
        attacker.send(frame);

        assertEquals("tell;x", support.content());
        // One may be missed: while support acknowledges the first it hears nothing.
        assertTrue(support.counter(Counter.RADIO_REPEATS) >= 1);
        assertEquals(List.of(), support.messages());
    }
}
