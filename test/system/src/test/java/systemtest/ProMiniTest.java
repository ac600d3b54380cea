package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.LineCode;
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
import trace.TraceEvent;

/** A Pro Mini, at half the clock of the Mega beside it. */
@InEmulatedTime
class ProMiniTest {

    private static final double BIT_SECONDS = 1 / 2000.0;

    @AutoClose
    private Emulator emulator;
    private Host mini;
    private Host mega;

    @BeforeEach
    void switchOn(@TempDir Path folder) throws Exception {
        emulator = new Emulator.Scenario()
                .board("mini", "Station",
                        Map.of("model", "promini", "watch", List.of(Map.of("pin", 12, "name", "transmitter"))))
                .board("mega", "Station")
                .start(folder);
        mini = Host.of(emulator, "mini").as("LAMP", Map.of("ROMA", TestKeys.PAIR));
        mega = Host.of(emulator, "mega").as("ROMA", Map.of("LAMP", TestKeys.PAIR));
    }

    @Test
    void broadcast_hasBitsOfTheSameLengthAsAllBoards() throws Exception {
        mini.send("////", "tell;help");
        emulator.await("the end of the packet", event -> event.is("rf-tx", "mini"));

        List<TraceEvent> edges = emulator.trace().stream().filter(event -> event.is("pin", "mini"))
                .dropWhile(edge -> edge.number("level") == 0).toList();
        assertEquals(LineCode.bits("////LAMPBItell;help"), LineCode.bits(edges, BIT_SECONDS));
        double seconds = edges.get(edges.size() - 1).seconds() - edges.get(0).seconds();
        // The interrupt of millis() may make an edge some 15 µs late.
        assertEquals(0, Math.IEEEremainder(seconds, BIT_SECONDS), BIT_SECONDS / 20);
    }

    @Test
    @Tag("verify")
    void unicast_isDeliveredBothWays() throws Exception {
        mini.send("ROMA", "tell;bright");
        assertEquals("LAMP to ROMA: tell;bright", mega.received());
        mega.send("LAMP", "achieve;light(off)");
        assertEquals("ROMA to LAMP: achieve;light(off)", mini.received());
        assertEquals(1, mini.counter(Counter.RADIO_ACKNOWLEDGED));
        assertEquals(1, mega.counter(Counter.RADIO_ACKNOWLEDGED));
    }
}
