package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.BrokerClient;
import harness.Host;
import harness.Mosquitto;
import harness.TestKeys;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.Key;
import javino.protocol.Outcome;
import javino.protocol.ProtocolException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import trace.TraceEvent;

/** An intruder with a user at the broker, the broker itself, or a radio in a cell, and his limits (SECURITY.md). */
class FalseGatewayTest extends JoinedCells {

    private static final double BIT_RATE = 2000;
    private static final HexFormat HEX = HexFormat.of();
    private static final String AIR = "javino/+/+/from/+/air";
    private static final String WEST_CELL = "to/west";
    private static final String EAST_CELL = "to/east";

    private final Random random = new Random(18);
    private BrokerClient intruder;

    @BeforeEach
    void enter() throws Exception {
        intruder = BrokerClient.enter(broker, FALSE);
    }

    @AfterEach
    void leave() {
        intruder.close();
    }

    private static Frame frame(byte[] packet) {
        try {
            return Frame.decode(Bytes.copyOf(packet));
        } catch (ProtocolException none) {
            throw new AssertionError(none);
        }
    }

    /** An acknowledgement of a frame, with an invented proof. */
    private byte[] forgedAcknowledgement(Frame frame) {
        byte[] proof = new byte[8];
        random.nextBytes(proof);
        String kind = "+K" + new Address((int) frame.message().number(4, 6) & 0xFFF).toString().substring(2);
        return new Frame(Address.parse(kind), frame.destination(), Bytes.copyOf(proof)).encode().toArray();
    }

    /** A frame of which one bit behind the header is another one. */
    private byte[] changed(byte[] packet) {
        byte[] other = packet.clone();
        other[Frame.HEADER_LENGTH + random.nextInt(packet.length - Frame.HEADER_LENGTH)] ^=
                (byte) (1 << random.nextInt(8));
        return other;
    }

    /** Has somebody answer each unicast of a gateway that the broker lets him see. */
    private void onUnicast(BrokerClient who, Consumer<byte[]> answer) {
        who.watch(AIR, (topic, packet) -> {
            if (!topic.contains("from/" + FALSE) && frame(packet).destination().kind() == Address.Kind.DEVICE) {
                answer.accept(packet);
            }
        });
    }

    private List<String> relayedOfNobody() {
        Map<String, Long> genuine = count("police", "bus");
        return count("west", "east").keySet().stream().filter(payload -> !genuine.containsKey(payload)).toList();
    }

    @Test
    @Tag("verify")
    void falseGateway_thatForgesAndChanges_deliversNothing() throws Exception {
        exchange(0, 1);
        onUnicast(intruder, packet -> {
            for (String cell : List.of(WEST_CELL, EAST_CELL)) {
                intruder.air(cell, FALSE, "f1", forgedAcknowledgement(frame(packet)));
                intruder.air(cell, FALSE, "f1", changed(packet));
                intruder.air(cell, FALSE, "f1", packet);
            }
        });
        for (int i = 1; i < 4; i++) {
            claim();
            exchange(i, i + 1);
        }
        assertEquals(Outcome.UNDELIVERED, police.send(ABSENT, "tell;nobody"));
        assertTrue(relayedOfNobody().size() > 4, "its frames were on the air: " + relayedOfNobody());
        exchange(4, 5);
    }

    @Test
    @Tag("verify")
    void falseGateway_thatRepeatsWhatItHasRecorded_hasNothingDeliveredTwice() throws Exception {
        List<byte[]> recorded = new CopyOnWriteArrayList<>();
        try (BrokerClient owner = BrokerClient.enter(broker, Mosquitto.OWNER)) {
            owner.watch(AIR, (topic, packet) -> recorded.add(packet));
            exchange(0, 3);
        }
        String last = emulator.sentBy("police").get(emulator.sentBy("police").size() - 1).text("payload");
        long before = count("east").getOrDefault(last, 0L);
        double since = now();
        emulator.await("silence", event -> event.seconds() > since + 9);
        for (byte[] packet : List.copyOf(recorded)) {
            intruder.air(WEST_CELL, FALSE, "f1", packet);
            intruder.air(EAST_CELL, FALSE, "f1", packet);
        }
        emulator.await("its repeat", (int) before + 1, event -> event.is("rf-tx", "east")
                && event.text("payload").equals(last));
        exchange(3, 5);
    }

    @Test
    @Tag("soak")
    void falseGateway_thatClaimsADevice_holdsUpItsMessagesOnly() throws Exception {
        exchange(0, 1);
        claim();
        assertEquals(Outcome.DELIVERED, police.send("ROMA", "tell;go(1)"));
        assertEquals("tell;go(1)", bus.content());
        List<TraceEvent> sent = emulator.sentBy("police");
        assertTrue(count("police").get(sent.get(sent.size() - 1).text("payload")) >= 2, "it was drawn away");
        exchange(2, 4);
    }

    /** Says that both devices are in the cell without boards: by frames in their names, and to all who ask. */
    private void claim() throws InterruptedException {
        List<String> arrived = new CopyOnWriteArrayList<>();
        intruder.watch("javino/to/false/from/false/air", (topic, packet) -> arrived.add(topic));
        intruder.watch("javino/seek/+/from/+", (topic, nothing) -> {
            String[] levels = topic.split("/");
            intruder.say("javino/to/" + levels[4] + "/from/false/heard/" + levels[2], "0");
        });
        for (String[] claimed : new String[][] {{WEST_CELL, "SUPO", "ROMA"}, {EAST_CELL, "ROMA", "SUPO"}}) {
            byte[] message = new byte[20];
            random.nextBytes(message);
            intruder.air(claimed[0], FALSE, "f1", new Frame(Address.parse(claimed[1]), Address.parse(claimed[2]),
                    Bytes.copyOf(message)).encode().toArray());
        }
        // The broker has passed on the one after them, so the gateways have these, too, or soon.
        intruder.air("to/false", FALSE, "f1", new byte[1]);
        while (arrived.isEmpty()) {
            Thread.sleep(10);
        }
    }

    @Test
    @Tag("verify")
    void falseGateway_readsAndWritesForItsOwnCellOnly() throws Exception {
        Set<String> read = new ConcurrentSkipListSet<>();
        Set<String> written = new ConcurrentSkipListSet<>();
        intruder.watch("#", (topic, payload) -> read.add(topic));
        try (BrokerClient owner = BrokerClient.enter(broker, Mosquitto.OWNER)) {
            owner.watch("#", (topic, payload) -> written.add(topic));
            exchange(0, 2);
            police.send("//RO", "tell;toTheGroup");
            assertEquals("tell;toTheGroup", bus.content());
            Set<String> others = Set.copyOf(written);
            assertTrue(others.containsAll(Set.of("javino/to/east/from/west/air", "javino/to/west/from/east/air",
                    "javino/seek/ROMA/from/west", "javino/search/all/from/west/air")), "" + others);
            for (String topic : List.of("javino/to/west/from/east/air", "javino/to/west/from/east/heard/ROMA",
                    "javino/search/all/from/east/air", "javino/seek/ROMA/from/west", "javino/group/RO/from/west/air",
                    "javino/gateway/0/from/east", "javino/to/west/air", "garden/light")) {
                intruder.say(topic + "/x", "");
                intruder.say(topic.replace("west/air", "west/from/" + FALSE + "x/air"), "");
            }
            intruder.say("javino/to/west/from/false/air", "");
            while (!written.contains("javino/to/west/from/false/air")) {
                Thread.sleep(10);
            }
            assertEquals(Set.of("javino/to/west/from/false/air"), written.stream()
                    .filter(topic -> topic.contains(FALSE) || topic.endsWith("/x")).collect(Collectors.toSet()));
        }
        assertTrue(read.stream().allMatch(topic -> topic.matches("javino/(to/false|group|search|seek|broadcast)/.*")),
                "" + read);
        assertTrue(read.contains("javino/group/RO/from/west/air"));
    }

    @Test
    @Tag("soak")
    void falseGateway_thatFloods_getsAQuarterOfTheAirAndNoMore() throws Exception {
        try (Host near = Host.of(emulator, "spare").as("NEAR", Map.of("ROMA", TestKeys.PAIR))) {
            Host.get(bus.board.setKey(Address.parse("NEAR"), Key.of(Bytes.copyOf(TestKeys.PAIR))));
            exchange(0, 1);
            double since = now();
            while (now() < since + 40) {
                byte[] message = new byte[67];
                random.nextBytes(message);
                Frame forged = new Frame(Address.parse("ROMA"), Address.parse("SUPO"), Bytes.copyOf(message));
                intruder.air(EAST_CELL, FALSE, "f1", forged.encode().toArray());
                Thread.sleep(10);
            }
            double until = now();
            assertEquals(Outcome.DELIVERED, bus.send("NEAR", "tell;here"));
            assertEquals("tell;here", near.content());
            double seconds = emulator.sentBy("east").stream().filter(sent -> sent.seconds() > since
                    && sent.seconds() < until).mapToDouble(sent -> sent.number("bits") / BIT_RATE).sum();
            assertTrue(seconds > 10 && seconds < 10 + (until - since) / 4 + 1, seconds + " of " + (until - since));
            exchange(1, 2);
        }
    }

    @Test
    @Tag("soak")
    void falseGateway_thatTakesAllIdsThatItCanRead_stopsNobody() throws Exception {
        Set<String> read = intruder.read();
        exchange(0, 2);
        List<String> of = List.of(broker.ids("west").get(0), broker.ids("east").get(0));
        assertTrue(read.stream().noneMatch(word -> of.stream().anyMatch(id -> id.contains(word) && word.length() > 3)));
        for (String word : List.copyOf(read)) {
            for (String id : List.of(word, "javino-west-" + word, "javino-east-" + word)) {
                if (id.matches("[\\w-]{1,64}")) {
                    BrokerClient.enter(broker, FALSE, id).close();
                }
            }
        }
        exchange(2, 4);
        assertEquals(List.of(1, 1), List.of(broker.ids("west").size(), broker.ids("east").size()), "none came again");
    }

    /** The broker's owner alone sees the ids of clients. */
    @Test
    @Tag("soak")
    void owner_ofTheBrokerWhoTakesAGatewaysPlace_doesNotStopIt() throws Exception {
        exchange(0, 1);
        int takeovers = 12;
        for (int i = 1; i <= takeovers; i++) {
            List<String> before = broker.ids("east");
            BrokerClient.enter(broker, Mosquitto.OWNER, before.get(before.size() - 1)).close();
            while (broker.ids("east").size() == before.size()) {
                Thread.sleep(10);
            }
        }
        exchange(1, 3);
        assertEquals(takeovers + 1, Set.copyOf(broker.ids("east")).size(), "a new id each time");
        assertTrue(east.said(line -> line.contains("broker: ") && !line.contains("connected to")) <= takeovers,
                "each is said once at most");
    }

    @Test
    @Tag("soak")
    void owner_ofTheBroker_readsNothing() throws Exception {
        List<String> seen = new CopyOnWriteArrayList<>();
        try (BrokerClient owner = BrokerClient.enter(broker, Mosquitto.OWNER)) {
            owner.watch("#", (topic, payload) -> seen.add(topic + " " + HEX.formatHex(payload)));
            exchange(0, 2);
            police.send("//RO", "tell;toTheGroup");
            assertEquals("tell;toTheGroup", bus.content());
        }
        assertTrue(seen.contains("javino/to/west/from/west/air " + emulator.sentBy("police").get(0).text("payload")),
                "" + seen);
        assertTrue(seen.stream().anyMatch(line -> line.startsWith("javino/to/east/from/east/heard/ROMA ")),
                "who is where he sees");
        for (byte[] secret : List.of(bytes("go("), bytes("done("), bytes("toTheGroup"), TestKeys.PAIR,
                TestKeys.GROUP)) {
            assertTrue(seen.stream().noneMatch(line -> line.contains(HEX.formatHex(secret))), "" + seen);
        }
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    @Test
    @Tag("soak")
    void owner_ofTheBroker_canStopAGatewayAndDeliversNothing() throws Exception {
        exchange(0, 1);
        try (BrokerClient owner = BrokerClient.enter(broker, Mosquitto.OWNER)) {
            onUnicast(owner, packet -> {
                owner.air(WEST_CELL, "east", "f1", forgedAcknowledgement(frame(packet)));
                owner.air(EAST_CELL, "west", "f1", changed(packet));
            });
            owner.keep("javino/gateway/0/from/east", "first by name");
            assertEquals(Outcome.UNDELIVERED, police.send("ROMA", "tell;stopped"));
            owner.keep("javino/gateway/0/from/east", "");
        }
        exchange(1, 3);
    }

    @Test
    @Tag("soak")
    void injector_onTheAirWhoPlaysGateway_deliversNothingAndNothingTwice() throws Exception {
        exchange(0, 2);
        List<TraceEvent> recorded = emulator.sentBy("police");
        int said = 0;
        for (TraceEvent sent : recorded) {
            inject(EAST, sent.bytes("payload"));
            inject(WEST, changed(sent.bytes("payload")));
            said += 2;
            // Only so many may wait to be sent, and on a busy machine the boards' time goes by slowly.
            emulator.await("what the injector says", said, event -> event.is("rf-tx", "injector"));
        }
        exchange(2, 3);
        onUnicast(intruder, packet -> inject(WEST, forgedAcknowledgement(frame(packet))));
        assertEquals(Outcome.UNDELIVERED, police.send(ABSENT, "tell;nobody"));
        exchange(3, 4);
    }

    private void inject(List<Double> where, byte[] packet) {
        emulator.command(Map.of("do", "send", "position", where, "payload", HEX.formatHex(packet)));
    }
}
