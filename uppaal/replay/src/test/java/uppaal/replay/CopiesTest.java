package uppaal.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * What relays send. {@code relays.jsonl} is of a line from, relay1, relay2, to, in which each hears its neighbours
 * only: the first message is sent twice, since relay2 does not carry its acknowledgement at first.
 */
class CopiesTest {
    private static final double SLOT = 0.008;
    /** Later than all that a trace tells. */
    private static final double AFTER = 100;

    private final Lines lines = Lines.of("relays");

    /** The n-th packet of a board of this kind, from 0. */
    private int packet(String board, String kind, int nth) {
        return lines.where(line -> lines.is(line, board, "rf-tx") && lines.text(line, "kind").equals(kind)).get(nth);
    }

    private double start(int line) {
        return lines.get(line).get("start").getAsDouble();
    }

    private double end(int line) {
        return lines.get(line).get("end").getAsDouble();
    }

    /** All that is told of a packet. */
    private List<Integer> of(int packet) {
        double start = start(packet);
        return lines.where(line -> lines.get(line).has("start") && Math.abs(start(line) - start) < SLOT / 4);
    }

    private static void shift(JsonObject event, double seconds) {
        for (String field : List.of("t", "start", "end")) {
            if (event.has(field)) {
                event.addProperty(field, event.get(field).getAsDouble() + seconds);
            }
        }
    }

    private void shift(int packet, double seconds) {
        of(packet).forEach(line -> shift(lines.get(line), seconds));
    }

    /** Sends a packet once more, at another time. */
    private void again(int packet, double start) {
        double seconds = start - start(packet);
        for (int line : of(packet)) {
            JsonObject copy = lines.copy(line);
            shift(copy, seconds);
            lines.all.add(copy);
        }
    }

    /** A packet that a board sends, which nobody hears. */
    private void sends(String board, String payload, String kind, double start, Map<String, Object> more) {
        Map<String, Object> fields = new HashMap<>(Map.of("payload", payload, "kind", kind, "start", start));
        fields.putAll(more);
        lines.add(start, board, "rf-tx", fields);
        JsonObject sent = lines.all.get(lines.all.size() - 1);
        double end = start + (sent.get("bits").getAsDouble() - 1) / 2000;
        sent.addProperty("end", end);
        sent.addProperty("t", end);
    }

    private String refusal() {
        lines.all.sort(Comparator.comparingDouble(line -> line.get("t").getAsDouble()));
        return lines.replay().refusal().orElse("accepted");
    }

    private void assertRefused(String words) {
        String refusal = refusal();
        assertTrue(refusal.contains(words), refusal);
    }

    @Test
    void copies_ofTheGenuineTrace_areAccepted() {
        assertEquals("accepted", refusal());
    }

    @ParameterizedTest
    @CsvSource({"unicast, 0, 'with 0 hops behind it; expected 1, one more than it came with'",
            "unicast, 2, 'with 2 hops behind it; expected 1, one more than it came with'",
            "acknowledgement, 1, 'with 1 hops behind it; expected 2, one more than it came with'"})
    void copy_withOtherHops_isRefused(String kind, int hops, String words) {
        of(packet("relay1", kind, 0)).forEach(line -> lines.get(line).addProperty("hops", hops));
        assertRefused("relay1 copies a");
        assertRefused(words);
    }

    @Test
    void copy_heardWithOtherHops_isRefused() {
        lines.get(lines.next(packet("relay1", "unicast", 0), "relay2", "rf-rx")).addProperty("hops", 2);
        assertRefused("relay2 hears a packet with 2 hops behind it; expected 1, as it was sent");
    }

    @Test
    void ownPacket_withHops_isRefused() {
        of(packet("from", "unicast", 0)).forEach(line -> lines.get(line).addProperty("hops", 1));
        assertRefused("from sends its own packet with 1 hops behind it; expected none");
    }

    @Test
    void copy_withATrailer_isRefused() {
        JsonObject copy = lines.get(packet("relay1", "unicast", 0));
        copy.addProperty("trailer", "mark");
        copy.addProperty("bits", copy.get("bits").getAsInt() + 12);
        copy.addProperty("end", copy.get("end").getAsDouble() + 12 / 2000.0);
        assertRefused("relay1 copies a unicast of ROMA with a trailer; expected none");
    }

    @Test
    void copy_withOtherBytes_isRefused() {
        int copy = packet("relay1", "unicast", 0);
        String payload = lines.text(copy, "payload");
        String other = payload.substring(0, payload.length() - 2) + (payload.endsWith("00") ? "01" : "00");
        of(copy).forEach(line -> lines.get(line).addProperty("payload", other));
        assertRefused("relay1 copies a unicast of ROMA; expected a unicast in one packet, or its acknowledgement, that "
                + "has come to it");
    }

    @Test
    void copy_ofAMulticastABroadcastOrAFragment_isRefused() {
        for (String[] each : new String[][] {{"broadcast", "2f2f2f2f524f4d4141513031"},
                {"multicast", "2f2f5355524f4d414277" + "00".repeat(14)},
                {"fragment", "2b464141524f4d414277" + "00".repeat(14)}}) {
            Lines before = Lines.of("relays");
            lines.all.clear();
            lines.all.addAll(before.all);
            heard(each[1], each[0], AFTER);
            sends("relay1", each[1], each[0], AFTER + 2, Map.of("hops", 1));
            assertRefused("relay1 copies a " + each[0] + " of ROMA; expected a unicast in one packet");
        }
    }

    @Test
    void copy_afterTooFewQuietSlots_isRefused() {
        int copy = packet("relay1", "unicast", 0);
        shift(copy, end(packet("from", "unicast", 0)) + 7 * SLOT - start(copy));
        assertRefused("relay1 copies a unicast of ROMA after 7.0 quiet slots; expected 8 or more");
    }

    /** After what it has sent of its own accord: else that is still due, and needs two only. */
    @Test
    void copy_ofWhatItsSenderSendsAgain_needsSixQuietSlots() {
        int copy = packet("relay1", "unicast", 2);
        int sent = packet("from", "unicast", 2);
        again(copy, end(copy) + 40 * SLOT);
        double soon = end(copy) + 100 * SLOT;
        again(sent, soon);
        double over = soon + end(sent) - start(sent);
        List<JsonObject> before = List.copyOf(lines.all);
        again(copy, over + 7 * SLOT);
        assertEquals("accepted", refusal());
        lines.all.clear();
        lines.all.addAll(before);
        again(packet("relay1", "unicast", 2), over + 5 * SLOT);
        assertRefused("relay1 copies a unicast of ROMA after 5.0 quiet slots; expected 6 or more");
    }

    @Test
    void copy_ofWhatBeginsAnew_needsEightQuietSlots() {
        int copy = packet("relay1", "unicast", 2);
        again(copy, end(copy) + 40 * SLOT);
        int sent = packet("from", "unicast", 2);
        double late = end(copy) + 300 * SLOT;
        again(sent, late);
        again(copy, late + end(sent) - start(sent) + 7 * SLOT);
        assertRefused("relay1 copies a unicast of ROMA after 7.0 quiet slots; expected 8 or more");
    }

    @Test
    void acknowledgement_withoutAQuietSlot_isRefused() {
        int copy = packet("relay2", "acknowledgement", 1);
        shift(copy, end(packet("to", "acknowledgement", 1)) + 0.3 * SLOT - start(copy));
        assertRefused("relay2 copies an acknowledgement of SUPO after 0.3 quiet slots; expected 1 or more");
    }

    @Test
    void copy_onceMoreOfItsOwnAccord_isAcceptedAfterTwentyTwoSlots() {
        int copy = packet("relay1", "unicast", 2);
        again(copy, end(copy) + 21 * SLOT);
        assertRefused("relay1 copies a unicast of ROMA again too soon");
    }

    @Test
    void copy_aThirdTime_isRefused() {
        int copy = packet("relay1", "unicast", 2);
        again(copy, end(copy) + 40 * SLOT);
        assertEquals("accepted", refusal());
        again(copy, end(copy) + 90 * SLOT);
        assertRefused("relay1 copies a unicast of ROMA once more than it may; expected that it comes again first");
    }

    @Test
    void copy_afterItHasCarriedTheAcknowledgement_isRefused() {
        int copy = packet("relay1", "unicast", 3);
        again(copy, AFTER);
        assertRefused("relay1 copies a unicast of ROMA though it has carried its acknowledgement");
    }

    @Test
    void acknowledgement_ofWhatItHasNotCopied_isRefused() {
        heard("53555a5a524f4d414277" + "00".repeat(14), "unicast", AFTER);
        String answer = "2b4b414153555a5a4241" + "00".repeat(8);
        heard(answer, "acknowledgement", AFTER + 0.5);
        sends("relay1", answer, "acknowledgement", AFTER + 1, Map.of("hops", 1));
        assertRefused(
                "relay1 copies an acknowledgement of SUZZ; expected one that has come to it, for a packet that it "
                        + "has copied");
    }

    @ParameterizedTest
    @CsvSource({"1.3, 'for a packet that it has copied'", "2.2, accepted"})
    void acknowledgement_ofWhatItHasNotCopied_needsThatItComesAgainLate(double seconds, String words) {
        String packet = "53555a5a524f4d414277" + "00".repeat(14);
        String answer = "2b4b414153555a5a4241" + "00".repeat(8);
        heard(packet, "unicast", AFTER);
        heard(answer, "acknowledgement", AFTER + 0.5);
        heard(packet, "unicast", AFTER + 0.5 + seconds);
        sends("relay1", answer, "acknowledgement", AFTER + 4, Map.of("hops", 1));
        assertRefused(words);
    }

    /** A relay keeps four packets; the fifth has come, and may be in its place all the same. */
    @Test
    void acknowledgement_ofWhatMayHaveLostItsPlace_isAccepted() {
        for (int packet = 1; packet < 6; packet++) {
            heard("53555a5a524f4d414277" + String.format("%012x", packet) + "00".repeat(8), "unicast", AFTER + packet);
        }
        String last = "53555a5a524f4d414277" + "0".repeat(11) + "5" + "00".repeat(8);
        sends("relay1", last, "unicast", AFTER + 6, Map.of("hops", 1));
        sends("injector", last, "unicast", AFTER + 7, Map.of("hops", 2));
        hears("relay1");
        String answer = "2b4b414653555a5a4241" + "00".repeat(8);
        heard(answer, "acknowledgement", AFTER + 8);
        sends("relay1", answer, "acknowledgement", AFTER + 9, Map.of("hops", 1));
        assertEquals("accepted", refusal());
    }

    @Test
    void acknowledgement_aFifthTime_isRefused() {
        int copy = packet("relay1", "acknowledgement", 2);
        for (int time = 0; time < 3; time++) {
            again(copy, AFTER + time);
        }
        assertEquals("accepted", refusal());
        again(copy, AFTER + 3);
        assertRefused("relay1 copies an acknowledgement of ROMA more than 4 times");
    }

    @Test
    void copy_ofABoardThatHasSaidThatItRelaysNothing_isRefused() {
        lines.get(lines.next(0, "relay1", "host-relaying")).addProperty("relaying", "off");
        lines.add(0.5, "relay1", "host-id", Map.of("id", "SUAA"));
        assertRefused("relay1 copies a unicast of ROMA; expected that it relays nothing");
    }

    @Test
    void copy_ofABoardThatHasNotSaidWhetherItRelays_isHeldToTheRules() {
        int told = lines.next(0, "relay1", "host-relaying");
        lines.all.set(told - 1, lines.copy(lines.next(0, "from", "host-id")));
        lines.get(told).addProperty("board", "relay1");
        lines.get(told).addProperty("id", "SUAA");
        assertEquals("accepted", refusal());
        int copy = packet("relay1", "unicast", 0);
        shift(copy, end(packet("from", "unicast", 0)) + 7 * SLOT - start(copy));
        assertRefused("expected 8 or more");
    }

    @Test
    void copies_ofWhatNobodyAcknowledges_takeATenthOfTheAir() {
        int copied = 0;
        String refusal = "accepted";
        for (int packet = 0; refusal.equals("accepted") && packet < 20; packet++) {
            String each = "53555a5a524f4d414867" + String.format("%012x", packet) + "00".repeat(54);
            double start = AFTER + 2 * packet;
            heard(each, "unicast", start);
            sends("relay1", each, "unicast", start + 1, Map.of("hops", 1));
            copied++;
            refusal = refusal();
        }
        assertTrue(copied > 8 && copied < 20, copied + ": " + refusal);
        assertTrue(refusal.contains("of the air are left for what nobody acknowledges"), refusal);
    }

    /** Packets that are answered before the relay's turn: one that copies them all the same does not listen. */
    @Test
    void copies_ofWhatWasAnswered_areRefusedTheThirdTime() {
        String refusal = "accepted";
        int packet = 0;
        for (; refusal.equals("accepted") && packet < 4; packet++) {
            double start = AFTER + 4 * packet;
            String each = "53555a5a524f4d414277" + String.format("%012x", packet) + "00".repeat(8);
            String answer = "2b4b41" + "4142434445".substring(2 * packet, 2 * packet + 2) + "53555a5a" + "4241"
                    + "00".repeat(8);
            heard(each, "unicast", start);
            heard(answer, "acknowledgement", start + 0.5);
            sends("relay1", each, "unicast", start + 2, Map.of("hops", 1));
            refusal = refusal();
        }
        assertEquals(3, packet, refusal);
        assertTrue(refusal.contains("which was answered or handed on; expected silence"), refusal);
    }

    /** The injector sends a packet that relay1 hears. */
    private void heard(String payload, String kind, double start) {
        sends("injector", payload, kind, start, Map.of());
        hears("relay1");
    }

    /** A board hears the last packet. */
    private void hears(String board) {
        JsonObject heard = lines.all.get(lines.all.size() - 1).deepCopy();
        heard.addProperty("board", board);
        heard.addProperty("event", "rf-rx");
        heard.addProperty("from", "injector");
        lines.all.add(heard);
    }

    /** The sender hears relay1's copy each time, and must wait for 3 s. */
    @Test
    void attempt_soonAfterACopyWasHeard_isAcceptedTwiceAndRefusedTheThirdTime() {
        int sent = packet("from", "unicast", 0);
        int copy = packet("relay1", "unicast", 0);
        double over = end(copy);
        lines.all.subList(lines.where(line -> lines.get(line).get("t").getAsDouble() <= over + SLOT).size(),
                lines.all.size()).clear();
        for (int time = 0; time < 3; time++) {
            assertEquals("accepted", refusal());
            double next = end(packet("relay1", "unicast", time)) + 90 * SLOT;
            again(packet("from", "unicast", time), next);
            again(packet("relay1", "unicast", time), next + end(sent) - start(sent) + 10 * SLOT);
        }
        assertRefused("from does not wait for a relay (ROMA to SUPO");
    }
}
