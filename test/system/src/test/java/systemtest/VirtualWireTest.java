package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.LineCode;
import harness.Transmitter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Random;
import javino.board.ReceivedMessage;
import javino.link.Link;
import javino.link.LinkException;
import javino.vectors.RadioVectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/** Packets that our boards send and hear, against the line code's definition. */
@InEmulatedTime
class VirtualWireTest {

    private static final double BIT_SECONDS = 1 / 2000.0;
    private static final byte TRAILER_PARITY = (byte) 0x87;

    @Test
    void broadcast_isVirtualWireOnAir(@TempDir Path folder) throws Exception {
        Map<String, Object> watched = Map.of("watch", List.of(Map.of("pin", 12, "name", "transmitter")));
        try (Emulator emulator = new Emulator.Scenario().board("bus", "Vehicle", watched).start(folder);
                Host bus = Host.of(emulator, "bus").as("ROMA", Map.of())) {
            bus.send("////", "tell;help");
            emulator.await("the end of the packet", event -> event.is("rf-tx", "bus"));

            List<TraceEvent> edges = emulator.trace().stream().filter(event -> event.is("pin", "bus")).toList();
            List<TraceEvent> fromFirstRise = edges.stream().dropWhile(edge -> edge.number("level") == 0).toList();
            assertEquals(LineCode.bits("////ROMABItell;help"), LineCode.bits(fromFirstRise, BIT_SECONDS));
        }
    }

    /** The receiver is one of VirtualWire's kind, written anew; it counts the packets of 77 bytes that it hears. */
    @Test
    @Tag("soak")
    void trailers_disturbNoVirtualWireReceiver(@TempDir Path folder) throws Exception {
        Random random = new Random(5);
        try (Emulator emulator = new Emulator.Scenario().board("other", "Transmitter").board("plain", "SampledModem")
                .start(folder);
                Transmitter other = Transmitter.of(emulator, "other");
                Link plain = Host.link(emulator.port("plain")).open()) {
            for (int i = 1; i <= 40; i++) {
                byte[] payload = new byte[77];
                random.nextBytes(payload);
                byte[] trailer = new byte[17];
                random.nextBytes(trailer);
                trailer[0] = TRAILER_PARITY;
                other.sendPacket(RadioVectors.packet(payload), trailer);
                assertEquals(i + "\r\n", line(plain));
            }
        }
    }

    private static String line(Link link) throws LinkException {
        StringBuilder line = new StringBuilder();
        byte[] some = new byte[16];
        while (line.indexOf("\n") < 0) {
            int count = link.read(some, Duration.ofSeconds(240));
            if (count == 0) {
                throw new AssertionError("the receiver is silent after \"" + line + "\"");
            }
            line.append(new String(some, 0, count, StandardCharsets.US_ASCII));
        }
        return line.toString();
    }

    @Test
    @Tag("verify")
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
