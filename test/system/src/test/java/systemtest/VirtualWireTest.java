package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import harness.Emulator;
import harness.Host;
import harness.LineCode;
import harness.TraceEvent;
import harness.Transmitter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javino.board.ReceivedMessage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What our boards send and hear, against the line code's definition. */
class VirtualWireTest {

    private static final double BIT_SECONDS = 1 / 2000.0;

    @Test
    void broadcast_isVirtualWireOnAir(@TempDir Path folder) throws Exception {
        Map<String, Object> watched = Map.of("watch", List.of(Map.of("pin", 12, "name", "transmitter")));
        try (Emulator emulator = new Emulator.Scenario().board("bus", "Vehicle", watched).start(folder);
                Host bus = Host.of(emulator, "bus").as("ROMA", Map.of())) {
            bus.send("////", "tell;help");

            List<TraceEvent> edges = emulator.trace().stream().filter(event -> event.is("pin", "bus")).toList();
            List<TraceEvent> fromFirstRise = edges.stream().dropWhile(edge -> edge.number("level") == 0).toList();
            assertEquals(LineCode.bits("////ROMABItell;help"), LineCode.bits(fromFirstRise, BIT_SECONDS));
        }
    }

    @Test
    void handMadePacket_isHeard(@TempDir Path folder) throws Exception {
        try (Emulator emulator =
                new Emulator.Scenario().board("other", "Transmitter").board("police", "Station").start(folder);
                Transmitter other = Transmitter.of(emulator, "other");
                Host police = Host.of(emulator, "police").as("SUPO", Map.of())) {
            other.send("////ROMABItell;help".getBytes(StandardCharsets.US_ASCII));

            ReceivedMessage message = police.message();
            assertEquals("ROMA", message.from().toString());
            assertEquals("tell;help", message.content().toString());
        }
    }
}
