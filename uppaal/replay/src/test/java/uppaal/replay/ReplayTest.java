package uppaal.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.nio.charset.StandardCharsets;
import java.util.Comparator;
import java.util.HashMap;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Genuine traces and spoilt ones. {@code highway.jsonl} is what {@code gradle highway} has left in its build folder,
 * {@code fragments.jsonl} what two boards did of which one sent 200 bytes three times at a bit error rate of 1e-3,
 * {@code partners.jsonl} what a board did that sent to two who were there and to two who were not
 * ({@code test/system}'s {@code PartnersTest}), {@code relays.jsonl} what came of three unicasts over two relays (as in
 * {@code RelayTest}); all without the events that the model does not speak of.
 */
class ReplayTest {
    private static final int RATE = 2000;
    private static final int PARITY_BITS = 156;
    private static final String UNICAST = "535550505355504f4341000001000000";

    private static final String FIRST_FRAGMENT =
            unicast("SUPP", 0).substring(0, 16) + "4967" + unicast("SUPP", 0).substring(20) + "77".repeat(41);
    private static final String SECOND_FRAGMENT = fragment("41", "4a", "4259", "77".repeat(11));
    /** The first fragment, which asks. */
    private static final String QUESTION = fragment("41", "49", "4959", FIRST_FRAGMENT);

    private static void assertRefused(Lines lines, int at, String words) {
        String refusal = lines.replay().refusal().orElse("accepted");
        assertTrue(refusal.startsWith("event " + at + " ("), refusal);
        assertTrue(refusal.contains(words), refusal);
        assertEquals(1, refusal.lines().count());
    }

    /** The line with which the support's unicast to the hospital is handed over there. */
    private static int handedToHospital(Lines lines) {
        return lines
                .where(line -> lines.is(line, "hospital", "host-handed") && lines.text(line, "origin").equals("SUPP"))
                .get(0);
    }

    private static int acknowledgedByHospital(Lines lines) {
        return lines.where(
                line -> lines.is(line, "hospital", "rf-tx") && lines.text(line, "kind").equals("acknowledgement"))
                .get(0);
    }

    @ParameterizedTest
    @ValueSource(strings = {"highway", "fragments", "partners", "relays"})
    @Tag("soak")
    void replay_genuineTrace_isAcceptedHoweverEarlyItEnds(String name) {
        Lines lines = Lines.of(name);
        assertEquals("model: trace accepted (" + lines.all.size() + " events)", lines.replay().verdict());
        for (int end = 1; end <= lines.all.size(); end++) {
            int last = end;
            assertTrue(lines.without(line -> line > last).replay().refusal().isEmpty(),
                    () -> "of the first " + last + " lines");
        }
    }

    @Test
    void replay_packetWhoseTrailerEndsAfterItWasHandedOver_isAcceptedHoweverEarlyTheTraceEnds() {
        Lines lines = Lines.of("highway");
        lines.madeUp = true;
        int handed = handedToHospital(lines);
        int sent = lines.where(line -> lines.is(line, "support", "rf-tx")
                && lines.text(line, "kind").equals("unicast") && line < handed).get(0);
        JsonObject packet = lines.get(sent);
        packet.addProperty("trailer", "parity");
        packet.addProperty("bits", packet.get("bits").getAsInt() + PARITY_BITS);
        double over = packet.get("end").getAsDouble() + (double) PARITY_BITS / RATE;
        packet.addProperty("t", over);
        packet.addProperty("end", over);
        lines.get(handed).addProperty("t", over);
        lines.all.add(handed, packet);
        lines.all.remove(sent - 1);
        assertEquals("model: trace accepted (" + lines.all.size() + " events)", lines.replay().verdict());
        for (int end = sent; end <= handed; end++) {
            int last = end;
            assertTrue(lines.without(line -> line > last).replay().refusal().isEmpty(),
                    () -> "of the first " + last + " lines");
        }
    }

    @Test
    void replay_eventsThatItDoesNotKnow_changeNothing() {
        Lines lines = Lines.of("highway");
        String verdict = lines.replay().verdict();
        Map<String, Object> none = Map.of();
        for (int at = lines.all.size(); at > 0; at--) {
            double seconds = lines.get(at).get("t").getAsDouble();
            Lines others = new Lines().add(seconds, "bus", "place", none).add(seconds, "bus", "percepts", none)
                    .add(seconds, "bus", "command", Map.of("do", "reset", "cycle", 1)).add(seconds, "x", "said", none);
            lines.all.addAll(at, others.all);
        }
        JsonObject scenario = new JsonObject();
        scenario.addProperty("t", 0);
        scenario.addProperty("event", "scenario");
        lines.all.add(0, scenario);
        assertEquals(verdict, lines.replay().verdict());
    }

    @Test
    void replay_resetWithinAPacketThatGoesOn_isRefusedThere() {
        Lines lines = Lines.of("highway");
        int sent = lines.where(line -> lines.is(line, "support", "rf-tx")).get(0);
        double middle = (lines.get(sent).get("start").getAsDouble() + lines.get(sent).get("end").getAsDouble()) / 2;
        Lines reset = new Lines().add(middle, "support", "reset", Map.of("why", "fault"));
        int before = (int) lines.all.stream().filter(line -> line.get("t").getAsDouble() < middle).count();
        lines.all.addAll(before, reset.all);
        assertRefused(lines, before + 1, "support sends on after a reset; expected that its packet breaks off");
    }

    @Test
    void replay_handedToAnotherThanTheAddressee_isRefusedThere() {
        Lines lines = Lines.of("highway");
        int handed = handedToHospital(lines);
        lines.get(handed).addProperty("board", "ambulance");
        assertRefused(lines, handed,
                "ambulance hands it to its host (SUPP to SUHO, nonce 072d60000000); expected nothing of it there");
    }

    @Test
    void replay_multicastHandedOutsideItsGroup_isRefusedThere() {
        Lines lines = Lines.of("highway");
        int handed = lines
                .where(line -> lines.is(line, "host-handed") && lines.text(line, "destination").equals("//SU")).get(0);
        lines.get(handed).addProperty("board", "bus");
        assertRefused(lines, handed, "bus hands it to its host");
    }

    @Test
    void replay_reportedDeliveredWithoutAcknowledgement_isRefusedThere() {
        Lines lines = Lines.of("highway");
        String acknowledgement = lines.text(acknowledgedByHospital(lines), "payload");
        Lines spoilt = lines.without(line -> lines.text(line, "payload").equals(acknowledgement));
        assertRefused(spoilt, spoilt.next(0, "support", "host-outcome"),
                "SUPP reports it delivered (SUPP to SUHO, nonce 072d60000000); expected one of: SUPP sends it");
    }

    @Test
    void replay_handedWhatWasNeverSent_isRefusedThere() {
        Lines lines = Lines.of("highway");
        int handed = handedToHospital(lines);
        lines.get(handed).addProperty("id", "063333");
        assertRefused(lines, handed, "hospital hands its host a message that nobody has sent");
    }

    @Test
    void replay_repeatHandedTwice_isRefusedThere() {
        Lines lines = Lines.of("highway");
        int taken = lines.next(handedToHospital(lines), "hospital", "host-taken");
        JsonObject again = lines.copy(handedToHospital(lines));
        again.addProperty("number", 99);
        again.add("t", lines.get(taken).get("t"));
        lines.all.add(taken, again);
        assertRefused(lines, taken + 1, "hospital hands it to its host (SUPP to SUHO, ");
    }

    @Test
    void replay_acknowledgedBeforeItIsTaken_isRefusedThere() {
        Lines lines = Lines.of("highway");
        int number = lines.get(handedToHospital(lines)).get("number").getAsInt();
        Lines spoilt = lines.without(
                line -> lines.text(line, "board").equals("hospital") && lines.text(line, "event").startsWith("host-tak")
                        && lines.text(line, "number").equals("" + number));
        assertRefused(spoilt, acknowledgedByHospital(spoilt), "hospital acknowledges it as delivered (SUPP to SUHO, ");
    }

    @Test
    void replay_repeatAcknowledgedThrice_isRefusedThere() {
        Lines lines = Lines.of("highway");
        lines.madeUp = true;
        int acknowledged = acknowledgedByHospital(lines);
        Lines repeated = lines.without(line -> line > acknowledged);
        int sent = lines.next(0, "support", "rf-tx");
        int heard = lines.next(sent, "hospital", "rf-rx");
        repeated.all.add(later(lines.copy(sent), 1));
        repeated.all.add(later(lines.copy(heard), 1));
        repeated.all.add(later(lines.copy(acknowledged), 2));
        repeated.all.add(later(lines.copy(acknowledged), 3));
        assertEquals("accepted", repeated.replay().refusal().orElse("accepted"));
        repeated.all.add(later(lines.copy(acknowledged), 4));
        assertRefused(repeated, repeated.all.size(), "hospital acknowledges it as delivered (SUPP to SUHO, ");
    }

    private static JsonObject later(JsonObject line, int seconds) {
        for (String field : List.of("t", "start", "end")) {
            line.addProperty(field, line.get(field).getAsDouble() + seconds);
        }
        return line;
    }

    @Test
    void replay_acknowledgedByAnother_isRefusedThere() {
        Lines lines = Lines.of("highway");
        int acknowledged = acknowledgedByHospital(lines);
        JsonObject changed = lines.get(acknowledged);
        changed.addProperty("board", "ambulance");
        changed.addProperty("origin", "SUAM");
        changed.addProperty("payload", changed.get("payload").getAsString().replace("5355484f", "5355414d"));
        assertRefused(lines, acknowledged,
                "ambulance acknowledges a nonce that ends in 000; expected that of a message to it");
    }

    @Test
    void replay_handedWithoutHavingBeenHeard_isRefusedThere() {
        Lines lines = Lines.of("highway");
        int handed = handedToHospital(lines);
        Lines spoilt = lines.without(line -> line < handed && lines.is(line, "hospital", "rf-rx")
                && lines.text(line, "from").equals("support"));
        assertRefused(spoilt, handedToHospital(spoilt), "hospital hands it to its host (SUPP to SUHO, ");
    }

    @Test
    void replay_heardWhatWasNotSent_isRefusedThere() {
        Lines lines = Lines.of("highway");
        int sent = lines.next(0, "support", "rf-tx");
        Lines spoilt = lines.without(line -> line == sent);
        assertEquals("rf-rx", spoilt.text(sent, "event"));
        assertRefused(spoilt, sent, "hears a packet; expected that a board has sent it");
    }

    @Test
    void replay_heardTwice_isRefusedThere() {
        Lines lines = Lines.of("highway");
        int heard = lines.next(0, "hospital", "rf-rx");
        lines.all.add(heard, lines.copy(heard));
        assertRefused(lines, heard + 1, "hears a packet again");
    }

    @Test
    void replay_sentWithoutItsHost_isRefusedThere() {
        Lines lines = Lines.of("highway");
        int asked = lines.next(0, "support", "host-transmit");
        Lines spoilt = lines.without(line -> line == asked);
        assertRefused(spoilt, spoilt.next(0, "support", "rf-tx"), "expected that its host asks for it first");
    }

    @Test
    void replay_givenUpEarly_isRefusedThere() {
        Lines lines = Lines.of("highway");
        int ended = lines.next(0, "support", "host-outcome");
        lines.get(ended).addProperty("outcome", "undelivered");
        assertRefused(lines, ended,
                "SUPP reports it undelivered (SUPP to SUHO, nonce 072d60000000); expected one of: ");
    }

    @Test
    void replay_anotherOutcomeThanBefore_isRefusedThere() {
        Lines lines = Lines.of("highway");
        int ended = lines.next(0, "support", "host-outcome");
        JsonObject again = lines.copy(ended);
        lines.all.add(ended, again);
        assertTrue(lines.replay().refusal().isEmpty(), "the same may be told twice");
        again.addProperty("outcome", "undelivered");
        assertRefused(lines, ended + 1, "expected what it had reported: delivered");
    }

    @Test
    void replay_sameNonceForOtherBytes_isRefusedThere() {
        Lines lines = Lines.of("highway");
        List<Integer> sent =
                lines.where(line -> lines.is(line, "police", "rf-tx") && lines.text(line, "kind").equals("multicast"));
        String payload = lines.text(sent.get(1), "payload");
        lines.get(sent.get(1)).addProperty("payload", payload.substring(0, payload.length() - 2) + "00");
        assertRefused(lines, sent.get(1), "sends other bytes under the nonce of an earlier message");
    }

    @Test
    void replay_confirmedWhatItsHostHasNotTaken_isRefusedThere() {
        Lines lines = Lines.of("highway");
        int taken = lines.next(0, "hospital", "host-taken");
        lines.get(taken).addProperty("number", 99);
        assertRefused(lines, taken, "hospital confirms that its host has taken message 99; expected that its host");
    }

    @Test
    void replay_takenWhatNobodyHandedOver_isRefusedThere() {
        Lines lines = Lines.of("highway");
        int taking = lines.next(0, "hospital", "host-taking");
        lines.get(taking).addProperty("number", 99);
        assertRefused(lines, taking, "hospital is told that its host has taken message 99; expected one that it has");
    }

    @Test
    void replay_takenThatIsConfirmedAfterALaterOne_isRefusedThere() {
        Lines lines = twoBoards();
        for (int number : List.of(0, 1)) {
            String payload = unicast("SUPP", number).replace("5355504f", "43414645");
            reach(lines, 2 + number, "thief", payload, "unicast");
            lines.add(2.5 + number, "support", "host-handed", Map.of("number", number, "destination", "SUPP", "origin",
                    "CAFE", "id", "01000" + number));
            lines.add(2.6 + number, "support", "host-taking", Map.of("number", number));
        }
        for (int number : List.of(1, 0)) {
            assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
            lines.add(4, "support", "host-taken", Map.of("number", number));
        }
        assertRefused(lines, lines.all.size(), "support confirms that its host has taken message 0");
    }

    /** A board that was reset may give its host again what that has not taken, each time. */
    @Test
    void replay_handedAfterEachOfManyResets_isAccepted() {
        Lines lines = twoBoards().add(1.1, "police", "host-transmit",
                Map.of("number", 0, "destination", "SUPP", "asked", 1.0));
        for (int time = 0; time < 5; time++) {
            reach(lines, 2 + 3 * time, "police", unicast("SUPP", 0), "unicast");
            hand(lines, 3 + 3 * time, 0, "010000");
            lines.add(4 + 3 * time, "support", "reset", Map.of("why", "fault"));
        }
        assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
    }

    @Test
    void replay_outcomeBeforeThatOfAnOlderMessageToTheSame_isRefusedThere() {
        Lines lines = Lines.of("partners");
        List<Integer> ended = lines.where(line -> lines.is(line, "police", "host-outcome"));
        int older = ended.get(ended.size() - 2);
        lines.get(older).addProperty("number", 2);
        assertRefused(lines, ended.get(ended.size() - 1),
                "police reports undelivered for message 3; expected what has become of message 1, which was before it");
    }

    @Test
    void replay_sentAfterItWasReportedUndelivered_isRefusedThere() {
        Lines lines = severalAsked("SUPP");
        outcome(lines, 2, 0, "undelivered");
        assertTrue(lines.replay().refusal().isEmpty(), "its key may be deleted");
        send(lines, 3, "police", unicast("SUPP", 0), "unicast");
        assertRefused(lines, lines.all.size(), "expected that its host asks for it first");
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 2})
    void replay_transmissionThatIsNotTheNext_isRefusedThere(int number) {
        Lines lines = Lines.of("partners");
        int asked = lines.where(line -> lines.is(line, "police", "host-transmit")).get(1);
        lines.get(asked).addProperty("number", number);
        assertRefused(lines, asked, "police takes over transmission " + number + "; expected 1");
    }

    @Test
    void replay_timeThatRunsBackwards_isRefusedThere() {
        Lines lines = Lines.of("highway");
        lines.get(100).addProperty("t", 0.5);
        assertRefused(lines, 100, "time runs backwards");
    }

    @Test
    void replay_fragmentOfWhatWasNotBegun_isRefusedThere() {
        Lines lines = Lines.of("fragments");
        int first = lines.where(line -> lines.is(line, "rf-tx") && lines.text(line, "kind").equals("fragment")).get(0);
        String payload = lines.text(first, "payload");
        Lines spoilt =
                lines.without(line -> lines.text(line, "payload").equals(payload) || lines.is(line, "rf-damaged"));
        assertRefused(spoilt, spoilt.where(line -> spoilt.is(line, "rf-tx")).get(0),
                "sends a fragment of a message that it has not begun");
    }

    @Test
    void replay_unicastThatNobodyAnswers_endsAfterEightAttempts() {
        for (int attempts : List.of(7, 8, 9)) {
            Lines lines = greeted("police", "SUPO").add(1.1, "police", "host-transmit",
                    Map.of("number", 0, "destination", "SUPP", "asked", 1.0));
            for (int attempt = 0; attempt < attempts; attempt++) {
                send(lines, 2 + attempt, "police", UNICAST + "00".repeat(10), "unicast");
            }
            lines.add(20, "police", "host-outcome", Map.of("number", 0, "outcome", "undelivered"));
            switch (attempts) {
                case 7 -> assertRefused(lines, lines.all.size(),
                        "SUPO reports it undelivered (SUPO to SUPP, nonce 000001000000); expected one of: "
                                + "SUPO sends it");
                case 8 -> assertTrue(lines.replay().refusal().isEmpty());
                default -> assertRefused(lines, lines.all.size() - 1, "SUPO sends it (SUPO to SUPP, ");
            }
        }
    }

    @Test
    void replay_messagesToSeveralDevices_takeTurnsAndEndInAnyOrder() {
        Lines lines = severalAsked("SUPP", "SUHO", "SUPP", "SUHO");
        for (int attempt = 0; attempt < 8; attempt++) {
            send(lines, 2 + attempt, "police", unicast("SUPP", 0), "unicast");
            send(lines, 2.5 + attempt, "police", unicast("SUHO", 1), "unicast");
        }
        outcome(lines, 10, 1, "undelivered");
        send(lines, 11, "police", unicast("SUHO", 2), "unicast");
        outcome(lines, 11.5, 0, "undelivered");
        send(lines, 12, "police", unicast("SUPP", 3), "unicast");
        assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
        outcome(lines, 13, 3, "undelivered");
        assertRefused(lines, lines.all.size(), "SUPO reports it undelivered (SUPO to SUHO, nonce 000001000002)");
    }

    @Test
    void replay_twoMessagesUnderWayToOneDevice_areRefusedWithTheSecond() {
        Lines lines = severalAsked("SUPP", "SUHO", "SUPP");
        send(lines, 2, "police", unicast("SUPP", 0), "unicast");
        send(lines, 3, "police", unicast("SUHO", 1), "unicast");
        send(lines, 4, "police", unicast("SUPP", 2), "unicast");
        assertRefused(lines, lines.all.size(), "SUPO goes on to another message (SUPO to SUPP, nonce 000001000000)");
    }

    @Test
    void replay_lowerNonceForALaterMessage_isRefused() {
        for (String destination : List.of("SUPP", "SUHO")) {
            Lines lines = severalAsked("SUPP", "SUHO", "SUPP");
            for (int attempt = 0; attempt < 8; attempt++) {
                send(lines, 2 + attempt, "police", unicast("SUPP", 2), "unicast");
            }
            send(lines, 10, "police", unicast(destination, 1), "unicast");
            assertRefused(lines, lines.all.size(), "police seals a message to " + destination
                    + " under nonce 000001000001; expected one above 000001000002");
        }
    }

    @Test
    void replay_messagesToMany_goOneAfterTheOtherBesideUnicasts() {
        Lines lines = severalAsked("SUPP", "//SU", "////");
        send(lines, 2, "police", unicast("SUPP", 0), "unicast");
        send(lines, 3, "police", unicast("//SU", 1), "multicast");
        Lines early = new Lines();
        early.madeUp = true;
        early.all.addAll(lines.all);
        String broadcast = "2f2f2f2f5355504f414978";
        send(early, 4, "police", broadcast, "broadcast");
        assertRefused(early, early.all.size(), "SUPO goes on to another message (SUPO to //SU, ");
        send(lines, 4, "police", unicast("//SU", 1), "multicast");
        send(lines, 5, "police", unicast("SUPP", 0), "unicast");
        send(lines, 6, "police", broadcast, "broadcast");
        outcome(lines, 6.5, 1, "sent");
        outcome(lines, 6.5, 2, "sent");
        assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
    }

    @Test
    void replay_fragmentsOfTwoMessages_areToldApartByTheirIds() {
        for (String id : List.of("42", "41")) {
            Lines lines = severalAsked("SUPP", "SUHO");
            for (int message = 0; message < 2; message++) {
                String digit = message == 0 ? "41" : "42";
                String whole = unicast(message == 0 ? "SUPP" : "SUHO", message);
                String header = whole.substring(0, 16) + "4967" + whole.substring(20);
                send(lines, 2 + 2 * message, "police", fragment(digit, "41", "4959", header + "77".repeat(41)),
                        "fragment");
                send(lines, 3 + 2 * message, "police",
                        fragment(message == 0 ? "41" : id, "4a", "4259", "0" + message + "77".repeat(10)), "fragment");
            }
            if (id.equals("42")) {
                assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
            } else {
                assertRefused(lines, lines.all.size(), "police sends other bytes as fragment 1 of SUPO to SUPP, ");
            }
        }
    }

    /** A key that two boards have. */
    private static Lines keyed(Lines lines) {
        lines.add(0.7, "police", "host-key", Map.of("address", "SUPP", "step", "set", "check", "010203"));
        lines.add(0.7, "support", "host-key", Map.of("address", "SUPO", "step", "set", "check", "010203"));
        return lines.add(0.7, "support", "host-radio", Map.of("radio", "open"));
    }

    /** The police has been asked for a message in two fragments, and the support's board has its key. */
    private static Lines fragments(String model) {
        Lines lines = keyed(severalAsked("SUPP"));
        lines.madeUp = false;
        lines.all.add(JsonParser.parseString("{'t': 0, 'event': 'scenario', 'boards': [{'name': 'support', 'model': '"
                + model + "'}, 'none', {'name': 3}]}").getAsJsonObject());
        return lines;
    }

    @ParameterizedTest
    @CsvSource({"mega, 1, true", "mega, 2, false", "uno, 0, false"})
    void replay_fragmentsThatABoardWithRoomNeverAnswers_areNotUndelivered(String model, int others, boolean refused) {
        Lines lines = fragments(model);
        reach(lines, 2, "police", fragment("41", "41", "4959", FIRST_FRAGMENT), "fragment");
        reach(lines, 2.4, "police", SECOND_FRAGMENT, "fragment");
        for (int attempt = 1; attempt < 8; attempt++) {
            for (int other = 0; other < others; other++) {
                reach(lines, 2.4 + attempt + other * 0.3, "thief",
                        fragment("4" + (2 + other), "49", "4259", "78".repeat(11)),
                        "fragment");
            }
            reach(lines, 2 + attempt, "police", QUESTION, "fragment");
            lines.add(2.39 + attempt, "support", "host-nothing", Map.of());
        }
        outcome(lines, 11, 0, "undelivered");
        sort(lines);
        if (refused) {
            String verdict = lines.replay().verdict();
            assertTrue(verdict.contains("support does not answer (SUPO to SUPP, nonce 000001000000)"), verdict);
        } else {
            assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
        }
    }

    /**
     * A first fragment asks, which was there before or not, and its board answers some of these questions.
     *
     * @param apart seconds from one question to the next: after 6 s a fragment is surely new again
     * @param quiet whether others leave the air for longer than anybody waits for an answer
     */
    @ParameterizedTest
    @CsvSource({"2, 3, -1, true, 3 times that a fragment that asks, which may be there, came",
            "2, 2, -1, true, accepted",
            "2, 4, 2, true, accepted", "2, 3, -1, false, accepted",
            "7, 3, -1, true, 3 times that a new first fragment that asks came"})
    void replay_firstFragmentsThatAskAndAreNotAnswered_areRefused(int apart, int questions, int answered, boolean quiet,
            String words) {
        Lines lines = fragments("mega");
        reach(lines, 2, "police", fragment("41", "41", "4959", FIRST_FRAGMENT), "fragment");
        send(lines, 2.4, "police", SECOND_FRAGMENT, "fragment");
        for (int i = 1; i <= questions; i++) {
            double start = 2 + apart * i;
            reach(lines, start, "police", QUESTION, "fragment");
            if (i == answered) {
                answer(lines, start + 0.5, "01");
            }
            for (double other = 0.4; !quiet && other < apart - 0.1; other += 0.2) {
                reach(lines, start + other, "thief", fragment("42", "49", "4259", "78".repeat(11)), "fragment");
            }
            lines.add(start + 1.7, "support", "host-nothing", Map.of());
        }
        sort(lines);
        assertTrue(lines.replay().verdict().contains(words), lines.replay().verdict());
    }

    /** The last fragment asks, and comes so that its board must know that it is new; but only the first is answered. */
    @Test
    void replay_furtherFragmentsThatAskAndAreNotAnswered_areRefusedThoughFirstOnesAre() {
        Lines lines = fragments("mega");
        send(lines, 2, "police", fragment("41", "41", "4959", FIRST_FRAGMENT), "fragment");
        for (int i = 0; i < 3; i++) {
            double start = 2.4 + 3 * i;
            reach(lines, start, "police", SECOND_FRAGMENT, "fragment");
            lines.add(start + 1.2, "support", "host-nothing", Map.of());
            reach(lines, start + 1.5, "police", QUESTION, "fragment");
            answer(lines, start + 2.1, "01");
        }
        reach(lines, 11.4, "police", SECOND_FRAGMENT, "fragment");
        lines.add(12.6, "support", "host-nothing", Map.of());
        sort(lines);
        String verdict = lines.replay().verdict();
        assertTrue(verdict.contains("3 times that another new fragment that asks came undamaged")
                || verdict.contains("without a fragment that came undamaged"), verdict);
    }

    /** An answer of the support's board, which the police hears. */
    private static void answer(Lines lines, double start, String fragments) {
        String answer = "2b4b41415355505042" + "49" + fragments + "00".repeat(8);
        send(lines, start, "support", answer, "acknowledgement");
        hear(lines, start, "police", "support", answer, "acknowledgement");
    }

    @ParameterizedTest
    @CsvSource({"3, sends again a fragment that has come, though it was told 3 times", "2, accepted"})
    void replay_questionsThatAreAnsweredAndRepeated_areRefused(int answers, String words) {
        Lines lines = fragments("mega");
        reach(lines, 2, "police", fragment("41", "41", "4959", FIRST_FRAGMENT), "fragment");
        send(lines, 2.4, "police", SECOND_FRAGMENT, "fragment");
        for (int i = 0; i < 4; i++) {
            reach(lines, 3 + 2 * i, "police", QUESTION, "fragment");
            if (i < answers) {
                answer(lines, 4 + 2 * i, "01");
            }
        }
        sort(lines);
        assertTrue(lines.replay().verdict().contains(words), lines.replay().verdict());
    }

    @ParameterizedTest
    @CsvSource({"01, support answers 3 times in a row without a fragment that came undamaged", "03, accepted"})
    void replay_fragmentsThatCameAndAreNotTold_areRefused(String told, String words) {
        Lines lines = fragments("mega");
        reach(lines, 2, "police", fragment("41", "41", "4959", FIRST_FRAGMENT), "fragment");
        for (int i = 0; i < 3; i++) {
            reach(lines, 2.5 + 1.5 * i, "police", SECOND_FRAGMENT, "fragment");
            answer(lines, 3.2 + 1.5 * i, told);
        }
        sort(lines);
        assertTrue(lines.replay().verdict().contains(words), lines.replay().verdict());
    }

    @ParameterizedTest
    @CsvSource({"none, refused", "second, accepted", "blocked, accepted"})
    void replay_broadcastsThatCameAndAreNotHandedOver_areRefused(String handed, String verdict) {
        Lines lines = keyed(severalAsked("////", "////", "////"));
        lines.madeUp = false;
        if (handed.equals("blocked")) {
            lines.add(0.8, "support", "host-radio", Map.of("radio", "blocked"));
        }
        lines.add(1.9, "support", "host-nothing", Map.of());
        for (int i = 0; i < 3; i++) {
            reach(lines, 2 + 3 * i, "police", "2f2f2f2f5355504f41497" + i, "broadcast");
            if (i == 1 && handed.equals("second")) {
                lines.add(5.5, "support", "host-handed",
                        Map.of("number", 0, "destination", "////", "origin", "SUPO", "id", "000000", "content", "q"));
                take(lines, 5.6, 0);
            }
            lines.add(4 + 3 * i, "support", "host-nothing", Map.of());
        }
        sort(lines);
        assertEquals(verdict, lines.replay().refusal().map(why -> "refused").orElse("accepted"),
                lines.replay()::verdict);
    }

    /** What goes to a group does not stand for broadcasts. */
    @Test
    void replay_broadcastsThatAreNotHandedOverThoughMulticastsAre_areRefused() {
        Lines lines = keyed(severalAsked("////", "//SU", "////", "//SU", "////"));
        lines.madeUp = false;
        for (String board : List.of("police", "support")) {
            lines.add(0.7, board, "host-key", Map.of("address", "//SU", "step", "set", "check", "020304"));
        }
        lines.add(1.9, "support", "host-nothing", Map.of());
        for (int i = 0; i < 5; i++) {
            boolean broadcast = i % 2 == 0;
            reach(lines, 2 + 3 * i, "police", broadcast ? "2f2f2f2f5355504f41497" + i : unicast("//SU", i),
                    broadcast ? "broadcast" : "multicast");
            if (!broadcast) {
                send(lines, 3 + 3 * i, "police", unicast("//SU", i), "multicast");
                lines.add(3.5 + 3 * i, "support", "host-handed",
                        Map.of("number", i / 2, "destination", "//SU", "origin", "SUPO", "id", "01000" + i));
                take(lines, 3.6 + 3 * i, i / 2);
            }
            lines.add(4.2 + 3 * i, "support", "host-nothing", Map.of());
        }
        sort(lines);
        assertTrue(lines.replay().verdict().contains("support has nothing to tell; expected a message (SUPO to ////)"),
                lines.replay().verdict());
    }

    /** What comes may be lost, but not of each message when it comes first. */
    @ParameterizedTest
    @CsvSource({"3, -1, false, support has nothing to tell; expected a message", "2, -1, false, accepted",
            "3, 1, false, accepted",
            "3, -1, true, 3 times that another new fragment that asks came undamaged",
            "3, 1, true, accepted"})
    void replay_unicastsThatAreHeededOnlyWhenTheyComeAgain_areRefused(int messages, int heeded, boolean inFragments,
            String words) {
        String[] all = new String[messages];
        Arrays.fill(all, "SUPP");
        Lines lines = keyed(severalAsked(all));
        lines.madeUp = false;
        lines.all.add(JsonParser.parseString("{'event': 'scenario', 't': 0,"
                + " 'boards': [{'name': 'support', 'model': 'mega'}]}").getAsJsonObject());
        lines.add(1.9, "support", "host-nothing", Map.of());
        for (int i = 0; i < messages; i++) {
            double start = 2 + 4 * i;
            String whole = unicast("SUPP", i);
            String first = whole.substring(0, 16) + "4967" + whole.substring(20) + "77".repeat(41);
            String digit = "4" + (1 + i);
            if (inFragments) {
                reach(lines, start, "police", fragment(digit, "41", "4959", first), "fragment");
                reach(lines, start + 0.4, "police", fragment(digit, "4a", "4259", "77".repeat(11)), "fragment");
            } else {
                reach(lines, start, "police", whole, "unicast");
            }
            if (i != heeded) {
                lines.add(start + 1.3, "support", "host-nothing", Map.of());
                reach(lines, start + 1.5, "police", inFragments ? fragment(digit, "49", "4959", first) : whole,
                        inFragments ? "fragment" : "unicast");
            }
            hand(lines, start + 1.9, i, "01000" + i);
            take(lines, start + 1.95, i);
            String answer = "2b4b41" + digit + "535550504241" + "00".repeat(8);
            send(lines, start + 2.1, "support", answer, "acknowledgement");
            hear(lines, start + 2.1, "police", "support", answer, "acknowledgement");
            outcome(lines, start + 2.5, i, "delivered");
        }
        sort(lines);
        assertTrue(lines.replay().verdict().contains(words), lines.replay().verdict());
    }

    @ParameterizedTest
    @CsvSource({"3, police sends again what was said to be stale 3 times", "2, accepted"})
    void replay_staleMessageThatIsSentAgain_isRefused(int notices, String words) {
        Lines lines = keyed(severalAsked("SUPP"));
        lines.madeUp = false;
        for (int i = 0; i < 4; i++) {
            reach(lines, 2 + 2 * i, "police", unicast("SUPP", 0), "unicast");
            if (i < notices) {
                String uptime = String.format("%04x", 25 + 20 * i);
                String answer = "2b4b4141535550504341" + "000001000000" + uptime + "00".repeat(8);
                send(lines, 3 + 2 * i, "support", answer, "acknowledgement");
                hear(lines, 3 + 2 * i, "police", "support", answer, "acknowledgement");
            }
        }
        sort(lines);
        assertTrue(lines.replay().verdict().contains(words), lines.replay().verdict());
    }

    @Test
    void replay_undeliveredThoughItWasNeverSent_isRefusedIfItsBoardHasTheKey() {
        Lines lines = keyed(severalAsked("SUPP", "////"));
        sort(lines);
        outcome(lines, 2, 0, "undelivered");
        assertRefused(lines, lines.all.size(),
                "police reports undelivered what was never on the air, to SUPP; expected that it is sent");
        lines.add(1.5, "police", "host-key", Map.of("address", "SUPP", "step", "delete"));
        sort(lines);
        assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
    }

    private static void key(Lines lines, double seconds, String step, String address, String check) {
        lines.add(seconds, "police", "host-key", Map.of("address", address, "step", step, "check", check));
    }

    /** The police's board is a Mega, which has place for eight session keys. */
    private static Lines sessionKeys(String... destinations) {
        Lines lines = severalAsked(destinations);
        lines.madeUp = false;
        lines.all.add(JsonParser.parseString("{'t': 0, 'event': 'scenario', 'boards': [{'name': 'police', "
                + "'model': 'mega'}]}").getAsJsonObject());
        sort(lines);
        return lines;
    }

    @ParameterizedTest
    @CsvSource({"session, refused", "none, accepted", "reset, accepted", "delete, accepted"})
    void replay_undeliveredThoughItWasNeverSent_isRefusedIfItsBoardHasTheSessionKey(String step, String verdict) {
        Lines lines = sessionKeys();
        if (!step.equals("none")) {
            key(lines, 0.5, "session", "SUPP", "010203");
        }
        if (step.equals("delete")) {
            key(lines, 0.6, "delete", "SUPP", "");
        } else if (step.equals("reset")) {
            lines.add(0.6, "police", "reset", Map.of("why", "power"));
        }
        lines.add(1, "police", "host-transmit",
                Map.of("number", 0, "destination", "SUPP", "asked", 1, "content", "tell;x"));
        sort(lines);
        outcome(lines, 2, 0, "undelivered");
        assertEquals(verdict, lines.replay().refusal().map(why -> "refused").orElse("accepted"),
                lines.replay()::verdict);
    }

    /** A small chip has one message under way; and what cannot be sealed has no turn. */
    @ParameterizedTest
    @CsvSource({"mega, SUHO, true", "mega, SUPC, false", "uno, SUHO, false"})
    void replay_messageThatNeverHasItsTurn_isRefusedIfItsBoardHasAPlaceForIt(String model, String key,
            boolean refused) {
        Lines lines = sessionKeys("SUPP", "SUHO");
        lines.get(lines.where(line -> lines.is(line, "scenario")).get(0)).getAsJsonArray("boards").get(0)
                .getAsJsonObject().addProperty("model", model);
        key(lines, 0.5, "session", "SUPP", "010203");
        key(lines, 0.6, "session", key, "040506");
        for (int i = 0; i < 5; i++) {
            reach(lines, 2 + i, "police", unicast("SUPP", 0), "unicast");
        }
        sort(lines);
        if (refused) {
            assertRefused(lines, lines.all.size() - 1, "expected that what its host has asked at 1.000 s to be sent to "
                    + "SUHO has its turn");
        } else {
            assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
        }
    }

    /** An answer that tells which fragments lack lets the sender go on at once; without one its attempt has failed. */
    @ParameterizedTest
    @CsvSource({"true, accepted", "false, refused"})
    void replay_fragmentsThatGoOnUponAnAnswer_takeNoTurnFromOthers(boolean isHeard, String verdict) {
        Lines lines = keyed(sessionKeys("SUPP", "SUHO"));
        key(lines, 0.6, "session", "SUHO", "040506");
        reach(lines, 2, "police", fragment("41", "41", "4959", FIRST_FRAGMENT), "fragment");
        for (double start = 2.4; start < 7.4; start++) {
            send(lines, start, "police", SECOND_FRAGMENT, "fragment");
            damage(lines, start, "support", "police");
            if (isHeard) {
                answer(lines, start + 0.4, "01");
            }
        }
        sort(lines);
        assertEquals(verdict, lines.replay().refusal().map(why -> "refused").orElse("accepted"),
                lines.replay()::verdict);
    }

    /** An answer that is due goes with the key; the sender's own is another board's. */
    @ParameterizedTest
    @CsvSource({"hospital, delete, SUPP, accepted", "hospital, session, SUPP, accepted",
            "hospital, delete, SUPO, refused", "support, delete, SUHO, refused", "hospital, none, SUPP, refused"})
    void replay_messageThatIsNotAnswered_isAcceptedIfItsKeyHasGone(String board, String step, String address,
            String verdict) {
        Lines all = Lines.of("highway");
        int answer = acknowledgedByHospital(all);
        Lines lines = all.without(line -> line >= answer);
        int taken = lines.where(line -> lines.is(line, "hospital", "host-taken")).get(2);
        if (!step.equals("none")) {
            Lines key = new Lines().add(lines.get(taken).get("t").getAsDouble(), board, "host-key",
                    Map.of("address", address, "step", step, "check", step.equals("session") ? "070809" : ""));
            lines.all.addAll(taken, key.all);
        }
        lines.add(15, "ambulance", "host-transmit",
                Map.of("number", 0, "destination", "////", "asked", 15, "content", "tell;help"));
        send(lines, 16, "ambulance", "2f2f2f2f5355414d424974656c6c3b68656c70", "broadcast");
        hear(lines, 16, "hospital", "ambulance", "2f2f2f2f5355414d424974656c6c3b68656c70", "broadcast");
        if (verdict.equals("refused")) {
            assertRefused(lines, lines.all.size(), "hospital does nothing of what is due");
        } else {
            assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
        }
    }

    /** What a replaced key ends makes room at once; the reply that tells of the key comes behind that. */
    @Test
    void replay_anotherMessageBetweenRequestAndReplyForAKey_isAccepted() {
        Lines lines = Lines.of("replaced");
        int key = lines.where(line -> lines.is(line, "bus", "host-key")).get(1);
        double replied = lines.get(key).get("t").getAsDouble();
        assertTrue(lines.replay().verdict().contains("ROMA sends another message meanwhile"));
        lines.get(key).addProperty("asked", replied - 0.006);
        assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
    }

    /** A board that has another key now knows no answer to what it has sealed with the one before. */
    @ParameterizedTest
    @CsvSource({"070809, 2.5, true", "010203, 2.5, false", "070809, 1.5, true", ", 1.5, true", "070809, 0.6, false"})
    void replay_sentAgainThoughAnswered_isAcceptedIfItsKeyWasReplaced(String check, double when, boolean accepted) {
        Lines lines = sessionKeys("SUPP");
        key(lines, 0.5, "session", "SUPP", "010203");
        key(lines, when, check == null ? "delete" : "session", "SUPP", check == null ? "" : check);
        for (int i = 0; i < 4; i++) {
            reach(lines, 2 + 2 * i, "police", unicast("SUPP", 0), "unicast");
            String answer = "2b4b4141535550504341" + "000001000000" + String.format("%04x", 25 + 20 * i)
                    + "00".repeat(8);
            send(lines, 3 + 2 * i, "support", answer, "acknowledgement");
            hear(lines, 3 + 2 * i, "police", "support", answer, "acknowledgement");
        }
        sort(lines);
        assertEquals(accepted, lines.replay().refusal().isEmpty(), lines.replay()::verdict);
    }

    @ParameterizedTest
    @CsvSource({"070809, true", "010203, false", "none, false", ", true"})
    void replay_undeliveredBeforeItsAttempts_isAcceptedIfItsKeyHasGone(String check, boolean accepted) {
        Lines lines = sessionKeys("SUPP");
        key(lines, 0.5, "session", "SUPP", "010203");
        reach(lines, 2, "police", unicast("SUPP", 0), "unicast");
        if (!"none".equals(check)) {
            key(lines, 2.5, check == null ? "delete" : "session", "SUPP", check == null ? "" : check);
        }
        sort(lines);
        outcome(lines, 3, 0, "undelivered");
        assertEquals(accepted, lines.replay().refusal().isEmpty(), lines.replay()::verdict);
    }

    @Test
    void replay_sessionKeyThatItsBoardHadBefore_isRefused() {
        Lines lines = sessionKeys();
        key(lines, 2, "session", "SUPP", "010203");
        key(lines, 2.1, "session", "SUPP", "010203");
        key(lines, 2.2, "session", "SUHO", "040506");
        key(lines, 2.3, "session", "SUPP", "070809");
        assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
        key(lines, 2.4, "session", "SUPP", "010203");
        assertRefused(lines, lines.all.size(),
                "police sets a session key for SUPP, check value 010203; expected that it"
                        + " refuses it: it had that one before");
        lines.add(2.35, "police", "reset", Map.of("why", "power"));
        sort(lines);
        assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
    }

    @Test
    void replay_sessionKeyBesideAStoredOne_isRefused() {
        Lines lines = sessionKeys();
        key(lines, 2, "session", "SUPP", "010203");
        key(lines, 2.1, "set", "SUPP", "040506");
        assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
        key(lines, 2.2, "session", "SUPP", "070809");
        assertRefused(lines, lines.all.size(), "it has a stored key for that device");
    }

    /** Which of nine went is not known, so nothing is demanded of those before. */
    @Test
    void replay_moreSessionKeysThanPlaces_anyButTheLastMayBeGone() {
        Lines lines = sessionKeys();
        for (int i = 0; i < 9; i++) {
            key(lines, 0.5 + i * 0.01, "session", "SUP" + (char) ('A' + i), "01020" + i);
        }
        for (int i = 0; i < 2; i++) {
            lines.add(1 + i, "police", "host-transmit", Map.of("number", i, "destination", i == 0 ? "SUPC" : "SUPI",
                    "asked", 1 + i, "content", "tell;x"));
        }
        sort(lines);
        outcome(lines, 3, 0, "undelivered");
        assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
        outcome(lines, 4, 1, "undelivered");
        assertRefused(lines, lines.all.size(), "expected that it is sent");
    }

    /** Two carriers together may be none to a board, also where they began while it sent. */
    @ParameterizedTest
    @CsvSource({"2.05, accepted", "2.15, refused"})
    void replay_sentIntoCarriers_isAcceptedIfTheyOverlap(double second, String verdict) {
        Lines lines = severalAsked("//SU");
        lines.madeUp = false;
        String noise = fragment("41", "4a", "4259", "77".repeat(11));
        send(lines, 2, "thief", noise, "fragment");
        send(lines, 2.0005, "police", unicast("//SU", 0), "multicast");
        send(lines, second, "robber", noise, "fragment");
        send(lines, 2.13, "police", unicast("//SU", 0), "multicast");
        damage(lines, 2, "police", "thief");
        damage(lines, second, "police", "robber");
        sort(lines);
        assertEquals(verdict, lines.replay().refusal().map(why -> "refused").orElse("accepted"),
                lines.replay()::verdict);
    }

    @Test
    void replay_powerThatGoesAndComes_isAcceptedThoughAMessageCameBefore() {
        Lines lines = severalAsked("SUPP");
        reach(lines, 2, "police", unicast("SUPP", 0), "unicast");
        lines.add(3, "support", "fault", Map.of("do", "power-cut", "until", 4.0));
        lines.add(4, "support", "reset", Map.of("why", "power"));
        assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
        hand(lines, 5, 0, "010000");
        assertRefused(lines, lines.all.size(), "support hands it to its host");
    }

    @Test
    void replay_crash_isRefused() {
        assertRefused(twoBoards().add(1, "support", "crash", Map.of()), 4, "support's program crashes");
    }

    /** Receivers combine damaged copies, and know what acknowledgement they wait for. */
    @Test
    void replay_damagedPackets_mayHaveBeenTakenFromTheirEndOn() {
        for (boolean heard : List.of(true, false)) {
            Lines lines = severalAsked("SUPP");
            for (int attempt = 0; attempt < 3; attempt++) {
                send(lines, 2 + attempt, "police", unicast("SUPP", 0), "unicast");
                if (heard) {
                    damage(lines, 2 + attempt, "support", "police");
                }
            }
            hand(lines, 4.3015, 0, "010000");
            if (!heard) {
                assertRefused(lines, lines.all.size(), "support hands it to its host");
                continue;
            }
            sort(lines);
            take(lines, 4.4, 0);
            send(lines, 5, "support", "2b4b4141535550504241" + "00".repeat(8), "acknowledgement");
            Lines unheard = new Lines();
            unheard.madeUp = true;
            unheard.all.addAll(lines.all);
            outcome(unheard, 5.3005, 0, "delivered");
            assertRefused(unheard, unheard.all.size(), "SUPO reports it delivered");
            damage(lines, 5, "police", "support");
            outcome(lines, 5.3005, 0, "delivered");
            sort(lines);
            assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
        }
    }

    @Test
    void replay_forgery_mayBeOnTheAirButIsNeverHandedOver() {
        Lines lines = twoBoards();
        reach(lines, 2, "thief", UNICAST + "00".repeat(10), "unicast");
        send(lines, 3, "thief", "2b4b41415355504f4241" + "00".repeat(8), "acknowledgement");
        assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
        hand(lines, 4, 0, "010000");
        assertRefused(lines, lines.all.size(), "support hands its host a message that nobody has sent");
    }

    /** An attacker sends frames and fragments of any length, and answers to what never was. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void replay_noiseOfAnAttacker_isReadToItsEnd(long seed) {
        List<String> destinations =
                List.of("+FAI", "+FBJ", "+KAA", "+KBA", "////", "//SU", "SUPO", "SUPP", "SUPX");
        List<String> origins = List.of("SUPP", "SUPO", "SUPX");
        Random random = new Random(seed);
        Lines lines = twoBoards();
        for (int i = 0; i < 300; i++) {
            String destination = destinations.get(random.nextInt(destinations.size()));
            byte[] message = new byte[random.nextInt(24)];
            random.nextBytes(message);
            byte[] packet = SharedKey.join(
                    SharedKey.header(destination, origins.get(random.nextInt(origins.size())), message.length),
                    message);
            reach(lines, 2 + 0.7 * i, "thief", HexFormat.of().formatHex(packet), Talk.kind(packet));
        }
        Replay replay = lines.replay();
        assertEquals("", replay.refusal().filter(why -> !why.contains("without a fragment that came undamaged"))
                .orElse(""));
    }

    @Test
    void replay_replayOfAnAttacker_mayBeHandedOverOnce() {
        Lines lines = twoBoards().add(1.1, "police", "host-transmit",
                Map.of("number", 0, "destination", "SUPP", "asked", 1.0));
        String payload = UNICAST + "00".repeat(10);
        send(lines, 2, "police", payload, "unicast");
        for (int play = 3; play < 5; play++) {
            reach(lines, play, "thief", payload, "unicast");
        }
        for (int number = 0; number < 2; number++) {
            hand(lines, 6 + number, number, "010000");
            take(lines, 6.1 + number, number);
        }
        assertRefused(lines, lines.all.size() - 2, "support hands it to its host (SUPO to SUPP, ");
    }

    @Test
    void replay_forgedFragment_isAnsweredAndTakesNoNonceAway() {
        Lines lines = twoBoards();
        String forged =
                "2b464149" + "5355504f" + "4959" + "53555050" + "5355504f" + "4e77" + "000001000000" + "77".repeat(51);
        String answer = "2b4b4141" + "53555050" + "4249" + "01" + "00".repeat(8);
        reach(lines, 2, "thief", forged, "fragment");
        send(lines, 3, "support", answer, "acknowledgement");
        lines.add(4.1, "police", "host-transmit", Map.of("number", 0, "destination", "SUPP", "asked", 4.0));
        send(lines, 5, "police", UNICAST + "00".repeat(10), "unicast");
        assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
        hand(lines, 6, 0, "010000");
        assertRefused(lines, lines.all.size(), "support hands it to its host (SUPO to SUPP, ");
    }

    /** A third board, which has an id of its own, is to send what police has sent. */
    @Test
    void replay_packetOfAnother_isSentOnlyIfTheHostAsksForIt() {
        String payload = UNICAST + "00".repeat(10);
        for (boolean asked : List.of(true, false)) {
            Lines lines = twoBoards().add(1.1, "police", "host-transmit",
                    Map.of("number", 0, "destination", "SUPP", "asked", 1.0));
            lines.add(1.2, "relay", "host-id", Map.of("id", "CAFE", "epoch", "000001"));
            send(lines, 2, "police", payload, "unicast");
            if (asked) {
                lines.add(2.6, "relay", "host-relay", Map.of("number", 0, "asked", 2.5, "payload", payload));
            }
            reach(lines, 3, "relay", payload, "unicast");
            if (!asked) {
                assertTrue(lines.replay().refusal().get().contains("relay sends as 'SUPO'; expected its own id"),
                        lines.replay().verdict());
                continue;
            }
            hand(lines, 4, 0, "010000");
            lines.add(4.1, "relay", "host-outcome", Map.of("number", 0, "outcome", "sent"));
            assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
            lines.get(lines.all.size()).addProperty("outcome", "delivered");
            assertRefused(lines, lines.all.size(), "relay reports delivered for what it has relayed; expected: sent");
            send(lines, 5, "relay", payload, "unicast");
            lines.get(lines.all.size() - 1).addProperty("outcome", "sent");
            assertRefused(lines, lines.all.size(), "relay sends as 'SUPO'");
        }
    }

    @Test
    void replay_relayedThatWasNeverOnTheAir_isNotSent() {
        Lines lines = twoBoards().add(2, "police", "host-relay",
                Map.of("number", 0, "asked", 1.9, "payload", "43414645" + "43414650" + "4141"));
        lines.add(3, "police", "host-outcome", Map.of("number", 0, "outcome", "sent"));
        assertRefused(lines, lines.all.size(), "reports sent for a message that was never on the air");
    }

    @Test
    void replay_injectorWithAnIdOfItsOwn_isHeard() {
        Lines lines = twoBoards();
        String payload = UNICAST.replace("5355504f", "43414645") + "00".repeat(10);
        reach(lines, 2, "thief", payload, "unicast");
        lines.add(4, "support", "host-handed",
                Map.of("number", 0, "destination", "SUPP", "origin", "CAFE", "id", "010000"));
        assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
    }

    @Test
    void replay_injectorWithWhatIsNoFrame_isHeard() {
        Lines lines = twoBoards();
        reach(lines, 2, "injector", "00", "no frame");
        assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
    }

    @Test
    void replay_handedAgainAfterAReset_onlyIfItWasNotTaken() {
        for (boolean taken : List.of(false, true)) {
            Lines lines = twoBoards().add(1.1, "police", "host-transmit",
                    Map.of("number", 0, "destination", "SUPP", "asked", 1.0));
            String payload = UNICAST + "00".repeat(10);
            reach(lines, 2, "police", payload, "unicast");
            hand(lines, 3, 0, "010000");
            lines.add(3.1, "support", "host-taking", Map.of("number", 0));
            if (taken) {
                lines.add(3.2, "support", "host-taken", Map.of("number", 0));
            }
            lines.add(4, "support", "reset", Map.of("why", "fault"));
            reach(lines, 5, "police", payload, "unicast");
            hand(lines, 6, 0, "010000");
            assertEquals(taken, lines.replay().refusal().isPresent(), lines.replay().verdict());
        }
    }

    /** Only the whole tells by its tag that it is refused: until then a board asks for the rest of it. */
    @Test
    void replay_firstFragmentOfWhatABoardWillRefuse_isAnswered() {
        String first =
                "2b464149" + "5355504f" + "4959" + "53555050" + "5355504f" + "4e77" + "000001000000" + "77".repeat(51);
        String rest = "2b46414a" + "5355504f" + "476f" + "77".repeat(53);
        for (boolean stale : List.of(true, false)) {
            Lines lines = twoBoards().add(1.1, "police", "host-transmit",
                    Map.of("number", 0, "destination", "SUPP", "asked", 1.0));
            reach(lines, 2, "police", first.replaceFirst("2b464149", "2b464141"), "fragment");
            reach(lines, 3, "police", rest, "fragment");
            hand(lines, 4, 0, "010000");
            if (stale) {
                lines.add(4.5, "support", "reset", Map.of("why", "power"));
            } else {
                take(lines, 4.1, 0);
                String delivered = "2b4b4141" + "53555050" + "4241" + "00".repeat(8);
                send(lines, 5, "support", delivered, "acknowledgement");
                hear(lines, 5, "police", "support", delivered, "acknowledgement");
                lines.add(5.5, "police", "host-outcome", Map.of("number", 0, "outcome", "delivered"));
                lines.add(6.1, "police", "host-transmit", Map.of("number", 1, "destination", "SUPP", "asked", 6.0));
                reach(lines, 6.05, "police", UNICAST.replace("1000000", "1000001") + "00".repeat(10), "unicast");
                hand(lines, 7, 1, "010001");
                take(lines, 7.1, 1);
            }
            reach(lines, 8, "thief", first, "fragment");
            send(lines, 9, "support", "2b4b4141" + "53555050" + "4249" + "01" + "00".repeat(8), "acknowledgement");
            assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20})
    void replay_randomDamage_isRefused(long seed) {
        Random random = new Random(seed);
        for (String name : List.of("highway", "fragments", "partners")) {
            for (Damage damage : Damage.values()) {
                Lines lines = Lines.of(name);
                List<Integer> places = lines.where(line -> damage.fits(lines, line));
                int place = places.get(random.nextInt(places.size()));
                String what = name + ", " + damage + " of line " + place + ": " + lines.get(place);
                Replay replay = damage.in(lines, place, random).replay();
                assertFalse(replay.refusal().isEmpty(), what);
                int at = Integer.parseInt(replay.refusal().orElseThrow().split(" ")[1]);
                assertTrue(damage == Damage.LOSS ? at >= place : at == place || at == place + 1,
                        () -> what + " refused: " + replay.verdict());
            }
        }
    }

    /** What is done to one line. */
    private enum Damage {
        /** A packet that was sent, and heard at once: behind its line, if it has no trailer. */
        LOSS {
            @Override
            boolean fits(Lines lines, int line) {
                return lines.is(line, "rf-tx") && line < lines.all.size() && lines.is(line + 1, "rf-rx")
                        && lines.text(line, "trailer").isEmpty();
            }

            @Override
            Lines in(Lines lines, int line, Random random) {
                return lines.without(each -> each == line);
            }
        },
        /** Handed over or sent twice. */
        DUPLICATE {
            @Override
            boolean fits(Lines lines, int line) {
                return lines.is(line, "rf-tx") || lines.is(line, "rf-rx") || lines.is(line, "host-handed");
            }

            @Override
            Lines in(Lines lines, int line, Random random) {
                JsonObject copy = lines.copy(line);
                if (copy.has("number")) {
                    copy.addProperty("number", 100 + random.nextInt(100));
                }
                lines.all.add(line, copy);
                return lines;
            }
        },
        /** Handed over by another board. */
        SWAP {
            @Override
            boolean fits(Lines lines, int line) {
                return lines.is(line, "host-handed") && !lines.text(line, "destination").startsWith("//");
            }

            @Override
            Lines in(Lines lines, int line, Random random) {
                List<String> others = lines.where(each -> lines.is(each, "host-id")).stream()
                        .map(each -> lines.text(each, "board")).distinct()
                        .filter(board -> !board.equals(lines.text(line, "board"))).toList();
                lines.get(line).addProperty("board", others.get(random.nextInt(others.size())));
                return lines;
            }
        };

        abstract boolean fits(Lines lines, int line);

        abstract Lines in(Lines lines, int line, Random random);
    }

    @Test
    void line_thatIsNoEvent_isOneClearSentence() {
        Replay replay = new Replay();
        replay.line("{\"t\":1,\"board\":\"a\",\"event\":\"reset\",\"why\":\"power\"}");
        for (String wrong : List.of("", "no", "[1]", "{}", "{\"t\":\"x\",\"event\":\"reset\"}")) {
            String message = assertThrows(IllegalArgumentException.class, () -> replay.line(wrong)).getMessage();
            assertTrue(message.matches("line \\d+ is no line of a trace: .*"), message);
        }
        replay.line("{\"t\":2,\"board\":\"a\",\"event\":\"host-handed\"}");
        assertEquals("line 7 is no line of a trace: an event 'host-handed' without 'number'",
                assertThrows(IllegalArgumentException.class, replay::finish).getMessage());
    }

    /** The police has been asked to send to these, at once. */
    /** As an attacker may repeat it, for example after a reset: that it is old, too, only the whole can tell. */
    @Test
    void replay_firstFragmentOfWhatIsOlderThanWhatTheHostHas_isAnsweredInTime() {
        Lines lines = fragments("mega");
        lines.add(1.1, "police", "host-transmit", Map.of("number", 1, "destination", "SUPP", "asked", 1.0));
        reach(lines, 2, "police", fragment("41", "41", "4959", FIRST_FRAGMENT), "fragment");
        reach(lines, 2.4, "police", fragment("41", "4a", "4259", "77".repeat(11)), "fragment");
        handAndAcknowledge(lines, 2.8, 0, "41");
        lines.add(3.5, "support", "reset", Map.of("why", "fault"));
        reach(lines, 5, "police", unicast("SUPP", 1), "unicast");
        handAndAcknowledge(lines, 5.4, 1, "42");
        reach(lines, 8, "thief", QUESTION, "fragment");
        JsonObject heard = lines.get(lines.all.size());
        heard.addProperty("t", heard.get("end").getAsDouble());
        send(lines, 8.4, "support", "2b4b41415355505042" + "49" + "01" + "00".repeat(8), "acknowledgement");
        sort(lines);
        assertTrue(lines.replay().refusal().isEmpty(), lines.replay().verdict());
    }

    /** It writes down meanwhile what its host has taken, and so looks late at a repeat; another packet follows that. */
    @ParameterizedTest
    @CsvSource({"4.9, accepted", "4.25, support acknowledges it as delivered"})
    void replay_answerOfABoardThatIsBusyWithAnotherMessage_mayComeOneSlotAfterALaterPacket(double taken, String words) {
        Lines lines = keyed(severalAsked("SUPP"));
        lines.madeUp = false;
        String junk = fragment("42", "49", "4259", "78".repeat(11));
        String delivered = "2b4b4141535550504241" + "00".repeat(8);
        reach(lines, 2, "police", unicast("SUPP", 0), "unicast");
        hand(lines, 2.3, 0, "010000");
        take(lines, 2.31, 0);
        send(lines, 2.45, "support", delivered, "acknowledgement");
        reach(lines, 4, "thief", "2f2f2f2f5355504f414978", "broadcast");
        lines.add(4.2, "support", "host-handed",
                Map.of("number", 1, "destination", "////", "origin", "SUPO", "id", "000000", "content", "x"));
        lines.add(4.21, "support", "host-taking", Map.of("number", 1));
        lines.add(taken, "support", "host-taken", Map.of("number", 1));
        reach(lines, 4.3, "thief", unicast("SUPP", 0), "unicast");
        reach(lines, 4.51, "thief", junk, "fragment");
        double end = 4.51 + (lines.get(lines.all.size()).get("bits").getAsInt() - 1) / 2000.0;
        send(lines, end + 0.0105, "support", delivered, "acknowledgement");
        for (JsonObject line : lines.all) {
            if (line.has("bits")) {
                line.addProperty("end", line.get("start").getAsDouble() + (line.get("bits").getAsInt() - 1) / 2000.0);
                line.add("t", line.get("end"));
            }
        }
        sort(lines);
        assertTrue(lines.replay().verdict().contains(words), lines.replay().verdict());
    }

    private static void handAndAcknowledge(Lines lines, double seconds, int number, String digit) {
        hand(lines, seconds, number, "01000" + number);
        take(lines, seconds + 0.05, number);
        String delivered = "2b4b41" + digit + "535550504241" + "00".repeat(8);
        send(lines, seconds + 0.2, "support", delivered, "acknowledgement");
        hear(lines, seconds + 0.2, "police", "support", delivered, "acknowledgement");
        outcome(lines, seconds + 0.6, number, "delivered");
    }

    private static Lines severalAsked(String... destinations) {
        Lines lines = twoBoards();
        for (int number = 0; number < destinations.length; number++) {
            lines.add(1.1, "police", "host-transmit",
                    Map.of("number", number, "destination", destinations[number], "asked", 1.0));
        }
        return lines;
    }

    /** A sealed frame of the police in its first epoch. */
    private static String unicast(String destination, int counter) {
        return HexFormat.of().formatHex(destination.getBytes(StandardCharsets.US_ASCII)) + "5355504f4341000001"
                + String.format("%06x", counter) + "00".repeat(10);
    }

    private static String fragment(String id, String index, String size, String message) {
        return "2b46" + id + index + "5355504f" + size + message;
    }

    private static void outcome(Lines lines, double seconds, int number, String outcome) {
        lines.add(seconds, "police", "host-outcome", Map.of("number", number, "outcome", outcome));
    }

    /** A packet comes damaged; the line about it comes some bits after the packet. */
    private static void damage(Lines lines, double start, String board, String from) {
        lines.add(start + 0.302, board, "rf-damaged",
                Map.of("from", from, "why", "CRC", "start", start, "end", start + 0.3));
    }

    private static void sort(Lines lines) {
        lines.all.sort(Comparator.comparingDouble(line -> line.get("t").getAsDouble()));
    }

    private static Lines greeted(String board, String id) {
        Lines lines = new Lines();
        lines.madeUp = true;
        return lines.add(0, board, "reset", Map.of("why", "power")).add(0.5, board, "host-id", Map.of("id", id));
    }

    private static Lines twoBoards() {
        return greeted("police", "SUPO").add(0.6, "support", "host-id", Map.of("id", "SUPP"));
    }

    private static void send(Lines lines, double start, String board, String payload, String kind) {
        lines.add(start + 0.3, board, "rf-tx",
                Map.of("payload", payload, "kind", kind, "start", start, "end", start + 0.3));
    }

    /** A packet to the support's board that is sent and heard. */
    private static void reach(Lines lines, double start, String board, String payload, String kind) {
        send(lines, start, board, payload, kind);
        hear(lines, start, "support", board, payload, kind);
    }

    private static void hand(Lines lines, double seconds, int number, String id) {
        lines.add(seconds, "support", "host-handed",
                Map.of("number", number, "destination", "SUPP", "origin", "SUPO", "id", id));
    }

    private static void take(Lines lines, double seconds, int number) {
        lines.add(seconds, "support", "host-taking", Map.of("number", number)).add(seconds + 0.1, "support",
                "host-taken", Map.of("number", number));
    }

    private static void hear(Lines lines, double start, String board, String from, String payload, String kind) {
        Map<String, Object> fields =
                new HashMap<>(Map.of("payload", payload, "kind", kind, "start", start + 0.0001, "end", start + 0.3001));
        fields.put("from", from);
        lines.add(start + 0.3001, board, "rf-rx", fields);
    }
}
