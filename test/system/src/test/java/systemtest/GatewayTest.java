package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.GatewayProcess;
import harness.Host;
import harness.Mosquitto;
import harness.SlowNetwork;
import harness.TestKeys;
import harness.TraceEvent;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Outcome;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
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

    private void exchange(int from, int to) throws Exception {
        for (int i = from; i < to; i++) {
            assertEquals(Outcome.DELIVERED, deliver(police, "ROMA", "tell;go(" + i + ")"));
            assertEquals("tell;go(" + i + ")", bus.message().content().toString());
            assertEquals(Outcome.DELIVERED, deliver(bus, "SUPO", "tell;done(" + i + ")"));
            assertEquals("tell;done(" + i + ")", police.message().content().toString());
        }
        assertTrue(bus.messages().isEmpty());
        assertTrue(police.messages().isEmpty());
    }

    /** How often each frame was sent in the other cell, and no more often than here. */
    private void assertNothingTwice(String origin, String... relays) {
        Map<String, Long> sent = count(origin);
        Map<String, Long> relayed = count(relays);
        sent.forEach((frame, times) -> assertTrue(relayed.getOrDefault(frame, 0L) <= times, frame));
    }

    private Map<String, Long> count(String... boards) {
        return List.of(boards).stream().flatMap(board -> emulator.sentBy(board).stream())
                .collect(Collectors.groupingBy(event -> event.text("payload"), Collectors.counting()));
    }

    @Test
    void unicasts_thereAndBack_areDeliveredOnce() throws Exception {
        exchange(0, 4);
        assertNothingTwice("police", "east");
        assertNothingTwice("bus", "west");
        List<Double> waits = emulator.trace().stream().filter(event -> event.is("host-relay", "east"))
                .map(this::sinceHeard).sorted().toList();
        System.out.printf(Locale.ROOT, "from the end of a packet until the other cell's board has it: "
                + "%.0f ms, median of %d; the broker on this computer included%n",
                1000 * waits.get(waits.size() / 2), waits.size());
    }

    private double sinceHeard(TraceEvent relay) {
        return emulator.sentBy("police").stream()
                .mapToDouble(sent -> relay.seconds() - sent.fields().get("end").getAsDouble()).filter(wait -> wait > 0)
                .min().orElse(-1);
    }

    @Test
    void unicast_inPieces_isDelivered() throws Exception {
        String content = "tell;" + "x".repeat(300);
        assertEquals(Outcome.DELIVERED, deliver(police, "ROMA", content));
        assertEquals(content, bus.message().content().toString());
    }

    @Test
    void multicast_goesWhereAMemberWasHeard_broadcastDoesNot() throws Exception {
        bus.send("////", "tell;here");
        exchange(0, 1);
        police.send("////", "tell;toAll");
        police.send("//RO", "tell;toTheGroup");
        assertEquals("tell;toTheGroup", bus.message().content().toString());
        exchange(1, 2);
        assertEquals(0, count("west").getOrDefault(emulator.sentBy("bus").get(0).text("payload"), 0L));
        assertTrue(west.end("heard") > 0);
    }

    @Test
    void broadcast_ifTheUserWantsIt_isRelayedOnce() throws Exception {
        east.end("heard");
        east = GatewayProcess.join(emulator, "east", "east", broker, broker.port(), "--broadcasts");
        police.send("////", "tell;toAll");
        assertEquals("tell;toAll", bus.message().content().toString());
        exchange(0, 1);
        assertEquals(1, count("east").get(emulator.sentBy("police").get(0).text("payload")));
    }

    @Test
    void secondGateway_ofACell_takesOverWhenTheFirstIsKilled() throws Exception {
        try (GatewayProcess spare = GatewayProcess.join(emulator, "spare", "east", broker, broker.port())) {
            exchange(0, 3);
            assertNothingTwice("police", "east", "spare");
            assertNothingTwice("bus", "west");
            (emulator.sentBy("spare").isEmpty() ? east : spare).kill();
            exchange(3, 6);
            assertNothingTwice("police", "east", "spare");
            assertNothingTwice("bus", "west");
        }
    }

    @Test
    void gateway_thatWasKilled_knowsFromTheBrokerWhoWasHeardWhere() throws Exception {
        bus.send("////", "tell;here");
        exchange(0, 1);
        east.kill();
        east = GatewayProcess.join(emulator, "east", "east", broker, broker.port());
        police.send("//RO", "tell;toTheGroup");
        assertEquals("tell;toTheGroup", bus.message().content().toString());
    }

    @Test
    void broker_getsNothingThatItCouldRead() throws Exception {
        Process watch = new ProcessBuilder(Stream.concat(broker.client("mosquitto_sub").stream(),
                Stream.of("-t", "javino/+/air", "-F", "%t %x", "-W", "60", "-C", "2")).toList()).start();
        exchange(0, 1);
        List<String> seen = watch.inputReader().lines().toList();
        assertEquals("javino/west/air " + emulator.sentBy("police").get(0).text("payload"), seen.get(0));
        assertFalse(seen.get(0).contains(HexFormat.of().formatHex("go(0)".getBytes(StandardCharsets.UTF_8))));
    }

    @Test
    void gateway_thatCannotWork_saysWhyInOneLine(@TempDir Path folder) throws Exception {
        Path wrong = Files.writeString(folder.resolve("wrong"), "apart\n");
        String port = emulator.port("spare");
        String url = "mqtts://localhost:" + broker.port();
        String ca = broker.ca().toString();
        assertEnds("the broker refuses this user or password", "--port", port, "--broker", url, "--ca", ca, "--user",
                Mosquitto.USER, "--password-file", wrong.toString());
        assertEnds("name its CA by --ca FILE", "--port", port, "--broker", url, "--user", Mosquitto.USER);
        assertEnds("nobody answers there", "--port", port, "--broker", "mqtts://localhost:1", "--ca", ca);
        assertEnds("there is no such port", "--port", port + "x", "--broker", url, "--ca", ca);
    }

    private static void assertEnds(String why, String... options) throws Exception {
        List<String> said = GatewayProcess.start(Stream.concat(Stream.of("--cell", "x"), Stream.of(options)).toList())
                .ended().stream().filter(line -> !line.startsWith("gateway: board: online")).toList();
        assertEquals(2, said.size(), said.toString());
        assertTrue(said.get(0).startsWith("javino: ") && said.get(0).contains(why), said.toString());
        assertEquals("1", said.get(1));
    }

    @Test
    @Tag("verify")
    void brokerAndGateways_thatGoAndComeAgain_joinTheCellsAgain() throws Exception {
        exchange(0, 2);
        broker.stop();
        assertEquals(Outcome.UNDELIVERED, deliver(police, "ROMA", "tell;lost(1)"));
        broker.start();
        for (GatewayProcess gateway : List.of(west, east)) {
            gateway.await(2, line -> line.contains("connected to"));
        }
        exchange(2, 4);
        west.kill();
        assertEquals(Outcome.UNDELIVERED, deliver(police, "ROMA", "tell;lost(2)"));
        west = GatewayProcess.join(emulator, "west", "west", broker, broker.port());
        exchange(4, 6);
        emulator.command(Map.of("do", "reset", "board", "east"));
        exchange(6, 8);
        assertNothingTwice("police", "east");
        assertNothingTwice("bus", "west");
    }

    @Test
    @Tag("verify")
    void slowNetwork_delaysAndDoublesNothing() throws Exception {
        west.end("heard");
        try (SlowNetwork network = SlowNetwork.open(broker.port(), 1000, 0.2, 18)) {
            west = GatewayProcess.join(emulator, "west", "west", broker, network.port());
            int delivered = 0;
            for (int i = 0; i < 20; i++) {
                String content = "tell;go(" + i + ")";
                if (deliver(police, "ROMA", content) == Outcome.DELIVERED) {
                    delivered++;
                    assertTrue(
                            bus.messages().stream().anyMatch(message -> message.content().toString().equals(content)));
                }
                if (i % 5 == 4) {
                    network.cut();
                    west.await(1 + (i + 1) / 5, line -> line.contains("connected to"));
                }
            }
            List<String> taken = bus.messages().stream().map(message -> message.content().toString()).toList();
            assertEquals(taken.stream().distinct().toList(), taken);
            assertNothingTwice("police", "east");
            assertNothingTwice("bus", "west");
            System.out.println("with 1 s each way and a fifth lost: " + delivered + " of 20 delivered");
            assertTrue(delivered > 0);
        }
    }
}
