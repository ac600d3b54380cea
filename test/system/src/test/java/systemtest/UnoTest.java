package systemtest;

import static harness.Host.get;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javino.protocol.Counter;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** An Uno, a quarter of a Mega's RAM, beside a Mega. */
@InEmulatedTime
class UnoTest {

    /** The longest content that an Uno takes from its host (javino-firmware/src/Config.h). */
    private static final int MAX_CONTENT = 67;
    /** The longest sealed content of one packet: an Uno receives no fragments. */
    private static final int MAX_SEALED_IN_A_PACKET = 53;

    /** Seconds after which a Mega can tell that it has been up for longer than the next message is on its way. */
    private static final double LONG_UP_SECONDS = 8;

    @AutoClose
    private Emulator emulator;
    private Host uno;
    private Host mega;

    @BeforeEach
    void switchOn(@TempDir Path folder) throws Exception {
        emulator = new Emulator.Scenario()
                .board("uno", "RadioBlink", Map.of("model", "uno"))
                .board("mega", "Station")
                .start(folder);
        uno = Host.of(emulator, "uno").as("LAMP", Map.of("ROMA", TestKeys.PAIR, "//LA", TestKeys.GROUP));
        mega = Host.of(emulator, "mega").as("ROMA", Map.of("LAMP", TestKeys.PAIR, "//LA", TestKeys.GROUP));
    }

    @Test
    @Tag("verify")
    void unicast_isDeliveredBothWays() throws Exception {
        uno.send("ROMA", "tell;bright");
        assertEquals("LAMP to ROMA: tell;bright", mega.received());
        mega.send("LAMP", "achieve;light(off)");
        assertEquals("ROMA to LAMP: achieve;light(off)", uno.received());
        assertEquals(1, uno.counter(Counter.RADIO_ACKNOWLEDGED));
        assertEquals(1, mega.counter(Counter.RADIO_ACKNOWLEDGED));
    }

    @Test
    void longestContent_isDeliveredBothWays() throws Exception {
        uno.send("ROMA", text(MAX_CONTENT));
        assertEquals("LAMP to ROMA: " + text(MAX_CONTENT), mega.received());
        mega.send("LAMP", text(MAX_SEALED_IN_A_PACKET));
        assertEquals("ROMA to LAMP: " + text(MAX_SEALED_IN_A_PACKET), uno.received());
        mega.send("////", text(MAX_CONTENT));
        assertEquals("ROMA to ////: " + text(MAX_CONTENT), uno.received());
    }

    @Test
    void unicastToBoardThatLostItsMemory_isSealedAnewAndDelivered() throws Exception {
        uno.send("ROMA", "tell;before");
        emulator.command(Map.of("do", "power-cut", "board", "mega", "duration", 0.2));
        mega.awaitOnline(2);
        get(mega.board.radio(true));
        Host.pause(LONG_UP_SECONDS);

        uno.send("ROMA", "tell;after");

        assertEquals(2, uno.counter(Counter.RADIO_ACKNOWLEDGED));
        assertTrue(mega.counter(Counter.RADIO_STALE) > 0);
    }

    @Test
    void longerContent_isRefused() {
        AssertionError refused = assertThrows(AssertionError.class, () -> uno.send("ROMA", text(MAX_CONTENT + 1)));
        assertTrue(refused.getMessage().contains("TOO_LONG"), refused.getMessage());
    }

    @Test
    void longerContentFromTheAir_isDroppedAndUndelivered() throws Exception {
        mega.send("LAMP", text(MAX_SEALED_IN_A_PACKET + 1));

        assertEquals(1, mega.counter(Counter.RADIO_UNDELIVERED));
        assertTrue(uno.counter(Counter.RADIO_FRAGMENTS_DROPPED) > 0);
        assertEquals(List.of(), uno.messages());
    }

    private static String text(int length) {
        return "tell;" + "x".repeat(length - "tell;".length());
    }
}
