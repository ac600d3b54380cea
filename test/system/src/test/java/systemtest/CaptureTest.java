package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import capture.CaptureCommand;
import capture.Tshark;
import harness.Emulator;
import harness.Host;
import harness.TestKeys;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import javino.protocol.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import trace.TraceEvent;

/** {@code javino capture} at a board without address and keys, while two others talk. */
class CaptureTest {

    private static final String KEYRING = "ROMA SUPO = " + HexFormat.of().formatHex(TestKeys.PAIR) + "\n";

    @TempDir
    private Path folder;

    @Test
    void capture_ofABoard_hasAllThatWasOnTheAir() throws Exception {
        Path file = folder.resolve("capture.pcapng");
        try (Emulator emulator = new Emulator.Scenario().board("police", "Station").board("bus", "Station")
                .board("ear", "Station").speed("0.5").start(folder);
                Host police = Host.of(emulator, "police").as("SUPO", Map.of("ROMA", TestKeys.PAIR));
                Host bus = Host.of(emulator, "bus").as("ROMA", Map.of("SUPO", TestKeys.PAIR))) {
            CompletableFuture<Integer> status = new CompletableFuture<>();
            Thread capture = new Thread(() -> status.complete(new CommandLine(new CaptureCommand())
                    .execute("--port", emulator.port("ear"), "--write", file.toString())));
            capture.start();
            awaitPacket(bus, file);
            for (String content : List.of("tell;help", "tell;" + "x".repeat(150))) {
                assertEquals(Outcome.DELIVERED, police.send("ROMA", content));
            }
            bus.send("////", "tell;last");
            while (!contains(file, "tell;last")) {
                Thread.sleep(20);
            }
            capture.interrupt();
            assertEquals(0, status.get());
            emulator.await("the last packet",
                    event -> event.is("rf-rx", "ear") && event.textOrEmpty("content").equals("tell;last"));
            List<TraceEvent> heard =
                    emulator.trace().stream().filter(event -> event.is("rf-rx", "ear")).toList();
            compare(heard, Tshark.dissect(Files.readAllBytes(file), KEYRING));
        }
    }

    /** Broadcasts until one is captured: so the ear is open. */
    private static void awaitPacket(Host bus, Path file) throws Exception {
        while (!contains(file, "tell;first")) {
            bus.send("////", "tell;first");
            Thread.sleep(50);
        }
    }

    private static boolean contains(Path file, String text) throws IOException {
        return Files.exists(file) && Files.readString(file, StandardCharsets.ISO_8859_1).contains(text);
    }

    private static void compare(List<TraceEvent> heard, List<Tshark.Dissected> packets) {
        List<TraceEvent> captured = heard.subList(heard.size() - packets.size(), heard.size());
        assertEquals(captured.stream().map(event -> event.text("payload")).toList(),
                packets.stream().map(packet -> packet.hex("javino.payload").get(0)).toList());
        assertTrue(packets.stream().allMatch(packet -> packet.errors().isEmpty()), packets::toString);
        List<String> contents =
                packets.stream().flatMap(packet -> packet.shown("javino.content").stream()).distinct().toList();
        assertEquals(List.of("tell;first", "tell;help", "tell;" + "x".repeat(150), "tell;last"), contents);
        assertTrue(packets.stream().filter(packet -> !packet.shown("javino.acknowledged_in").isEmpty()).count() >= 2);
        List<Double> times = packets.stream()
                .map(packet -> Double.parseDouble(packet.shown("frame.time_epoch").get(0))).toList();
        assertEquals(times.stream().sorted().toList(), times);
    }
}
