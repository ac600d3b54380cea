package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.GatewayProcess;
import harness.Host;
import harness.Mosquitto;
import harness.TestKeys;
import harness.TraceEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Outcome;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two cells out of each other's range, joined by gateways over a broker with TLS. */
class GatewayTest {

    private static final List<Double> WEST = List.of(0.0, 0.0);
    private static final List<Double> EAST = List.of(100_000.0, 0.0);

    private Mosquitto broker;
    private Emulator emulator;
    private Host police;
    private Host bus;
    private GatewayProcess west;
    private GatewayProcess east;

    @BeforeEach
    void switchOn(@TempDir Path folder) throws Exception {
        broker = Mosquitto.start(folder.resolve("broker"));
        emulator = new Emulator.Scenario()
                .board("police", "Station", Map.of("position", WEST)).board("west", "Station", Map.of("position", WEST))
                .board("bus", "Station", Map.of("position", EAST)).board("east", "Station", Map.of("position", EAST))
                .board("spare", "Station", Map.of("position", EAST))
                .start(folder);
        police = Host.of(emulator, "police").as("SUPO", Map.of("ROMA", TestKeys.PAIR, "//RO", TestKeys.GROUP));
        bus = Host.of(emulator, "bus").as("ROMA", Map.of("SUPO", TestKeys.PAIR, "//RO", TestKeys.GROUP));
        west = GatewayProcess.join(emulator, "west", "west", broker, broker.port());
        east = GatewayProcess.join(emulator, "east", "east", broker, broker.port());
    }

    @AfterEach
    void switchOff() {
        west.close();
        east.close();
        police.close();
        bus.close();
        emulator.close();
        broker.close();
    }

    private static Outcome deliver(Host from, String to, String content) {
        return Host.get(from.board.transmit(Address.parse(to), Content.parse(content)).end());
    }

    @Test
    void unicast_thereAndBack_isDelivered() throws Exception {
        assertEquals(Outcome.DELIVERED, deliver(police, "ROMA", "tell;help"));
        assertEquals("tell;help", bus.message().content().toString());
        assertEquals(Outcome.DELIVERED, deliver(bus, "SUPO", "tell;thanks"));
        assertEquals("tell;thanks", police.message().content().toString());
        assertTrue(bus.messages().isEmpty());
        assertTrue(police.messages().isEmpty());
        double sent = emulator.sentBy("police").get(0).fields().get("end").getAsDouble();
        System.out.printf(Locale.ROOT, "from the end of a packet to its relay's beginning: %.0f ms%n",
                1000 * (emulator.sentBy("east").get(0).seconds() - sent));
    }

    @Test
    void unicast_inPieces_isDelivered() throws Exception {
        String content = "tell;" + "x".repeat(300);
        assertEquals(Outcome.DELIVERED, deliver(police, "ROMA", content));
        assertEquals(content, bus.message().content().toString());
    }
}
