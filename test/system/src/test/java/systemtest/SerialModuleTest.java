package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javino.protocol.Address;
import javino.protocol.Counter;
import javino.protocol.Outcome;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Stations with a serial module at their second UART. */
@InEmulatedTime
class SerialModuleTest {

    private static final Address TO = Address.parse("SUPO");
    private static final int STEP_METRES = 80;

    @TempDir
    Path folder;
    @AutoClose
    private Emulator emulator;
    private Host sender;
    private Host receiver;

    private void start(String module, double loss, int hops) throws Exception {
        Emulator.Scenario scenario = new Emulator.Scenario().radio("module", module).radio("loss", loss);
        for (int i = 0; i <= hops; i++) {
            String name = i == 0 ? "from" : i == hops ? "to" : "relay";
            scenario.board(name, "Station", Map.of("position", List.of(i * STEP_METRES, 0)));
        }
        emulator = scenario.start(folder);
        sender = Host.of(emulator, "from").as("ROMA", Map.of("SUPO", TestKeys.PAIR));
        receiver = Host.of(emulator, "to").as("SUPO", Map.of("ROMA", TestKeys.PAIR));
    }

    private void assertDelivers(String content) throws Exception {
        assertEquals(Outcome.DELIVERED, sender.send("SUPO", content));
        assertEquals(content, receiver.content());
    }

    @ParameterizedTest
    @ValueSource(strings = {"hc-12", "e32"})
    void unicasts_withoutLosses_areSentOnce(String module) throws Exception {
        start(module, 0, 1);
        for (int i = 0; i < 3; i++) {
            assertDelivers("tell;n(" + i + ")");
        }
        assertEquals(0, sender.counter(Counter.RADIO_RESENT));
        assertEquals(0, receiver.counter(Counter.RADIO_DAMAGED) + receiver.counter(Counter.RADIO_MISSED));
        assertEquals(module, emulator.sentBy("from").get(0).text("radio"));
    }

    @ParameterizedTest
    @Tag("verify")
    @ValueSource(strings = {"hc-12", "e32"})
    void longUnicasts_withLosses_areDelivered(String module) throws Exception {
        start(module, 0.05, 1);
        assertDelivers("tell;long(\"" + "x".repeat(200) + "\")");
    }

    @Test
    void unicast_byARelay_isDelivered() throws Exception {
        start("hc-12", 0, 2);
        try (Host relay = Host.of(emulator, "relay")) {
            assertTrue(Host.get(relay.board.relaying(true)));
            assertDelivers("tell;help");
            assertEquals(1, relay.counter(Counter.RELAY_COPIES));
        }
    }
}
