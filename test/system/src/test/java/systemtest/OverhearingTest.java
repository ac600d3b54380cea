package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import javino.board.Board;
import javino.board.BoardListener;
import javino.protocol.Counter;
import javino.protocol.Frame;
import javino.protocol.Outcome;
import javino.protocol.PollReply;
import javino.protocol.ProtocolException;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/**
 * Two cells out of each other's range. In each is a board without address and keys, which overhears: what one hears the
 * other relays.
 */
@InEmulatedTime
class OverhearingTest {

    private static final List<Double> WEST = List.of(0.0, 0.0);
    private static final List<Double> EAST = List.of(100_000.0, 0.0);

    @AutoClose
    private Emulator emulator;
    private Host police;
    private Host bus;
    private Board west;
    private Board east;
    private final List<PollReply.Overheard> overheard = new CopyOnWriteArrayList<>();

    @BeforeEach
    void switchOn(@TempDir Path folder) throws Exception {
        emulator = new Emulator.Scenario()
                .board("police", "Station", Map.of("position", WEST)).board("west", "Station", Map.of("position", WEST))
                .board("bus", "Station", Map.of("position", EAST)).board("east", "Station", Map.of("position", EAST))
                .start(folder);
        police = Host.of(emulator, "police").as("SUPO", Map.of("ROMA", TestKeys.PAIR));
        bus = Host.of(emulator, "bus").as("ROMA", Map.of("SUPO", TestKeys.PAIR));
        west = ear("west", packet -> relay(packet, east));
        east = ear("east", packet -> relay(packet, west));
        Host.get(west.overhear(true));
        Host.get(east.overhear(true));
    }

    private Board ear(String name, Consumer<PollReply.Overheard> hearer) {
        return emulator.closing(Board.open(Host.link(emulator.port(name)), Host.config(),
                new BoardListener() {
                    @Override
                    public void overheard(PollReply.Overheard packet) {
                        overheard.add(packet);
                        hearer.accept(packet);
                    }
                }), Board::close);
    }

    private static void relay(PollReply.Overheard packet, Board into) {
        try {
            into.relay(Frame.decode(packet.payload()));
        } catch (ProtocolException damaged) {
            assertEquals(PollReply.Reception.DAMAGED, packet.how());
        }
    }

    @Test
    @Tag("verify")
    void unicast_betweenCells_isDeliveredThoughNobodyBetweenHasAKey() throws Exception {
        assertEquals(Outcome.DELIVERED, police.send("ROMA", "tell;help"));
        assertEquals("tell;help", bus.content());
        assertTrue(bus.messages().isEmpty());
        String plain = HexFormat.of().formatHex("help".getBytes(StandardCharsets.UTF_8));
        assertFalse(overheard.stream().anyMatch(packet -> packet.payload().hex().contains(plain)));
    }

    @Test
    void unicast_inFragments_isDelivered() throws Exception {
        String content = "tell;" + "x".repeat(150);
        assertEquals(Outcome.DELIVERED, police.send("ROMA", content));
        assertEquals(content, bus.content());
    }

    @Test
    void broadcast_isOverheardAsItIsOnTheAir() throws Exception {
        bus.send("////", "tell;roadClosed");
        assertEquals("tell;roadClosed", police.content());
        TraceEvent sent = emulator.await("the packet", event -> event.is("rf-tx", "bus"));
        assertEquals(sent.text("payload"), overheard.get(0).payload().hex());
        assertEquals(PollReply.Reception.INTACT, overheard.get(0).how());
        // The board's clock began when the board did: with the reset as its port was opened.
        double began = emulator.trace().stream().filter(event -> event.is("reset", "east"))
                .mapToDouble(TraceEvent::seconds).max().orElseThrow();
        assertEquals(1000 * (sent.real("end") - began), overheard.get(0).millis(), 100);
        assertEquals(0, Host.get(east.statistics()).getOrDefault(Counter.RADIO_OVERHEARD_DROPPED, 0L));
    }
}
