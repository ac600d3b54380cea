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
 * What relays send. {@code relays.jsonl} is of a line from, relay1, relay2, to, in which each hears its neighbours only: the
 * first message is sent twice, since relay2 does not carry its acknowledgement at first.
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
    void copy_ofAMulticastABroadcastOrAPiece_isRefused() {
        for (String[] each : new String[][] {{"broadcast", "2f2f2f2f524f4d4141493031"},
                {"multicast", "2f2f5355524f4d414277" + "00".repeat(22)},
                {"piece", "2b464141524f4d414277" + "00".repeat(22)}}) {
            Lines before = Lines.of("relays");
            lines.all.clear();
            lines.all.addAll(before.all);
            lines.add(1, "stranger", "rf-tx", Map.of("payload", each[1], "kind", each[0], "start", AFTER));
            JsonObject sent = lines.all.get(lines.all.size() - 1);
            sent.addProperty("t", sent.get("end").getAsDouble());
            JsonObject heard = sent.deepCopy();
            heard.addProperty("board", "relay1");
            heard.addProperty("event", "rf-rx");
            heard.addProperty("from", "stranger");
            lines.all.add(heard);
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

    @Test
    void copy_ofWhatItsSenderSendsAgain_needsSixQuietSlots() {
        int copy = packet("relay1", "unicast", 1);
        double sent = end(packet("from", "unicast", 1));
        shift(copy, sent + 5 * SLOT - start(copy));
        assertRefused("relay1 copies a unicast of ROMA after 5.0 quiet slots; expected 6 or more");
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
        for (int copy : List.of(packet("relay2", "unicast", 1), packet("relay2", "unicast", 0))) {
            List<Integer> dropped = of(copy);
            dropped.sort(Comparator.reverseOrder());
            dropped.forEach(line -> lines.all.remove(line - 1));
        }
        assertRefused("relay2 copies an acknowledgement of ROMA; expected one that has come to it, for a packet that it "
                + "has copied");
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
        String payload = lines.text(packet("from", "unicast", 0), "payload");
        String last = "00".repeat(40);
        int copied = 0;
        String refusal = "accepted";
        for (int packet = 0; refusal.equals("accepted") && packet < 20; packet++) {
            String each = "53555a5a524f4d414544" + String.format("%012x", packet) + "00".repeat(54);
            double start = AFTER + 2 * packet;
            lines.add(start, "stranger", "rf-tx", Map.of("payload", each, "kind", "unicast", "start", start));
            JsonObject sent = lines.all.get(lines.all.size() - 1);
            sent.addProperty("t", sent.get("end").getAsDouble());
            JsonObject heard = sent.deepCopy();
            heard.addProperty("board", "relay1");
            heard.addProperty("event", "rf-rx");
            heard.addProperty("from", "stranger");
            lines.all.add(heard);
            sends("relay1", each, "unicast", start + 1, Map.of("hops", 1));
            copied++;
            refusal = refusal();
        }
        assertTrue(payload.length() > last.length() / 2 && copied > 8 && copied < 20, "" + copied);
        assertTrue(refusal.contains("of the air are left for what nobody acknowledges"), refusal);
    }

    /** Packets that are answered before the relay's turn: one that copies them all the same does not listen. */
    @Test
    void copies_ofWhatWasAnswered_areRefusedTheThirdTime() {
        String refusal = "accepted";
        int packet = 0;
        for (; refusal.equals("accepted") && packet < 4; packet++) {
            double start = AFTER + 4 * packet;
            String each = "53555a5a524f4d414277" + String.format("%012x", packet) + "00".repeat(16);
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

    /** A stranger sends a packet that relay1 hears. */
    private void heard(String payload, String kind, double start) {
        sends("stranger", payload, kind, start, Map.of());
        JsonObject heard = lines.all.get(lines.all.size() - 1).deepCopy();
        heard.addProperty("board", "relay1");
        heard.addProperty("event", "rf-rx");
        heard.addProperty("from", "stranger");
        lines.all.add(heard);
    }

    /** The sender hears relay1's copy, and would wait for 3 s. */
    @Test
    void attempt_soonAfterACopyWasHeard_isAcceptedTwiceAndRefusedTheThirdTime() {
        int second = packet("from", "unicast", 3);
        double copied = end(packet("relay1", "unicast", 2));
        assertTrue(start(second) - copied > 3);
        // It need not have heard the copy; then its second attempt may come at once.
        double early = copied + 20 * SLOT - start(second);
        lines.where(line -> lines.get(line).get("t").getAsDouble() >= start(second))
                .forEach(line -> shift(lines.get(line), early));
        for (int line : lines.where(each -> lines.is(each, "host-transmit"))) {
            JsonObject asked = lines.get(line);
            double late = asked.get("t").getAsDouble() - asked.get("asked").getAsDouble();
            asked.addProperty("asked", late > 1 ? asked.get("asked").getAsDouble() + early
                    : asked.get("asked").getAsDouble());
        }
        assertEquals("accepted", refusal());
    }

    @Test
    void attempts_soonAfterCopies_areRefusedTheThirdTime() {
        Lines partners = Lines.of("partners");
        lines.all.clear();
        lines.all.addAll(partners.all);
        // Another board copies each packet to who is not there, so that police hears it.
        for (int sent : partners.where(line -> partners.is(line, "police", "rf-tx")
                && partners.text(line, "destination").equals("SUAM"))) {
            JsonObject copy = partners.copy(sent);
            double seconds = copy.get("end").getAsDouble() - copy.get("start").getAsDouble() + 9 * SLOT;
            shift(copy, seconds);
            copy.addProperty("board", "stranger");
            copy.addProperty("hops", 1);
            copy.remove("trailer");
            JsonObject heard = copy.deepCopy();
            heard.addProperty("event", "rf-rx");
            heard.addProperty("board", "police");
            heard.addProperty("from", "stranger");
            lines.all.add(copy);
            lines.all.add(heard);
        }
        assertRefused("police does not wait for a relay");
    }
}
