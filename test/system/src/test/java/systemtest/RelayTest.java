package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.stream.Stream;
import javino.board.Transmission;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Counter;
import javino.protocol.Outcome;
import javino.protocol.Payload;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/** A line of boards, each of which hears its neighbours only, and what relays between its ends make of messages. */
@InEmulatedTime
class RelayTest {

    private static final double STEP_METRES = 90;
    private static final Address TO = Address.parse("SUPO");

    @TempDir
    private Path folder;
    @AutoClose
    private Emulator emulator;
    private Host sender;
    private Host receiver;

    /** Boards on a line; those between the first and the last one are relays with a host, or run the sketch Relay. */
    private void line(int hops, String sketch, Map<String, Object> more) throws Exception {
        Emulator.Scenario scenario = new Emulator.Scenario();
        scenario.board("from", "Station", at(0));
        for (int hop = 1; hop < hops; hop++) {
            Map<String, Object> board = new HashMap<>(at(hop));
            board.putAll(more);
            scenario.board("relay" + hop, sketch, board);
        }
        emulator = scenario.board("to", "Station", at(hops)).start(folder);
        greet();
    }

    private static Map<String, Object> at(double steps) {
        return Map.of("position", List.of(STEP_METRES * steps, 0));
    }

    private void greet() {
        sender = Host.of(emulator, "from").as("ROMA", Map.of("SUPO", TestKeys.PAIR));
        receiver = Host.of(emulator, "to").as("SUPO", Map.of("ROMA", TestKeys.PAIR));
    }

    private Host relay(String board, boolean on) {
        Host host = Host.of(emulator, board);
        assertEquals(on, Host.get(host.board.relaying(on)));
        return host;
    }

    @Test
    void unicast_overTwoHops_isDelivered() throws Exception {
        line(2, "Station", Map.of());
        Host relay = relay("relay1", true);
        assertEquals(Outcome.DELIVERED, sender.send("SUPO", "tell;help"));
        assertEquals("tell;help", receiver.content());
        assertTrue(receiver.messages().isEmpty());
        assertEquals(1, relay.counter(Counter.RELAY_COPIES));
        assertEquals(1, relay.counter(Counter.RELAY_ANSWERS));
        emulator.await("a copy and an answer", 2, event -> event.is("rf-tx", "relay1"));
        assertEquals(List.of("SUPO 1", "acknowledgement 1"), emulator.sentBy("relay1").stream()
                .map(packet -> (packet.text("kind").equals("acknowledgement") ? "acknowledgement"
                        : packet.text("destination")) + " " + hops(packet))
                .sorted().toList());
    }

    private static String hops(TraceEvent packet) {
        return "" + packet.hops();
    }

    @Test
    void unicasts_overFourHops_areDeliveredAndTellTheirHops() throws Exception {
        line(4, "Station", Map.of());
        for (int hop = 1; hop < 4; hop++) {
            relay("relay" + hop, true);
        }
        for (int i = 0; i < 5; i++) {
            assertEquals(Outcome.DELIVERED, sender.send("SUPO", "tell;n(" + i + ")"));
            assertEquals("tell;n(" + i + ")", receiver.content());
        }
        assertTrue(receiver.messages().isEmpty());
        assertEquals("2", hops(emulator.sentBy("relay2").get(0)));
        assertEquals("3", hops(emulator.sentBy("relay3").get(0)));
        List<TraceEvent> copies = emulator.sentBy("relay1").stream()
                .filter(packet -> packet.text("destination").equals("SUPO")).toList();
        assertEquals(OptionalInt.empty(), copies.get(0).distance());
        assertTrue(copies.stream().anyMatch(copy -> copy.distance().equals(OptionalInt.of(3))));
    }

    /** A receiver that hears the relay only has it once, as does one that hears its sender, too. */
    @Test
    void whatIsForMany_overARelay_comesOnce() throws Exception {
        emulator = new Emulator.Scenario().board("from", "Station", at(0)).board("relay1", "Relay", at(1))
                .board("near", "Station", at(1)).board("to", "Station", at(2)).start(folder);
        greet();
        Map<String, byte[]> key = Map.of("//SU", TestKeys.GROUP);
        sender.as("ROMA", key);
        receiver.as("SUPO", key);
        Host near = Host.of(emulator, "near").as("SUHO", key);
        for (String message : List.of("//// a", "//SU b", "//// c")) {
            String content = "tell;n(" + message.substring(5) + ")";
            sender.send(message.substring(0, 4), content);
            assertEquals(content, receiver.content());
            assertEquals(content, near.content());
        }
        double now = emulator.await("a third copy", 3, event -> event.is("rf-tx", "relay1")).seconds();
        emulator.await("some time without another copy", event -> event.seconds() > now + 1.5);
        assertTrue(receiver.messages().isEmpty() && near.messages().isEmpty());
        assertEquals(List.of("1", "1", "1"), emulator.sentBy("relay1").stream().map(RelayTest::hops).toList());
    }

    @Test
    @Tag("verify")
    void unicast_byARelayOnAnUno_isDelivered() throws Exception {
        line(2, "Relay", Map.of("model", "uno"));
        assertEquals(Outcome.DELIVERED, sender.send("SUPO", "tell;help"));
        assertEquals("tell;help", receiver.content());
    }

    @Test
    void relay_switchedOff_carriesNothingAndRemembersIt() throws Exception {
        line(2, "Station", Map.of());
        Host relay = relay("relay1", true);
        assertTrue(Host.get(relay.board.isRelaying()));
        assertFalse(Host.get(relay.board.relaying(false)));
        emulator.command(Map.of("do", "reset", "board", "relay1"));
        relay.awaitOnline(2);
        assertFalse(Host.get(relay.board.isRelaying()));
        assertEquals(Outcome.UNDELIVERED, sender.send("SUPO", "tell;help"));
        assertEquals(0, emulator.sentBy("relay1").size());
    }

    @Test
    void relays_inEarshot_sendNoMoreThanOneWould() throws Exception {
        Emulator.Scenario scenario = new Emulator.Scenario().board("from", "Station", at(0))
                .board("one", "Station", at(1)).board("other", "Station", Map.of("position", List.of(STEP_METRES, 5)))
                .board("to", "Station", at(2));
        emulator = scenario.start(folder);
        greet();
        relay("one", true);
        relay("other", true);
        for (int i = 0; i < 5; i++) {
            assertEquals(Outcome.DELIVERED, sender.send("SUPO", "tell;n(" + i + ")"));
        }
        emulator.await("the last outcome", 5, event -> event.is("host-outcome", "from"));
        // Not all copies: a relay that does not hear an answer in time sends its copy again.
        // Now and then both take the same slot. If they always did, it would be 20.
        long carried = Stream.of("one", "other").mapToLong(
                relay -> emulator.sentBy(relay).stream().map(copy -> copy.text("payload")).distinct().count()).sum();
        assertTrue(carried >= 10 && carried <= 15, "5 messages and 5 acknowledgements: " + carried + " by some relay");
    }

    /** It answers in the receiver's name, and sends what it hears again, changed and with a path that is not so. */
    @Test
    void attacker_whoLies_hasNothingDeliveredTwiceOrWrongly() throws Exception {
        line(2, "Station", Map.of());
        relay("relay1", true);
        List<String> delivered = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            String content = "tell;n(" + i + ")";
            Transmission sent = sender.board.transmit(TO, Content.parse(content));
            int number = i;
            String packet = emulator
                    .await("message " + i, number + 1,
                            event -> event.is("rf-tx", "from") && !event.has("trailer"))
                    .text("payload");
            String answer = Address.acknowledgement(Payload.of(Bytes.ofHex(packet)).lastBits()).toBytes().hex()
                    + "5355504f42410102030405060708";
            lie(answer, 0, i);
            lie(packet, 1, i);
            lie(packet.substring(0, packet.length() - 2) + "00", 2, i);
            if (Host.get(sent.end()) == Outcome.DELIVERED) {
                delivered.add(content);
            }
        }
        List<String> received =
                receiver.messages().stream().map(message -> message.content().toString()).toList();
        assertEquals(received.stream().distinct().toList(), received);
        assertTrue(received.containsAll(delivered), received + " of " + delivered);
        assertTrue(received.stream().allMatch(content -> content.matches("tell;n\\([012]\\)")), received.toString());
    }

    /** Stands where all hear it. */
    private void lie(String payload, int hops, int place) {
        emulator.command(Map.of("do", "send", "position", List.of(STEP_METRES, 1 + place), "payload", payload, "hops",
                hops, "distance", place));
    }
}
