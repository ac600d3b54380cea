package gateway;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import javino.Counts;
import javino.protocol.Address;
import javino.protocol.Frame;
import javino.protocol.ProtocolException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The small parts of a gateway. */
class PartsTest {

    private static final long HOUR = 3_600_000;

    private final Counts<GatewayCounter> counters = new Counts<>();

    private static Frame frame(int nonce) throws ProtocolException {
        return Frame.decode(Frames.sealed("SUPO", "ROMA", nonce));
    }

    private static Frame answer(int nonce) throws ProtocolException {
        return Frame.decode(Frames.acknowledgement("SUPO", nonce));
    }

    @Test
    void outgoing_givesOneAtATimeAcknowledgementsFirst() throws Exception {
        OutgoingQueue outgoing = new OutgoingQueue(counters);
        outgoing.add(frame(1), 1, 100);
        outgoing.add(frame(2), 1, 100);
        outgoing.add(answer(3), 1, 100);
        assertEquals(Optional.of(answer(3)), outgoing.next(0));
        assertEquals(Optional.empty(), outgoing.next(0));
        outgoing.ended(true);
        assertEquals(Optional.of(frame(1)), outgoing.next(0));
        outgoing.ended(false);
        assertEquals(1, counters.of(GatewayCounter.RELAYED));
        assertEquals(1, counters.of(GatewayCounter.FAILED));
    }

    @Test
    void outgoing_dropsWhatIsLateTooMuchOrThereAlready() throws Exception {
        OutgoingQueue outgoing = new OutgoingQueue(counters);
        for (int i = 0; i < 20; i++) {
            outgoing.add(frame(i), 1, 100);
        }
        assertEquals(4, counters.of(GatewayCounter.OVERFLOWED));
        outgoing.add(frame(3), 1, 100);
        assertEquals(1, counters.of(GatewayCounter.DUPLICATES));
        assertTrue(outgoing.next(100).isPresent());
        outgoing.add(frame(0), 1, 500);
        assertEquals(2, counters.of(GatewayCounter.DUPLICATES), "it is under way");
        outgoing.ended(true);
        outgoing.add(frame(1), 1, 200);
        assertEquals(Optional.of(frame(1)), outgoing.next(101), "one of the two may wait for longer");
        assertEquals(Optional.empty(), outgoing.ended(false), "it was not on the air");
        assertEquals(Optional.empty(), outgoing.next(101));
        assertEquals(14, counters.of(GatewayCounter.EXPIRED));
    }

    @Test
    void colleagues_theFirstByNameThatIsThereRelays() {
        CellGateways cellGateways = new CellGateways("m");
        assertFalse(cellGateways.isOwnTurn(0), "the broker has not told yet who is there");
        assertFalse(cellGateways.said("m", true, 0));
        assertTrue(cellGateways.isOwnTurn(0));
        assertTrue(cellGateways.said("z", true, 0));
        assertFalse(cellGateways.said("z", true, 0));
        assertTrue(cellGateways.isOwnTurn(0));
        cellGateways.said("a", true, 0);
        assertFalse(cellGateways.isOwnTurn(0));
        cellGateways.said("a", false, 0);
        assertTrue(cellGateways.isOwnTurn(0));
        cellGateways.said("a", true, 0);
        assertTrue(cellGateways.isOwnTurn(CellGateways.GONE_MILLIS), "it has said nothing for too long");
        cellGateways.clear();
        assertFalse(cellGateways.isOwnTurn(0));
    }

    @Test
    void ages_areThoseBeyondTheFastestMessage_whateverTheClocksSay() {
        MessageAges ages = new MessageAges();
        long wrong = 7_000_000;
        assertEquals(0, ages.of("east", "e", wrong, 1000));
        assertEquals(900, ages.of("east", "e", wrong + 100, 2000), 1);
        assertEquals(0, ages.of("east", "e", wrong + 3000, 3500));
        assertEquals(0, ages.of("east", "e", wrong - 3_600_000, 4000), "its clock was set");
        long now = 0;
        for (int i = 0; i < 200_000; i++) {
            now += 500;
            assertTrue(ages.of("east", "slow", now - now / 10_000, now) < 5, "its clock is slow");
        }
    }

    @Test
    void ages_ofACell_areNotDisplacedByInventedGatewaysOfAnother() {
        MessageAges ages = new MessageAges();
        assertEquals(0, ages.of("east", "e", 1000, 1000));
        for (int i = 0; i < 5000; i++) {
            ages.of("false", "invented" + i, 1000, 1000);
        }
        assertEquals(900, ages.of("east", "e", 1100, 2000), 1);
    }

    @Test
    void boundedMap_forgetsWhatWasRenewedTheLongestTimeAgo() {
        BoundedMap<String, Integer> map = new BoundedMap<>(2);
        map.renew("a", 1);
        map.renew("b", 2);
        map.renew("a", 3);
        map.renew("c", 4);
        assertEquals(Map.of("a", 3, "c", 4), map);
    }

    @Test
    void budget_isAShareOfTheTime() {
        AirtimeBudget budget = new AirtimeBudget(1000, 50, 0);
        assertTrue(budget.take(1000, 0));
        assertFalse(budget.take(300, 500));
        assertTrue(budget.take(300, 601));
        assertTrue(budget.take(1000, 1_000_000));
        assertFalse(budget.take(1, 1_000_000));
    }

    @ParameterizedTest
    @CsvSource({"10000,50", "10000,25", "5000,2", "2500,1"})
    void budget_ofAnyHour_isNotMoreThanItsShare(long most, int percent) {
        AirtimeBudget budget = new AirtimeBudget(most, percent, 0);
        Random random = new Random(most);
        Deque<long[]> hour = new ArrayDeque<>();
        long sent = 0;
        long largest = 0;
        for (long now = 0; now < 4 * HOUR; now += random.nextInt(40_000) == 0 ? HOUR / 10 : random.nextInt(200)) {
            long millis = 50 + random.nextInt(300);
            if (budget.take(millis, now)) {
                hour.add(new long[] {now, millis});
                sent += millis;
            }
            while (!hour.isEmpty() && hour.peek()[0] < now - HOUR) {
                sent -= hour.remove()[1];
            }
            largest = Math.max(largest, sent);
        }
        assertTrue(largest <= percent * HOUR / 100, "" + largest);
        assertTrue(largest > percent * HOUR / 100 * 0.7, "it is not less than it must be: " + largest);
    }

    @Test
    void budgets_thatAreNeededTogether_areTakenTogetherOrNotAtAll() {
        AirtimeBudget own = new AirtimeBudget(1000, 50, 0);
        AirtimeBudget ofAll = new AirtimeBudget(500, 1, 0);
        assertTrue(AirtimeBudget.takeOfAll(List.of(own, ofAll), 400, 0));
        assertFalse(AirtimeBudget.takeOfAll(List.of(own, ofAll), 400, 0));
        assertTrue(own.take(600, 0), "nobody pays for what is not sent");
    }

    @Test
    void topics_areReadAsWritten() {
        Topics topics = new Topics("javino/from/lisbon", "west");
        Address device = Address.parse("A+/b");
        assertEquals("javino/from/lisbon/to/east/from/west/heard/A-_b", topics.heard("east", device));
        assertEquals(Optional.of(device), topics.read(topics.heard("east", device)).orElseThrow().device());
        assertEquals(Optional.of(device), topics.read(topics.seek(device)).orElseThrow().device());
        for (Router.Whom whom : Router.Whom.values()) {
            assertEquals(whom, topics.read(topics.air(whom, "+/")).orElseThrow().whom());
        }
        assertEquals(new Topics.Topic(Topics.About.TO, "east", "west", ""),
                topics.read(topics.air(Router.Whom.CELL, "east")).orElseThrow());
        assertEquals(new Topics.Topic(Topics.About.GATEWAY, "x", "west", ""),
                topics.read(topics.gateway("x")).orElseThrow());
        assertEquals("javino/from/lisbon/seek/A-_b/from/+", Topics.fromAll(topics.seek(device)));
        assertEquals("javino/from/lisbon/to/a/from/+/heard/+", Topics.fromAll(topics.heard("a", "+")));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "javino", "javino/to/a/from/b", "javino/to/a/from/b/air/c", "javino/to/a/from/b/heard",
            "other/to/a/from/b/air", "javino/to//from/b/air", "javino/to/a b/from/b/air", "javino/group/AA/from/b",
            "javino/seek/SUPO/from/b/air", "javino/group/AA/from/b/heard/SUPO", "javino/to/a/to/b/air"})
    void topic_ofAnotherForm_isNone(String topic) {
        assertEquals(Optional.empty(), new Topics("javino", "a").read(topic));
    }

    @ParameterizedTest
    @ValueSource(strings = {"ABC", "----", "__AA", "self"})
    void topic_ofNoDevice_tellsNone(String name) {
        Topics topics = new Topics("javino", "b");
        assertEquals(Optional.empty(), topics.read(topics.heard("a", name)).orElseThrow().device());
    }

    @ParameterizedTest
    @CsvSource({"mqtts://b.example, mqtts://b.example:8883", "mqtt://[::1]/, mqtt://[::1]:1883",
            "mqtts://b:1, mqtts://b:1"})
    void url_ofABroker_isRead(String url, String read) {
        assertEquals(read, BrokerConfig.parse(url).toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "b:8883", "https://b", "mqtts://", "mqtts://b/topic", "mqtts://me:secret@b",
            "mqtts://b:0", "mqtts://b:65536", "mqtts://b c"})
    void url_ofNoBroker_isRefusedWithoutAPassword(String url) {
        String message = assertThrows(IllegalArgumentException.class, () -> BrokerConfig.parse(url)).getMessage();
        assertFalse(message.contains("secret"));
    }
}
