package uppaal.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static uppaal.replay.Talk.LONG;
import static uppaal.replay.Talk.acknowledgement;
import static uppaal.replay.Talk.broadcast;
import static uppaal.replay.Talk.changed;
import static uppaal.replay.Talk.fragment;
import static uppaal.replay.Talk.sealed;
import static uppaal.replay.Talk.withZeros;

import com.google.gson.JsonObject;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Random;
import javino.protocol.Payload;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What boards must not put on the air: traces that mutants of the firmware would leave, and spoilt genuine ones. */
class BytesTest {
    private static final String FIRST = "000001000000";
    private static final String SECOND = "000001000001";
    private static final String HELP = "tell;help";
    private static final byte[] LONG_FRAME = sealed("SUPP", FIRST, LONG);
    /** A first fragment of it, and its second, which wants an answer. */
    private static final byte[] BEGIN = fragment("AA", LONG_FRAME, 0);
    private static final byte[] END = fragment("AJ", LONG_FRAME, 1);
    /** Its first fragment, when that asks. */
    private static final byte[] AGAIN = fragment("AI", LONG_FRAME, 0);

    private static void assertRefused(Talk talk, String words) {
        String verdict = talk.verdict();
        assertTrue(verdict.startsWith("model: trace refused at event " + talk.lines.all.size() + " ("), verdict);
        assertTrue(verdict.contains(words), verdict);
        assertEquals(1, verdict.lines().count());
    }

    private static void assertAccepted(Talk talk, String checked) {
        assertEquals("model: trace accepted (" + talk.lines.all.size() + " events, " + checked + ")", talk.verdict());
        assertEquals("model: trace accepted (" + talk.lines.all.size() + " events)", talk.verdictWithoutKeys());
    }

    private static void assertRefusedEvenWithoutKeys(Talk talk, String words) {
        assertRefused(talk, words);
        assertTrue(talk.verdictWithoutKeys().contains(words), talk.verdictWithoutKeys());
    }

    private static Talk asked(String destination, String content) {
        return new Talk().asks(destination, content);
    }

    private static byte[] utf8(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    /** As it is sealed, but with other bytes for the cipher; the tag may fit them. */
    private static byte[] withCipher(byte[] frame, byte[] cipher) {
        byte[] changed = frame.clone();
        System.arraycopy(cipher, 0, changed, Frame.CONTENT, cipher.length);
        return changed;
    }

    @Test
    void genuine_ofEachKind_isAcceptedAndCounted() {
        assertAccepted(asked("SUPP", HELP).sends("police", sealed("SUPP", FIRST, HELP)).hands(0, FIRST, HELP)
                .sends("support", acknowledgement(FIRST, "")), "1 messages opened, 1 proofs");
        assertAccepted(asked("//SU", HELP).sends("police", sealed("//SU", FIRST, HELP))
                .sends("police", sealed("//SU", FIRST, HELP)), "1 messages opened, 0 proofs");
        assertAccepted(asked("////", HELP).sends("police", broadcast(HELP)), "0 messages opened, 0 proofs");
        assertAccepted(asked("SUPP", LONG).sends("police", BEGIN).unheard("police", END).sends("police", AGAIN)
                .unheard("support", acknowledgement(FIRST, "01")).sends("police", AGAIN)
                .sends("support", acknowledgement(FIRST, "01")).sends("police", END).hands(0, FIRST, LONG)
                .sends("support", acknowledgement(FIRST, "")), "1 messages opened, 3 proofs");
    }

    @Test
    void fragment_thatAsksThoughNobodyHasAnswered_isTheFirst() {
        Talk talk = asked("SUPP", LONG).sends("police", BEGIN).unheard("police", END).unheard("police", END);
        assertRefusedEvenWithoutKeys(talk,
                "police sends fragment 1 of SUPO to SUPP, nonce 000001000000 though nobody has "
                        + "answered; expected that its first fragment asks");
        assertRefusedEvenWithoutKeys(
                asked("SUPP", LONG).sends("police", BEGIN).unheard("police", END).unheard("police", BEGIN),
                "expected that its first fragment asks");
    }

    @Test
    void sealed_wrongly_isRefusedByName() {
        byte[] right = sealed("SUPP", FIRST, HELP);
        assertRefused(asked("SUPP", HELP).unheard("police", changed(right, -1)),
                "with a wrong tag; expected that of 'tell;help'");
        assertRefused(asked("SUPP", HELP).unheard("police", withZeros(right, Payload.TAG_LENGTH)), "with a wrong tag");
        assertRefused(asked("SUPP", HELP).unheard("police", changed(right, Frame.CONTENT)),
                "police sends a message to SUPP under nonce 000001000000 that opens under none of the 1 keys for it");
        assertRefused(asked("SUPP", HELP).unheard("police", sealed("SUPP", FIRST, "tell;halp")),
                "that says 'tell;halp'; expected 'tell;help'");
        byte[] cipher = withCipher(right, new byte[HELP.length()]);
        assertRefused(asked("SUPP", HELP).unheard("police", cipher), "opens under none of the 1 keys");
        assertRefused(
                asked("SUHO", HELP).unheard("police", Talk.PAIR.seal("SUHO", "SUPO", HexFormat.of().parseHex(FIRST),
                        utf8(HELP))),
                "and no key was given for SUPO and SUHO");
        assertRefused(
                asked("//SU", HELP).unheard("police", Talk.PAIR.seal("//SU", "SUPO", HexFormat.of().parseHex(FIRST),
                        utf8(HELP))),
                "opens under none of the 1 keys for it");
    }

    @Test
    void plaintextOnTheAir_isRefusedByName() {
        byte[] right = sealed("SUPP", FIRST, HELP);
        assertRefusedEvenWithoutKeys(asked("SUPP", HELP).unheard("police", withCipher(right, utf8(HELP))),
                "police sends a message to SUPP in the clear: 'tell;help'; expected it sealed");
        byte[] plain = SharedKey.join(SharedKey.header("SUPP", "SUPO", 14), utf8(HELP), new byte[5]);
        assertRefusedEvenWithoutKeys(asked("SUPP", HELP).unheard("police", plain), "in the clear");
        byte[] first = BEGIN.clone();
        System.arraycopy(utf8(LONG), 0, first, Frame.HEADER + Frame.CONTENT, 51);
        assertRefusedEvenWithoutKeys(asked("SUPP", LONG).unheard("police", first), "in the clear");
    }

    @Test
    void sizes_thatDoNotFit_areRefusedByName() {
        byte[] right = sealed("SUPP", FIRST, HELP);
        Talk talk = asked("SUPP", HELP).unheard("police", changed(right, 9));
        talk.last().addProperty("kind", "unicast");
        assertRefusedEvenWithoutKeys(talk,
                "police's packet is told with the kind 'unicast'; expected 'no frame', as its "
                        + "bytes say: the size");
        assertRefusedEvenWithoutKeys(asked("SUPP", HELP).unheard("police", sealed("SUPP", FIRST, HELP + "!")),
                "with a content of 10 bytes; expected 9");
        byte[] small = SharedKey.join(SharedKey.header("SUPP", "SUPO", 13), new byte[13]);
        assertRefusedEvenWithoutKeys(asked("SUPP", HELP).unheard("police", small), "no room for nonce and tag");
    }

    @Test
    void fields_thatTheBytesDoNotSay_areRefused() {
        for (Map.Entry<String, String> field : Map.of("destination", "SUHO", "origin", "SUHO", "kind", "multicast")
                .entrySet()) {
            Talk talk = asked("SUPP", HELP).unheard("police", sealed("SUPP", FIRST, HELP));
            talk.last().addProperty(field.getKey(), field.getValue());
            assertRefusedEvenWithoutKeys(talk, field.getKey() + " '" + field.getValue() + "'; expected '");
        }
        for (Map.Entry<String, Object> field : Map.<String, Object>of("id", 1, "index", 2, "asks", "true").entrySet()) {
            Talk talk = asked("SUPP", LONG).unheard("police", BEGIN);
            talk.last().addProperty(field.getKey(), "" + field.getValue());
            assertRefusedEvenWithoutKeys(talk, "the " + field.getKey() + " '" + field.getValue() + "'; expected '");
        }
    }

    @Test
    void broadcast_thatSaysAnotherThing_isRefusedByName() {
        assertRefusedEvenWithoutKeys(asked("////", HELP).unheard("police", broadcast("tell;halp")),
                "police sends a message to //// that says 'tell;halp'; expected 'tell;help'");
        byte[] whole = broadcast(LONG);
        assertRefusedEvenWithoutKeys(asked("////", LONG).sends("police", fragment("AA", whole, 0))
                .unheard("police", changed(fragment("AB", whole, 1), -1)),
                "sends other bytes as fragment 1 of SUPO to ////");
        assertRefusedEvenWithoutKeys(asked("////", LONG).unheard("police", fragment("AI", whole, 0)),
                "a wish for an answer, though to many");
        assertRefusedEvenWithoutKeys(
                asked("////", LONG).sends("police", fragment("AA", whole, 0)).unheard("police",
                        fragment("AJ", whole, 1)),
                "police asks for an answer to a fragment of a message to many");
    }

    @Test
    void fragments_thatAreNotTheFramesSlices_areRefusedByName() {
        assertRefused(asked("SUPP", LONG).unheard("police", changed(BEGIN, -1)),
                "that opens under none of the 1 keys for it");
        assertRefused(asked("SUPP", LONG).sends("police", BEGIN).unheard("police", changed(END, 20)),
                "police sends other bytes as fragment 1 of SUPO to SUPP, nonce 000001000000; expected those of the "
                        + "whole");
        assertRefused(asked("SUPP", LONG).sends("police", BEGIN).unheard("police", withZeros(END, Payload.TAG_LENGTH)),
                "sends other bytes as fragment 1");
        byte[] shorter = SharedKey.join(SharedKey.header("+FAJ", "SUPO", 2), new byte[2]);
        assertRefusedEvenWithoutKeys(asked("SUPP", LONG).sends("police", BEGIN).unheard("police", shorter),
                "sends other bytes as fragment 1");
        assertRefusedEvenWithoutKeys(
                asked("SUPP", LONG).sends("police", BEGIN).unheard("police", fragment("AK", LONG_FRAME, 1)),
                "sends other bytes as fragment 2");
        assertRefusedEvenWithoutKeys(
                asked("SUPP", HELP).unheard("police", fragment("AA", sealed("SUPP", FIRST, HELP), 0)),
                "sends a fragment with a frame that fits one packet");
    }

    @Test
    void message_thatWasReportedUndelivered_isNotSentInPlaceOfTheNext() {
        Talk talk = asked("SUPP", HELP).asks("SUPP", LONG);
        talk.lines.add(4, "police", "host-outcome", Map.of("number", 0, "outcome", "undelivered"));
        assertRefusedEvenWithoutKeys(talk.pauses(1).unheard("police", sealed("SUPP", FIRST, HELP)),
                "police sends a message to SUPP under nonce 000001000000 with a content of 9 bytes; expected 75");
    }

    @Test
    void fragments_ofAnAttempt_areSentInOrder() {
        byte[] frame = sealed("SUPP", FIRST, "tell;" + "x".repeat(200));
        Talk talk = asked("SUPP", "tell;" + "x".repeat(200)).sends("police", fragment("AA", frame, 0))
                .unheard("police", fragment("AC", frame, 2));
        assertAccepted(talk, "1 messages opened, 0 proofs");
        assertRefusedEvenWithoutKeys(talk.unheard("police", fragment("AB", frame, 1)),
                "police sends fragment 1 of SUPO to SUPP, nonce 000001000000 after fragment 2");
        Talk again = asked("SUPP", "tell;" + "x".repeat(200)).sends("police", fragment("AA", frame, 0))
                .sends("police", fragment("AL", frame, 3)).unheard("police", fragment("AI", frame, 0));
        assertAccepted(again, "1 messages opened, 0 proofs");
    }

    @Test
    void fragments_ofAMessageToMany_beginAgainAfterTheLast() {
        byte[] whole = sealed("//SU", FIRST, LONG);
        Talk talk = asked("//SU", LONG).sends("police", fragment("AA", whole, 0))
                .unheard("police", fragment("AB", whole, 1))
                .unheard("police", fragment("AA", whole, 0));
        assertAccepted(talk, "1 messages opened, 0 proofs");
        assertRefusedEvenWithoutKeys(talk.unheard("police", fragment("AA", whole, 0)),
                "police sends fragment 0 of SUPO to //SU, nonce 000001000000 after fragment 0");
    }

    @Test
    void fragments_ofTheNextFrame_haveTheNextId() {
        byte[] next = sealed("//SU", SECOND, LONG);
        for (String id : List.of("A", "B", "C", "/")) {
            Talk talk = asked("SUPP", LONG).asks("//SU", LONG).sends("police", BEGIN)
                    .unheard("police", fragment("AJ", LONG_FRAME, 1))
                    .unheard("police", fragment(id + "A", next, 0));
            if (id.equals("B")) {
                assertAccepted(talk, "2 messages opened, 0 proofs");
            } else {
                assertRefusedEvenWithoutKeys(talk, id.equals("A") ? "" : "police cuts a frame into fragments with id ");
            }
        }
        Talk last = asked("SUPP", LONG).asks("//SU", LONG).sends("police", fragment("/A", LONG_FRAME, 0))
                .unheard("police", fragment("/J", LONG_FRAME, 1));
        assertAccepted(last.unheard("police", fragment("AA", next, 0)), "2 messages opened, 0 proofs");
    }

    @Test
    void nonce_thatDoesNotRise_isRefusedWhateverTheDestination() {
        Talk again = asked("//SU", HELP).asks("SUPP", HELP).sends("police", sealed("//SU", FIRST, HELP));
        assertRefusedEvenWithoutKeys(again.unheard("police", sealed("SUPP", FIRST, HELP)),
                "police sends other bytes under the nonce of an earlier message; expected: SUPO to //SU, nonce 000001");
        Talk lower = asked("//SU", HELP).asks("SUPP", HELP).sends("police", sealed("//SU", SECOND, HELP));
        assertRefusedEvenWithoutKeys(lower.unheard("police", sealed("SUPP", FIRST, HELP)),
                "seals a message to SUPP under nonce 000001000000; expected one above 000001000001");
    }

    @Test
    void epoch_thatDoesNotRiseWithABoot_isRefused() {
        assertRefusedEvenWithoutKeys(new Talk().resets("police", "watchdog").greets("police", "SUPO", "000001"),
                "police says that it has epoch 000001; expected 000002 or a later one, since it was reset");
        assertRefusedEvenWithoutKeys(new Talk().greets("police", "SUPO", "000000"),
                "expected 000001 or a later one, since it has had that");
        Talk same = new Talk().resets("police", "power").asks("SUPP", HELP);
        assertRefusedEvenWithoutKeys(same.unheard("police", sealed("SUPP", FIRST, HELP)),
                "police seals under epoch 000001; expected 000002");
        assertRefusedEvenWithoutKeys(asked("SUPP", HELP).unheard("police", sealed("SUPP", "000002000000", HELP)),
                "police seals under epoch 000002; expected 000001, as it has told its host");
        assertAccepted(new Talk().resets("police", "power").greets("police", "SUPO", "000002").asks("SUPP", HELP)
                .sends("police", sealed("SUPP", "000002000000", HELP)), "1 messages opened, 0 proofs");
    }

    @Test
    void epoch_thatIsLost_sealsNothingUntilItIsRaisedAboveAllBefore() {
        Talk lost = new Talk().resets("police", "power").greets("police", "SUPO", "000000").asks("SUPP", HELP);
        assertAccepted(lost, "0 messages opened, 0 proofs");
        assertRefusedEvenWithoutKeys(lost.unheard("police", sealed("SUPP", "000002000000", HELP)),
                "police seals under epoch 000002; expected 000000, as it has told its host");
        assertRefusedEvenWithoutKeys(new Talk().resets("police", "power").greets("police", "SUPO", "000000")
                .greets("police", "SUPO", "000001"), "expected 000002 or a later one, since it was reset");
        assertAccepted(new Talk().resets("police", "power").greets("police", "SUPO", "000000")
                .greets("police", "SUPO", "061a80").asks("SUPP", HELP)
                .sends("police", sealed("SUPP", "061a80000000", HELP)), "1 messages opened, 0 proofs");
    }

    private static Talk delivered() {
        return asked("SUPP", HELP).sends("police", sealed("SUPP", FIRST, HELP)).hands(0, FIRST, HELP);
    }

    @Test
    void proof_thatIsWrong_isRefusedByName() {
        byte[] right = acknowledgement(FIRST, "");
        for (byte[] wrong : List.of(changed(right, -1), withZeros(right, Payload.TAG_LENGTH),
                SharedKey.join(acknowledgement("000002000000", "")))) {
            assertRefused(delivered().unheard("support", wrong),
                    "support acknowledges with a wrong proof; expected that of SUPO to SUPP, nonce 000001000000");
        }
        assertRefusedEvenWithoutKeys(delivered().unheard("support", acknowledgement(SECOND, "")),
                "support acknowledges");
    }

    @Test
    void parity_isAskedForOnlyAfterATrailer() {
        for (boolean trailer : List.of(true, false)) {
            Talk talk = asked("SUPP", HELP).sends("police", sealed("SUPP", FIRST, HELP));
            if (trailer) {
                JsonObject sent = talk.lines.all.get(talk.lines.all.size() - 2);
                sent.addProperty("trailer", "mark");
                sent.addProperty("bits", sent.get("bits").getAsInt() + 12);
            }
            talk.hands(0, FIRST, HELP).unheard("support", acknowledgement(FIRST, "", true));
            if (trailer) {
                assertAccepted(talk, "1 messages opened, 1 proofs");
            } else {
                assertRefused(talk, "support asks for parity (SUPO to SUPP, nonce 000001000000); expected that a "
                        + "packet with a trailer comes first");
            }
        }
    }

    @Test
    void fragments_thatABoardCannotHave_areRefusedByName() {
        byte[] first = fragment("AI", LONG_FRAME, 0);
        Talk one = asked("SUPP", LONG).sends("police", BEGIN).unheard("police", END).sends("police", first);
        assertRefused(one.unheard("support", changed(acknowledgement(FIRST, "01"), Frame.HEADER)), "wrong proof");
        for (String told : List.of("00", "01", "02", "03", "05", "81")) {
            Talk talk = asked("SUPP", LONG).sends("police", BEGIN).unheard("police", END).sends("police", first)
                    .unheard("support", acknowledgement(FIRST, told));
            if (told.equals("01")) {
                assertAccepted(talk, "1 messages opened, 1 proofs");
            } else {
                assertRefusedEvenWithoutKeys(talk,
                        "support answers that it has the fragments " + told + " of SUPO to SUPP, nonce 000001000000; "
                                + "expected 01 or fewer, with the first");
            }
        }
    }

    /** A board that was reset begins to count ids anew. Of two nonces with the same end only the proof tells. */
    @Test
    void fragments_ofAnOlderFrameWithTheSameId_areNotThoseOfTheNext() {
        String nonce = "000002000000";
        byte[] next = sealed("SUPP", nonce, LONG);
        Talk talk = asked("SUPP", LONG).sends("police", BEGIN).sends("police", END).resets("police", "power")
                .pauses(10).greets("police", "SUPO", "000002").asks("SUPP", LONG)
                .sends("police", fragment("AA", next, 0)).unheard("police", fragment("AJ", next, 1))
                .sends("police", fragment("AI", next, 0));
        assertRefused(talk.unheard("support", acknowledgement(nonce, "03")),
                "support answers that it has the fragments 03 of SUPO to SUPP, nonce 000002000000;"
                        + " expected 01 or fewer");
    }

    @Test
    void fragments_ofOneFrameUnderAnotherId_areRefused() {
        assertRefusedEvenWithoutKeys(
                asked("SUPP", LONG).sends("police", BEGIN).unheard("police", fragment("BA", LONG_FRAME, 0)),
                "police sends other bytes under the nonce of an earlier message");
    }

    @Test
    void handed_thoughAFirstFragmentWasForged_isOnlyWhatWasSaid() {
        for (String content : List.of(LONG, LONG + "y")) {
            Talk talk = asked("SUPP", LONG).sends("police", BEGIN).sends("injector", changed(BEGIN, -1))
                    .sends("police", END).hands(0, FIRST, content);
            if (content.equals(LONG)) {
                assertAccepted(talk, "1 messages opened, 0 proofs");
            } else {
                assertTrue(talk.verdict().contains("support hands its host '"), talk.verdict());
            }
        }
    }

    /** Nothing proves a broadcast: a fragment of it may be anybody's. */
    @Test
    void handed_broadcastOfWhichAFragmentWasForged_mayBeAnything() {
        byte[] whole = broadcast(LONG);
        for (boolean isForged : List.of(true, false)) {
            Talk talk = asked("////", LONG).sends("police", fragment("AA", whole, 0)).sends("injector",
                    isForged ? changed(fragment("AB", whole, 1), -1) : fragment("AB", whole, 1))
                    .sends("police", fragment("AB", whole, 1));
            talk.lines.add(9, "support", "host-handed",
                    Map.of("number", 0, "destination", "////", "origin", "SUPO", "id", "000000", "content",
                            LONG + "y"));
            if (isForged) {
                assertAccepted(talk, "0 messages opened, 0 proofs");
            } else {
                assertTrue(talk.verdict().contains("support hands its host '"), talk.verdict());
            }
        }
    }

    /** Its board's own fragment is what it is, though the injector has sent another one before. */
    @Test
    void broadcast_ofWhichNobodyKnowsWhatItSays_isItsBoards() {
        byte[] whole = broadcast(LONG);
        Talk talk = asked("////", LONG);
        talk.last().remove("content");
        talk.sends("police", fragment("AA", whole, 0)).sends("injector", changed(fragment("AB", whole, 1), -1))
                .sends("police", fragment("AB", whole, 1));
        assertTrue(talk.lines.replay().refusal().isEmpty(), talk.lines.replay()::verdict);
    }

    /** Only the whole frame tells that a fragment is forged. */
    @Test
    void acknowledgement_ofAForgedFragmentOfWhatWasTaken_isAccepted() {
        Talk talk = asked("SUPP", LONG).sends("police", BEGIN).sends("police", END).hands(0, FIRST, LONG)
                .sends("support", acknowledgement(FIRST, ""))
                .sends("injector", changed(fragment("AI", LONG_FRAME, 0), -1))
                .sends("support", acknowledgement(FIRST, "")).sends("support", acknowledgement(FIRST, ""));
        assertAccepted(talk, "1 messages opened, 3 proofs");
    }

    /** The support has lost its memory after a message, and then is sent it again. */
    private static Talk lost() {
        return delivered().resets("support", "power").pauses(10).greets("support", "SUPP", "000002").pauses(20)
                .sends("police", sealed("SUPP", FIRST, HELP));
    }

    /** Two notices within the tenth by which a board's clock may be wrong. */
    @ParameterizedTest
    @CsvSource({"00d2, 00dc, ''", "00dc, 00dc, ''",
            "00dc, 00db, says that it has been up for 21.9 s; expected no less"})
    void stale_withAnUptimeBelowThatOfTheNoticeBefore_isRefused(String first, String second, String words) {
        Talk talk = lost().unheard("support", acknowledgement(FIRST, "00000100001f" + first))
                .sends("police", sealed("SUPP", FIRST, HELP))
                .unheard("support", acknowledgement(FIRST, "00000100001f" + second));
        assertTrue(words.isEmpty() ? talk.verdict().contains("accepted") : talk.verdict().contains(words),
                talk.verdict());
    }

    @ParameterizedTest
    @CsvSource({"00000100001f, 00d2, ''", "000001000000, 00d2, ''", "000001000020, 00d2, tells the floor 000001000020",
            "000000ffffff, 00d2, tells the floor 000000ffffff", "00000100001f, 0000, been up for 0.0 s",
            "00000100001f, ffff, been up for 6553.5 s"})
    void stale_withAFloorOrUptimeThatCannotBe_isRefusedByName(String floor, String uptime, String words) {
        Talk talk = lost().unheard("support", acknowledgement(FIRST, floor + uptime));
        if (words.isEmpty()) {
            assertAccepted(talk, "1 messages opened, 1 proofs");
        } else {
            assertRefusedEvenWithoutKeys(talk, words);
        }
    }

    @Test
    void sealedAnew_onlyIfItWasStale() {
        byte[] anew = sealed("SUPP", "000001000020", HELP);
        Talk stale = lost().sends("support", acknowledgement(FIRST, "00000100001f00d2")).sends("police", anew);
        assertAccepted(stale, "2 messages opened, 1 proofs");
        assertRefusedEvenWithoutKeys(delivered().unheard("police", anew), "refused at");
    }

    /** A notice that answers an attacker seems to be about the first message, and the second to be that sealed anew. */
    @Test
    void sealedAnew_withoutKeys_isAcceptedWhicheverItIs() {
        Talk talk = delivered().sends("support", acknowledgement(FIRST, "")).resets("support", "power").pauses(10)
                .greets("support", "SUPP", "000002").pauses(20)
                .sends("injector", sealed("SUPP", FIRST, HELP))
                .unheard("support", acknowledgement(FIRST, "00000100001f00d2"))
                .asks("SUPP", "tell;helq").asks("//SU", HELP).sends("police", sealed("SUPP", SECOND, "tell;helq"))
                .sends("support", acknowledgement(SECOND, "00000100001f0100"))
                .sends("police", sealed("//SU", "000001000021", HELP))
                .sends("police", sealed("//SU", "000001000021", HELP))
                .sends("police", sealed("SUPP", "000001000020", "tell;helq"));
        assertEquals("model: trace accepted (" + talk.lines.all.size() + " events)", talk.verdictWithoutKeys());
    }

    @Test
    void stale_ofAMessageThatANewerOneHadOvertakenBeforeAllWasForgotten_isAccepted() {
        byte[] frame = sealed("SUPP", FIRST, HELP);
        Talk talk = delivered().sends("support", acknowledgement(FIRST, "")).asks("SUPP", HELP)
                .sends("police", sealed("SUPP", SECOND, HELP)).hands(1, SECOND, HELP)
                .sends("support", acknowledgement(SECOND, "")).resets("support", "power").pauses(10)
                .greets("support", "SUPP", "000002").pauses(20).sends("injector", frame)
                .sends("support", acknowledgement(FIRST, "00000100001f00d2"));
        assertAccepted(talk, "2 messages opened, 3 proofs");
    }

    @Test
    void handed_anotherContentThanWasSent_isRefusedByName() {
        byte[] frame = sealed("SUPP", FIRST, HELP);
        Talk talk = asked("SUPP", HELP).sends("police", frame);
        JsonObject handed = new Talk().hands(0, FIRST, "tell;halp").lines.all.get(4);
        handed.addProperty("t", 6);
        talk.lines.all.add(handed);
        assertRefusedEvenWithoutKeys(talk, "support hands its host 'tell;halp' from SUPO; expected 'tell;help'");
    }

    @Test
    void handed_ofTwoThatAreAsLong_isToldApartByKeysOnly() {
        Talk talk = asked("SUPP", "tell;fire").asks("SUPP", HELP).sends("police", sealed("SUPP", FIRST, HELP)).hands(0,
                FIRST, HELP);
        assertAccepted(talk, "1 messages opened, 0 proofs");
    }

    @Test
    void handed_broadcastWithAnId_isRefused() {
        Talk talk = asked("////", HELP).sends("police", broadcast(HELP));
        talk.lines.add(7, "support", "host-handed",
                Map.of("number", 0, "destination", "////", "origin", "SUPO", "id", "000000", "content", HELP));
        assertAccepted(talk, "0 messages opened, 0 proofs");
        talk.last().addProperty("id", "000001");
        assertRefusedEvenWithoutKeys(talk, "support hands its host 'tell;help' from SUPO; expected nothing");
    }

    /** A board without a host, of which nobody has said who it is. */
    @Test
    void injector_maySendAnything_butAForgeryIsNeverHanded() {
        byte[] right = sealed("SUPP", FIRST, HELP);
        byte[] header =
                SharedKey.join(SharedKey.header("+FAA", "SUPO", Frame.HEADER), SharedKey.header("SUPP", "SUPO", 200));
        for (byte[] any : List.of(changed(right, -1), header, new byte[] {1, 2, 3}, BEGIN, changed(END, -1),
                acknowledgement(SECOND, ""), SharedKey.join(SharedKey.header("SUPP", "SUPO", 13), new byte[13]))) {
            assertAccepted(new Talk().sends("thief", any), "0 messages opened, 0 proofs");
        }
        assertAccepted(asked("SUPP", HELP).unheard("police", right).sends("thief", right).hands(0, FIRST, HELP),
                "1 messages opened, 0 proofs");
        Talk another = new Talk().sends("thief", Talk.PAIR.seal("SUPP", "CAFE", HexFormat.of().parseHex(FIRST),
                utf8(HELP)));
        another.lines.add(6, "support", "host-handed", Map.of("number", 0, "destination", "SUPP", "origin", "CAFE",
                "id", "010000", "content", HELP));
        assertTrue(another.verdictWithoutKeys().contains("accepted"), another.verdictWithoutKeys());
        assertRefused(another, "support hands its host 'tell;help' from CAFE; expected nothing that any key opens");
    }

    @Test
    void message_thatItsHostDoesNotWant_isRefused() {
        assertRefusedEvenWithoutKeys(asked("SUPP", HELP).unheard("police", sealed("//SU", FIRST, HELP)),
                "expected that its host asks for it first");
        Talk order = asked("SUPP", HELP).asks("SUPP", "tell;fire").sends("police", sealed("SUPP", FIRST, "tell;fire"));
        assertRefused(order.unheard("police", sealed("SUPP", SECOND, HELP)), "");
    }

    @ParameterizedTest
    @CsvSource({"highway, '7 messages opened, 5 proofs'", "fragments, '3 messages opened, 4 proofs'",
            "partners, '10 messages opened, 6 proofs'", "relays, '3 messages opened, 3 proofs'"})
    @Tag("soak")
    void genuineTrace_withItsKeys_isAcceptedHoweverEarlyItEnds(String name, String checked) {
        Lines lines = Lines.of(name);
        assertEquals("model: trace accepted (" + lines.all.size() + " events, " + checked + ")",
                lines.replayWithKeys(name).verdict());
        for (int end = 1; end <= lines.all.size(); end++) {
            int last = end;
            String verdict = lines.without(line -> line > last).replayWithKeys(name).verdict();
            assertTrue(verdict.contains("accepted"), verdict);
        }
    }

    /** Each packet that a board sends, with one bit changed, wherever it is heard. */
    @ParameterizedTest
    @ValueSource(strings = {"highway", "fragments", "partners", "relays"})
    @Tag("soak")
    void genuineTrace_withAChangedBit_isRefusedThere(String name) {
        Random random = new Random(1);
        for (int line : Lines.of(name).where(each -> Lines.of(name).is(each, "rf-tx"))) {
            for (int time = 0; time < 4; time++) {
                Lines lines = Lines.of(name);
                String payload = lines.text(line, "payload");
                byte[] bytes = HexFormat.of().parseHex(payload);
                int bit = random.nextInt(8 * bytes.length);
                bytes[bit / 8] ^= (byte) (1 << bit % 8);
                double start = lines.get(line).get("start").getAsDouble();
                lines.where(each -> lines.text(each, "payload").equals(payload)
                        && Math.abs(lines.get(each).get("start").getAsDouble() - start) < 0.01)
                        .forEach(each -> lines.get(each).addProperty("payload", HexFormat.of().formatHex(bytes)));
                String verdict = lines.replayWithKeys(name).verdict();
                assertTrue(verdict.startsWith("model: trace refused at event " + line + " ("),
                        name + ", bit " + bit + " of line " + line + ": " + verdict);
            }
        }
    }
}
