package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.GatewayProcess;
import harness.Host;
import harness.Mosquitto;
import harness.TestKeys;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import javino.protocol.Outcome;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/** Two cells out of each other's range, joined by gateways over a broker with TLS. */
abstract class JoinedCells {

    /** A cell without boards. */
    static final String FALSE = "false";
    /** A device that is nowhere. */
    static final String ABSENT = "ROMB";
    static final List<Double> WEST = List.of(0.0, 0.0);
    static final List<Double> EAST = List.of(100_000.0, 0.0);

    @AutoClose
    Mosquitto broker;
    @AutoClose
    Emulator emulator;
    @AutoClose
    Host police;
    @AutoClose
    Host bus;
    @AutoClose
    GatewayProcess west;
    @AutoClose
    GatewayProcess east;

    @BeforeEach
    void switchOn(@TempDir Path folder) throws Exception {
        broker = Mosquitto.start(folder.resolve("broker"), "west", "east", FALSE);
        emulator = new Emulator.Scenario()
                .board("police", "Station", Map.of("position", WEST)).board("west", "Station", Map.of("position", WEST))
                .board("bus", "Station", Map.of("position", EAST)).board("east", "Station", Map.of("position", EAST))
                .board("spare", "Station", Map.of("position", EAST))
                .start(folder);
        Map<String, byte[]> groups = Map.of("//RO", TestKeys.GROUP, "//SU", TestKeys.GROUP);
        police = Host.of(emulator, "police").as("SUPO", Map.of("ROMA", TestKeys.PAIR, ABSENT, TestKeys.PAIR))
                .as("SUPO", groups);
        bus = Host.of(emulator, "bus").as("ROMA", Map.of("SUPO", TestKeys.PAIR)).as("ROMA", groups);
        joinRegions(folder);
        west = join("west");
        east = join("east");
    }

    /** Starts other brokers than the one of both cells. */
    void joinRegions(Path folder) throws Exception {
        // One is enough.
    }

    /** The broker of a cell. */
    Mosquitto brokerOf(String cell) {
        return broker;
    }

    GatewayProcess join(String cell, String... options) throws Exception {
        return GatewayProcess.join(emulator, cell, cell, brokerOf(cell), brokerOf(cell).port(), options);
    }

    /** Messages there and back, of which each is delivered, once, and nothing else is. */
    void exchange(int from, int to) throws Exception {
        for (int i = from; i < to; i++) {
            assertEquals(Outcome.DELIVERED, police.send("ROMA", "tell;go(" + i + ")"));
            assertEquals("tell;go(" + i + ")", bus.content());
            assertEquals(Outcome.DELIVERED, bus.send("SUPO", "tell;done(" + i + ")"));
            assertEquals("tell;done(" + i + ")", police.content());
        }
        assertNothingElse();
    }

    void assertNothingElse() {
        assertEquals(List.of(), bus.messages());
        assertEquals(List.of(), police.messages());
    }

    /** How often each frame was sent in the other cell, and no more often than here. */
    void assertNothingTwice(String origin, String... relays) {
        Map<String, Long> sent = count(origin);
        Map<String, Long> relayed = count(relays);
        sent.forEach((frame, times) -> assertTrue(relayed.getOrDefault(frame, 0L) <= times, frame));
    }

    Map<String, Long> count(String... boards) {
        return List.of(boards).stream().flatMap(board -> emulator.sentBy(board).stream())
                .collect(Collectors.groupingBy(event -> event.text("payload"), Collectors.counting()));
    }

    /** Emulated seconds. */
    double now() {
        List<TraceEvent> trace = emulator.trace();
        return trace.get(trace.size() - 1).seconds();
    }
}
