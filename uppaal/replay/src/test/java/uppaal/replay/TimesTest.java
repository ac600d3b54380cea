package uppaal.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Genuine traces whose times are changed: what boards do earlier or later than the model allows is refused. */
class TimesTest {
    private static final double SLOT = 0.008;

    private static void shift(Lines lines, int line, double seconds) {
        JsonObject event = lines.get(line);
        for (String field : List.of("t", "start", "end", "asked")) {
            if (event.has(field)) {
                event.addProperty(field, event.get(field).getAsDouble() + seconds);
            }
        }
    }

    /** A packet with all that its hearers say of it. */
    private static void shiftPacket(Lines lines, int sent, double seconds) {
        double start = lines.get(sent).get("start").getAsDouble();
        lines.where(line -> lines.get(line).has("start")
                && Math.abs(lines.get(line).get("start").getAsDouble() - start) < SLOT / 4)
                .forEach(line -> shift(lines, line, seconds));
    }

    private static void shiftAll(Lines lines, int from, double seconds) {
        double time = lines.get(from).get("start").getAsDouble();
        lines.where(line -> lines.get(line).get("t").getAsDouble() >= time)
                .forEach(line -> shift(lines, line, seconds));
    }

    private static String refusal(Lines lines) {
        lines.all.sort(Comparator.comparingDouble(line -> line.get("t").getAsDouble()));
        return lines.replay().refusal().orElse("accepted");
    }

    private static int packet(Lines lines, String board, String kind, int nth) {
        return lines.where(line -> lines.is(line, board, "rf-tx") && lines.text(line, "kind").equals(kind)).get(nth);
    }

    private static double gap(Lines lines, int packet, int later) {
        return lines.get(later).get("start").getAsDouble() - lines.get(packet).get("end").getAsDouble();
    }

    /** The first attempt of a message that is sent again, in the trace of a board whose partner is absent. */
    private static int repeated(Lines lines) {
        return lines.where(line -> lines.is(line, "police", "rf-tx") && lines.text(line, "kind").equals("unicast")
                && lines.where(later -> later > line && lines.is(later, "police", "rf-tx")
                        && lines.text(later, "payload").equals(lines.text(line, "payload"))).size() > 5)
                .get(0);
    }

    @Test
    void times_acknowledgementIntoAPacket_isRefused() {
        Lines lines = Lines.of("highway");
        int acknowledged = packet(lines, "hospital", "acknowledgement", 0);
        int sent = lines.where(line -> lines.is(line, "rf-tx") && line > acknowledged).get(0);
        double into = lines.get(sent).get("start").getAsDouble() + 5 * SLOT
                - lines.get(acknowledged).get("start").getAsDouble();
        shiftPacket(lines, acknowledged, into);
        assertTrue(refusal(lines).contains("SUHO"), refusal(lines));
    }

    @Test
    void times_attemptAfterTooFewQuietSlots_isRefused() {
        Lines lines = Lines.of("highway");
        List<Integer> packets = lines.where(line -> lines.is(line, "rf-tx"));
        int tried = 0;
        for (int i = 1; i < packets.size(); i++) {
            Lines changed = Lines.of("highway");
            int sent = packets.get(i);
            if (!changed.text(sent, "kind").equals("acknowledgement")
                    && gap(changed, packets.get(i - 1), sent) < 30 * SLOT) {
                tried++;
                shiftPacket(changed, sent, 5 * SLOT - gap(changed, packets.get(i - 1), sent));
                assertTrue(refusal(changed).startsWith("event"), "packet " + i);
            }
        }
        assertTrue(tried > 2);
    }

    @Test
    void times_repeatBeforeItsPatienceIsOver_isRefused() {
        for (boolean early : List.of(false, true)) {
            Lines lines = Lines.of("partners");
            int first = repeated(lines);
            int again = lines.where(line -> line > first && lines.is(line, "police", "rf-tx")).get(0);
            shiftAll(lines, again, (early ? 17 : 20) * SLOT - gap(lines, first, again));
            assertEquals(!early, refusal(lines).equals("accepted"), refusal(lines));
        }
    }

    @Test
    void times_arrivalThatEndsBeforeItsPacket_isRefused() {
        Lines lines = Lines.of("highway");
        int heard = lines.next(0, "hospital", "rf-rx");
        shift(lines, heard, 0);
        lines.get(heard).addProperty("end", lines.get(heard).get("end").getAsDouble() - 3 * SLOT);
        assertTrue(refusal(lines).contains("hears a packet end before its sender has ended it"), refusal(lines));
    }

    @Test
    void times_airtimeThatDoesNotFitTheBytes_isRefused() {
        Lines lines = Lines.of("highway");
        int sent = lines.next(0, "support", "rf-tx");
        lines.get(sent).addProperty("bits", lines.get(sent).get("bits").getAsInt() - 1);
        assertTrue(refusal(lines).contains(" for these bytes"), refusal(lines));
    }

    /** The first packet with a short trailer. */
    private static int marked(Lines lines) {
        return lines.where(line -> lines.is(line, "rf-tx") && lines.text(line, "trailer").equals("mark")).get(0);
    }

    @Test
    void times_trailerThatTheEndOfTheTraceCuts_isAccepted() {
        Lines lines = Lines.of("partners");
        int sent = marked(lines);
        JsonObject packet = lines.get(sent);
        packet.addProperty("bits", packet.get("bits").getAsInt() - 1);
        assertTrue(refusal(lines).contains(" for these bytes"), refusal(lines));
        packet.addProperty("cut", true);
        assertFalse(refusal(lines).contains(" for these bytes"), refusal(lines));
    }

    @Test
    void times_airtimeThatIsABitLonger_isRefused() {
        Lines lines = Lines.of("partners");
        int sent = packet(lines, "police", "unicast", 3);
        lines.get(sent).addProperty("end", lines.get(sent).get("end").getAsDouble() + SLOT / 16);
        assertTrue(refusal(lines).contains("expected a time on the air that fits them"), refusal(lines));
    }

    @Test
    void times_trailerThatIsABitLongerOrShorter_isRefused() {
        for (int bits : List.of(1, -1)) {
            Lines lines = Lines.of("partners");
            int sent = marked(lines);
            JsonObject packet = lines.get(sent);
            packet.addProperty("bits", packet.get("bits").getAsInt() + bits);
            for (String time : List.of("t", "end")) {
                packet.addProperty(time, packet.get(time).getAsDouble() + bits * SLOT / 16);
            }
            assertTrue(refusal(lines).contains(" bits; expected "), refusal(lines));
        }
    }

    @Test
    void times_trailerThatAResetBreaksOff_mayBeShorter() {
        Lines lines = Lines.of("partners");
        int sent = marked(lines);
        JsonObject packet = lines.get(sent);
        packet.addProperty("bits", packet.get("bits").getAsInt() - 8);
        packet.addProperty("end", packet.get("end").getAsDouble() - SLOT / 2);
        Lines cut = lines.without(line -> line > sent);
        assertTrue(refusal(cut).contains(" bits; expected "), refusal(cut));
        cut.add(cut.get(sent).get("t").getAsDouble(), "police", "reset", Map.of("why", "fault"));
        assertEquals("accepted", refusal(cut));
    }

    /** Who hears a packet with a trailer may tell of it before its sender does. */
    @Test
    void times_packetThatIsSentAgainAtOnce_isRefusedAtTheEndOfATraceToo() {
        Lines lines = Lines.of("fragments");
        int sent = lines.where(line -> lines.text(line, "trailer").equals("parity")).get(2);
        double start = lines.get(sent).get("start").getAsDouble();
        for (int line : lines.where(line -> lines.get(line).has("start")
                && Math.abs(lines.get(line).get("start").getAsDouble() - start) < SLOT / 4)) {
            lines.all.add(lines.copy(line));
            shift(lines, lines.all.size(), SLOT - gap(lines, sent, sent));
        }
        assertTrue(
                refusal(lines).contains("board4 sends fragment 2 of SUPO to SUPP, nonce 000002000002 after fragment 2"),
                refusal(lines));
    }

    /** What a board may have missed before a packet says nothing of the quiet after it. */
    @Test
    void times_attemptAfterTooFewQuietSlotsThatWereHeard_isRefused() {
        for (int slots : List.of(5, 7)) {
            Lines lines = Lines.of("fragments");
            int acknowledged = packet(lines, "board5", "acknowledgement", 2);
            int sent = lines.where(line -> line > acknowledged && lines.is(line, "board4", "rf-tx")).get(0);
            shiftAll(lines, sent, slots * SLOT - gap(lines, acknowledged, sent));
            assertEquals(slots == 5, refusal(lines).contains("SUPO sends a fragment of it"), refusal(lines));
        }
    }

    @Test
    void times_confirmationThatNeverComes_isRefusedOnceTheBoardTellsSomethingElse() {
        Lines lines = Lines.of("partners");
        int taking = lines.next(0, "bus", "host-taking");
        Lines cut = lines.without(line -> line > taking && lines.is(line, "bus", "host-taken"));
        assertTrue(refusal(cut).contains("bus tells its host something, and not that it has taken message 0"),
                refusal(cut));
    }

    /** A host whose poll is answered late asks once more. */
    @Test
    void times_takenThatIsSaidTwiceAndConfirmedOnce_isAccepted() {
        Lines lines = Lines.of("partners");
        int taking = lines.next(0, "bus", "host-taking");
        lines.all.add(taking, lines.get(taking).deepCopy());
        assertEquals("accepted", refusal(lines));
    }

    /** Bits of several packets together may be no carrier to a board, though it has heard the first one begin. */
    @Test
    void times_attemptSoonAfterCarriersThatOverlapped_isAccepted() {
        for (int injectors : List.of(1, 2)) {
            Lines lines = Lines.of("highway");
            double start = lines.get(packet(lines, "support", "unicast", 0)).get("start").getAsDouble();
            for (int injector = 1; injector <= injectors; injector++) {
                double begin = start - (5 + 0.5 * injector) * SLOT;
                Map<String, Object> noise =
                        Map.of("payload", "a" + injector, "kind", "no frame", "from", "injector" + injector, "start",
                                begin);
                lines.add(begin + 3 * SLOT, "injector" + injector, "rf-tx", noise)
                        .add(begin + 3 * SLOT, "support", "rf-rx", noise);
            }
            assertEquals(injectors == 2, refusal(lines).equals("accepted"), refusal(lines));
        }
    }

    @Test
    void times_outcomeBeforeThePacketsEnd_isRefused() {
        Lines lines = Lines.of("highway");
        int told = lines.next(0, "support", "host-outcome");
        int sent = lines.where(line -> line < told && lines.is(line, "support", "rf-tx")).get(0);
        shift(lines, told, lines.get(sent).get("start").getAsDouble() + SLOT - lines.get(told).get("t").getAsDouble());
        assertTrue(refusal(lines).contains("support, host-outcome"), refusal(lines));
    }

    @Test
    void times_repeatThatNeverComes_isRefused() {
        Lines lines = Lines.of("partners");
        int first = repeated(lines);
        String payload = lines.text(first, "payload");
        List<Integer> all = lines.where(line -> lines.text(line, "payload").equals(payload));
        Lines cut = lines.without(line -> line > first && all.contains(line));
        assertTrue(refusal(cut).startsWith("event"), refusal(cut));
    }

    /** All that follows comes as much later. */
    @Test
    void times_acknowledgementThatComesLate_isRefusedOnceThatIsTooLate() {
        for (int late : List.of(30, 60)) {
            Lines lines = Lines.of("highway");
            shiftAll(lines, packet(lines, "hospital", "acknowledgement", 0), late * SLOT);
            assertEquals(late == 30, refusal(lines).equals("accepted"), refusal(lines));
        }
    }

    /** A board that hears another's packet begins to send one slot after it, or later. */
    @Test
    void times_twoOnTheAirThoughBothHear_isRefusedFromTheSecondSlotOn() {
        for (int slots : List.of(1, 3)) {
            Lines lines = Lines.of("highway");
            int first = packet(lines, "support", "unicast", 0);
            int second = lines.where(line -> line > first && lines.is(line, "rf-tx")
                    && !lines.is(line, "support", "rf-tx") && !lines.text(line, "kind").equals("acknowledgement"))
                    .get(0);
            shiftPacket(lines, second, lines.get(first).get("start").getAsDouble() + slots * SLOT
                    - lines.get(second).get("start").getAsDouble());
            assertEquals(slots > 1, refusal(lines).contains(", rf-tx)"), slots + ": " + refusal(lines));
        }
    }

    @Test
    void times_acknowledgementThatNeverComes_isRefused() {
        Lines lines = Lines.of("highway");
        int acknowledged = packet(lines, "hospital", "acknowledgement", 0);
        String payload = lines.text(acknowledged, "payload");
        Lines cut = lines.without(line -> lines.text(line, "payload").equals(payload));
        assertTrue(refusal(cut).startsWith("event"), refusal(cut));
    }

    @Test
    void times_outcomeThatIsNeverTold_isRefusedOnceTheBoardTellsSomethingElse() {
        Lines lines = Lines.of("partners");
        int told = lines.next(0, "police", "host-outcome");
        Lines cut = lines.without(line -> line == told);
        assertTrue(refusal(cut).contains("expected what has become of message 4"), refusal(cut));
    }

    /** What its board sends meanwhile hears of both, in the order of their times. */
    @Test
    void times_requestThatIsAcceptedOnceACarrierHasBegun_isAccepted() {
        Lines lines = Lines.of("partners");
        List<Integer> asked = lines.where(line -> lines.is(line, "police", "host-transmit"));
        int last = asked.get(asked.size() - 1);
        double start = lines.get(lines.next(last, "police", "rf-rx")).get("start").getAsDouble();
        lines.get(last).addProperty("asked", start - SLOT / 2);
        lines.get(last).addProperty("t", start + SLOT);
        assertEquals("accepted", refusal(lines));
    }

    /** What its host has asked while the air was busy, a board may have done when that was over. */
    @Test
    void times_acknowledgementOfWhatTheHostTookAsACarrierEnded_isAcceptedAfterOneSlot() {
        Lines lines = Lines.of("highway");
        int acknowledged = packet(lines, "hospital", "acknowledgement", 1);
        double start = lines.get(acknowledged).get("start").getAsDouble();
        int taking = acknowledged;
        while (!lines.is(taking, "hospital", "host-taking")) {
            taking--;
        }
        double end = start - 1.2 * SLOT;
        shift(lines, taking - 1, end - 2 * SLOT - lines.get(taking - 1).get("t").getAsDouble());
        shift(lines, taking, end - SLOT / 4 - lines.get(taking).get("t").getAsDouble());
        Map<String, Object> noise = Map.of("payload", "aa", "kind", "no frame", "from", "injector", "start",
                end - 95 / 4000.0);
        lines.add(end, "injector", "rf-tx", noise).add(end, "hospital", "rf-rx", noise);
        assertEquals("accepted", refusal(lines));
    }

    @Test
    void times_outcomesInOneReply_areAccepted() {
        Talk talk = new Talk();
        for (String said : List.of("tell;a", "tell;b")) {
            talk.asks("////", said).sends("police", Talk.broadcast(said));
        }
        for (int number : List.of(0, 1)) {
            talk.lines.add(60, "police", "host-outcome", Map.of("number", number, "outcome", "sent"));
        }
        assertEquals("accepted", refusal(talk.lines));
    }

    @Test
    void times_outcomeThatIsNotToldInAReply_isRefusedWithTheNextOne() {
        Talk talk = new Talk();
        for (String said : List.of("tell;a", "tell;b", "tell;c")) {
            talk.asks("////", said).sends("police", Talk.broadcast(said));
        }
        talk.lines.add(60, "police", "host-outcome", Map.of("number", 0, "outcome", "sent"));
        talk.lines.add(61, "police", "host-outcome", Map.of("number", 1, "outcome", "sent"));
        assertTrue(refusal(talk.lines).contains("not how a message has ended"), refusal(talk.lines));
    }

    /** The run goes on for so long, and nobody does anything more. */
    private static Lines endless(Lines lines, String board, double seconds) {
        return lines.add(seconds, board, "counters", Map.of());
    }

    @Test
    void times_acknowledgementThatDoesNotComeUpToTheEndOfTheRun_isRefused() {
        Lines lines = Lines.of("highway");
        double sent = lines.get(packet(lines, "hospital", "acknowledgement", 0)).get("start").getAsDouble();
        for (double more : List.of(0.2, 10.0)) {
            Lines cut = lines.without(line -> lines.get(line).get("t").getAsDouble() >= sent);
            assertEquals(more < 1, refusal(endless(cut, "hospital", sent + more)).equals("accepted"), refusal(cut));
        }
    }

    @Test
    void times_whatIsAskedAndNeverSent_isRefusedAfterTwentySeconds() {
        Lines lines = Lines.of("partners");
        Lines silent = lines.without(line -> lines.text(line, "event").matches("rf-.*|host-(handed|tak.*|outcome)"));
        assertEquals("accepted", refusal(endless(silent, "police", 27)));
        assertTrue(
                refusal(endless(silent, "police", 38))
                        .contains("police does not send what its host has asked at 9.215 s to be"),
                refusal(silent));
    }

    @Test
    void times_ofABoardWithoutPower_areOver() {
        Lines lines = Lines.of("partners");
        Lines silent = lines.without(line -> lines.text(line, "event").matches("rf-.*|host-(handed|tak.*|outcome)"));
        silent.add(10, "police", "fault", Map.of("do", "power-cut", "until", 48.0));
        assertEquals("accepted", refusal(endless(silent, "police", 38)));
    }

    /** A board that is not in the trace hears each packet of the police to an absent partner. */
    private static Lines heard(String radio, String check, boolean busy) {
        Lines lines = Lines.of("partners");
        int first = repeated(lines);
        String absent = lines.text(first, "destination");
        String own = lines.text(first, "origin");
        double start = lines.get(first).get("start").getAsDouble() - 0.1;
        lines.add(start, "deaf", "host-id", Map.of("id", absent));
        lines.add(start, "deaf", "host-radio", Map.of("radio", radio));
        lines.add(start, "deaf", "host-key", Map.of("address", own, "step", "set", "check", check));
        lines.add(start, "police", "host-key", Map.of("address", absent, "step", "set", "check", "010203"));
        for (int heard : lines.where(line -> lines.text(line, "destination").equals(absent)
                && lines.is(line, "support", "rf-rx"))) {
            JsonObject arrives = lines.copy(heard);
            arrives.addProperty("board", "deaf");
            lines.all.add(arrives);
            if (!busy) {
                lines.add(arrives.get("t").getAsDouble() + 0.01, "deaf", "percepts", Map.of());
            }
        }
        return lines;
    }

    @Test
    void undelivered_thoughItCameOftenToABoardThatListensAndHasTheKey_isRefused() {
        String refusal = refusal(heard("open", "010203", false));
        assertTrue(refusal.contains("police reports undelivered what came undamaged to deaf 5 times"), refusal);
        assertEquals("accepted", refusal(heard("blocked", "010203", false)));
        assertEquals("accepted", refusal(heard("open", "010204", false)));
        assertEquals("accepted", refusal(heard("open", "010203", true)));
    }
}
