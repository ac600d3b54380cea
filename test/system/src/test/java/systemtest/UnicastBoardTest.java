package systemtest;

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
import java.util.concurrent.ExecutionException;
import javino.protocol.Address;
import javino.protocol.Counter;
import javino.protocol.Key;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** An Uno whose sketch makes a JavinoUnicastBoard, beside a Mega that has all. */
@InEmulatedTime
class UnicastBoardTest {

    private static final String LINE = "failed: UNICASTS_ONLY, the board has neither groups, broadcasts";

    @AutoClose
    private Emulator emulator;
    private Host uno;
    private Host mega;

    @BeforeEach
    void switchOn(@TempDir Path folder) throws Exception {
        emulator = new Emulator.Scenario().board("uno", "Turntable", Map.of("model", "uno")).board("mega", "Station")
                .start(folder);
        uno = Host.of(emulator, "uno").as("LAMP", Map.of("ROMA", TestKeys.PAIR));
        mega = Host.of(emulator, "mega").as("ROMA", Map.of("LAMP", TestKeys.PAIR, "//LA", TestKeys.GROUP));
    }

    @Test
    @Tag("verify")
    void unicast_isDeliveredBothWays() throws Exception {
        uno.send("ROMA", "tell;there");
        assertEquals("tell;there", mega.content());
        mega.send("LAMP", "tell;back");
        assertEquals("tell;back", uno.content());
    }

    @Test
    void messageToMany_isRefused() {
        for (String to : List.of("//LA", "////")) {
            AssertionError refused = assertThrows(AssertionError.class, () -> uno.send(to, "tell;x"));
            assertTrue(refused.getMessage().contains(LINE), refused.getMessage());
        }
    }

    @Test
    void messageToMany_onTheAir_isCountedAndNotReceived() throws Exception {
        for (String to : List.of("////", "//LA")) {
            long counted = uno.counter(Counter.RADIO_NOT_FOR_US);
            mega.send(to, "tell;x");
            mega.send("LAMP", "tell;last");
            assertEquals("tell;last", uno.content());
            assertTrue(uno.counter(Counter.RADIO_NOT_FOR_US) > counted, to);
        }
        assertEquals(List.of(), uno.messages());
    }

    @Test
    void renewal_isRefused() {
        ExecutionException refused = assertThrows(ExecutionException.class,
                () -> Host.await(uno.board.renewKey(Address.parse("ROMA"), Key.ofHex("11".repeat(16)))));
        assertTrue(refused.getCause().getMessage().contains(LINE), refused.getCause().getMessage());
    }
}
