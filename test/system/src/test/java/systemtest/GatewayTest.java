package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.BrokerClient;
import harness.GatewayProcess;
import harness.SlowNetwork;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import javino.cli.JavinoCommand;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.Outcome;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Gateways relay messages, also where broker, gateway, board or network fail. */
class GatewayTest extends JoinedCells {

    private static final double MINUTE = 60;
    private static final int MANY = 40_000;
    private static final int MEGABYTE = 1_000_000;

    @Test
    void unicasts_thereAndBack_areDeliveredOnce() throws Exception {
        exchange(0, 4);
        assertNothingTwice("police", "east");
        assertNothingTwice("bus", "west");
    }

    @Test
    @Tag("verify")
    void unicast_inFragments_isDelivered() throws Exception {
        String content = "tell;" + "x".repeat(300);
        assertEquals(Outcome.DELIVERED, police.send("ROMA", content));
        assertEquals(content, bus.content());
    }

    @Test
    @Tag("verify")
    void multicast_goesWhereAMemberWasHeard_broadcastDoesNot() throws Exception {
        bus.send("////", "tell;here");
        exchange(0, 1);
        police.send("////", "tell;toAll");
        police.send("//RO", "tell;toTheGroup");
        assertEquals("tell;toTheGroup", bus.content());
        exchange(1, 2);
        assertEquals(0, count("west").getOrDefault(emulator.sentBy("bus").get(0).text("payload"), 0L));
        assertTrue(west.end().get("heard") > 0);
    }

    @Test
    @Tag("verify")
    void broadcast_ifTheUserWantsIt_isRelayedOnce() throws Exception {
        east.end();
        east = join("east", "--broadcasts");
        police.send("////", "tell;toAll");
        assertEquals("tell;toAll", bus.content());
        exchange(0, 1);
        assertEquals(1, count("east").get(emulator.sentBy("police").get(0).text("payload")));
    }

    @Test
    @Tag("soak")
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
    @Tag("soak")
    void gateway_thatWasKilled_isStillSentWhatIsForItsCellAndGroups() throws Exception {
        bus.send("////", "tell;here");
        exchange(0, 1);
        east.kill();
        east = join("east", "--group", "RO");
        police.send("//RO", "tell;toTheGroup");
        assertEquals("tell;toTheGroup", bus.content());
        exchange(1, 2);
    }

    @Test
    @Tag("verify")
    void gateway_thatCannotWork_saysWhyInOneLine(@TempDir Path folder) throws Exception {
        Path wrong = Files.writeString(folder.resolve("wrong"), "apart\n");
        String port = emulator.port("spare");
        String url = "mqtts://localhost:" + broker.port();
        String ca = broker.ca().toString();
        assertEnds("the broker refuses this user or password", "--port", port, "--broker", url, "--ca", ca, "--user",
                "west", "--password-file", wrong.toString());
        assertEnds("name its CA by --ca FILE", "--port", port, "--broker", url, "--user", "west");
        assertEnds("nobody answers there", "--port", port, "--broker", "mqtts://localhost:1", "--ca", ca);
        assertEnds("there is no such port", "--port", port + "x", "--broker", url, "--ca", ca);
    }

    private static void assertEnds(String why, String... options) throws Exception {
        String[] words = Stream.concat(Stream.of("gateway", "--cell", "x"), Stream.of(options)).toArray(String[]::new);
        List<String> said =
                JavinoCommand.run(words).stream().filter(line -> !line.startsWith("gateway: board: online")).toList();
        assertEquals(2, said.size(), said.toString());
        assertTrue(said.get(0).startsWith("javino: ") && said.get(0).contains(why), said.toString());
        assertEquals("1", said.get(1));
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    @Tag("soak")
    void broker_thatIsAwayForAMinute_joinsTheCellsAgain(boolean persistent) throws Exception {
        exchange(0, 2);
        broker.stop();
        double since = now();
        while (now() < since + MINUTE) {
            assertEquals(Outcome.UNDELIVERED, police.send("ROMA", "tell;lost"));
        }
        if (!persistent) {
            broker.forget();
        }
        broker.start();
        for (GatewayProcess gateway : List.of(west, east)) {
            gateway.await(2, line -> line.contains("connected to"));
        }
        exchange(2, 4);
        west.kill();
        west = join("west", "--group", "SU");
        bus.send("//SU", "tell;toTheGroup");
        assertEquals("tell;toTheGroup", police.content());
        assertNothingTwice("police", "east");
        assertNothingTwice("bus", "west");
    }

    @Test
    @Tag("soak")
    void gateways_thatAreKilledAndComeAgain_joinTheCellsAgain() throws Exception {
        exchange(0, 2);
        west.kill();
        assertEquals(Outcome.UNDELIVERED, police.send("ROMA", "tell;lost"));
        west = join("west");
        exchange(2, 4);
        emulator.command(Map.of("do", "reset", "board", "east"));
        exchange(4, 6);
        assertNothingTwice("police", "east");
        assertNothingTwice("bus", "west");
    }

    @Test
    @Tag("soak")
    void gateways_thatAreFlooded_haveEnoughMemory() throws Exception {
        exchange(0, 1);
        long before = east.residentBytes();
        Random random = new Random(18);
        try (BrokerClient flood = BrokerClient.enter(broker, FALSE)) {
            for (int i = 0; i < MANY; i++) {
                String origin = "Z" + Integer.toString(0x10000 + i, Character.MAX_RADIX).substring(1);
                flood.say("javino/to/west/from/false/heard/" + origin, "0");
                flood.say("javino/seek/" + origin + "/from/false", "");
                byte[] message = new byte[60];
                random.nextBytes(message);
                flood.air("to/west", FALSE, "f" + i,
                        new Frame(Address.parse("SUPO"), Address.parse(origin), Bytes.copyOf(message)).encode()
                                .toArray());
            }
            for (int i = 0; i < 10; i++) {
                flood.air("to/west", FALSE, "f", new byte[10 * MEGABYTE]);
            }
        }
        System.out.printf(Locale.ROOT,
                "a gateway in 16 MB of heap takes %d MB, and after %d topics and %d frames %d MB%n",
                before / MEGABYTE, MANY, MANY, east.residentBytes() / MEGABYTE);
        assertEquals(1, east.said(line -> line.contains("connected to")), "it has never lost its broker");
        west.kill();
        west = join("west");
        // Wait until the gateways may use the air again.
        double since = now();
        emulator.await("silence", event -> event.seconds() > since + MINUTE / 2);
        exchange(1, 3);
    }

    @Test
    @Tag("soak")
    void slowNetwork_delaysAndDoublesNothing() throws Exception {
        west.end();
        try (SlowNetwork network = SlowNetwork.open(broker.port(), 1000, 0.2, 18)) {
            west = GatewayProcess.join(emulator, "west", "west", broker, network.port());
            int delivered = 0;
            for (int i = 0; i < 20; i++) {
                String content = "tell;go(" + i + ")";
                if (police.send("ROMA", content) == Outcome.DELIVERED) {
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
