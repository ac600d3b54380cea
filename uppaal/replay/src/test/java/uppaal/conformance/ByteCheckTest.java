package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Packets that boards must not put on the air, by scripts of {@link TestTrace}: the last step is refused. */
class ByteCheckTest {
    private static final String ASKED = "police asks SUPP help; police seals 0; ";
    private static final String SENT = ASKED + "police sends 0 s:SUPP:0:help; ";
    private static final String TAKEN = SENT + "support queues 0; support hands 0 SUPP 010000 help; ";
    private static final String DELIVERED = TAKEN + "support answers DELIVERED a:0:; ";
    private static final String LONG = "police asks SUPP LONG; police seals 0; ";
    private static final String BEGUN = LONG + "police parts 0 f:AA:s:SUPP:0:LONG; ";
    private static final String ASKING = BEGUN + "police sends 0 f:AJ:s:SUPP:0:LONG; ";
    /** Its receiver has lost its memory before, and some time ago. */
    private static final String LATE = "support boots 000002; " + SENT;
    private static final String STALE = SENT + "support boots 000002; police sends 0 s:SUPP:0:help; ";
    private static final Map<String, String> BEGINNINGS = Map.of("ASKED", ASKED, "SENT", SENT, "TAKEN", TAKEN,
            "DELIVERED", DELIVERED, "LONG", LONG, "BEGUN", BEGUN, "ASKING", ASKING, "STALE", STALE, "LATE", LATE);

    private static TestTrace trace(String script) {
        String[] parts = script.split("; ", 2);
        return new TestTrace(BEGINNINGS.containsKey(parts[0])
                ? BEGINNINGS.get(parts[0]) + (parts.length > 1 ? parts[1] : "") : script);
    }

    private static String shown(TestTrace trace) {
        return trace.verdict(ByteCheck::new) + "; without keys: " + trace.verdictWithoutKeys(ByteCheck::new);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "DELIVERED; police DELIVERED number=0 | 1, 1",
            "TAKEN; support OWE_DELIVERED nonce=0 key=0; support answers nothing a:0:; "
                    + "support answers nothing a:0: | 1, 2",
            "TAKEN; police sends 0 s:SUPP:0:help + mark; support answers DELIVERED p:0:; "
                    + "police sends 0 s:SUPP:0:help + parity | 1, 1",
            "police asks //SU help; police seals 0 1; police sends 0 s://SU:0:help; "
                    + "police sends 0 s://SU:0:help | 1, 0",
            "police asks //// help; police seals 0 255; police sends 0 b:help | 0, 0",
            "ASKING; police sends 0 f:AI:s:SUPP:0:LONG; support answers FRAGMENTS a:0:01; "
                    + "police FRAGMENTS_NEW number=0 "
                    + "have=1; police sends 0 f:AJ:s:SUPP:0:LONG | 1, 1",
            "ASKING; police sends 0 f:AI:s:SUPP:0:LONG; support answers !FRAGMENTS a:0:03 | 1, 1",
            // Ids, nonces and epochs go on.
            "BEGUN; police asks //SU LONG; police seals 1 1; police parts 1 f:BA:s://SU:1:LONG | 2, 0",
            "LONG; police parts 0 f:/A:s:SUPP:0:LONG; police asks //SU LONG; police seals 1 1; "
                    + "police parts 1 f:AA:s://SU:1:LONG | 2, 0",
            "police boots 000002; police asks SUPP help; police seals 0; "
                    + "police sends 0 s:SUPP:000002000000:help | 1, 0",
            "police boots 061a80; police asks SUPP help; police seals 0; "
                    + "police sends 0 s:SUPP:061a80000000:help | 1, 0",
            "police does reset why=power; police does host-id id=SUPO epoch=000000 | 0, 0",
            "ASKED; police asks //SU help; police seals 1 1; police sends 1 s://SU:1:help; "
                    + "police sends 0 s:SUPP:0:help | 2, 0",
            // A stale message is sealed anew above the floor.
            "LATE; support answers STALE a:0:00000100001f0029; police STALE_HEARD number=0; "
                    + "police RESEAL number=0 key=0; police sends 0 s:SUPP:20:help | 2, 1",
            "STALE; support answers STALE a:0:00000100001f0015; police sends 0 s:SUPP:0:help; "
                    + "support answers STALE a:0:00000100001f002b | 1, 2",
            // With a group's key two senders may have nonces that end alike.
            "STALE; support OWE_STALE nonce=0 key=0; support answers STALE a:0:00000100001f001f; "
                    + "support answers nothing a:0:00000100001f002a | 1, 2",
            // Others may send anything.
            "thief throws s:SUPP:0:help~-1; thief throws x:010203; thief throws f:AA:s:SUPP:0:LONG; "
                    + "thief throws a:1: | 0, 0",
            "SENT; thief throws s:SUPP:0:help; support hands 0 SUPP 010000 help | 1, 0",
            "BEGUN; thief throws f:AA:s:SUPP:0:LONG~-1; police sends 0 f:AJ:s:SUPP:0:LONG; "
                    + "support hands 0 SUPP 010000 LONG | 1, 0",
            // Nothing proves a fragment of a broadcast.
            "police asks //// LONG; police seals 0 255; police parts 0 f:AA:b:LONG; thief throws f:AB:b:LONG~-1; "
                    + "police sends 0 f:AB:b:LONG; support hands 0 //// 000000 LONGy | 0, 0",
    })
    void genuine_isAcceptedAndCounted(String script, String counts) {
        TestTrace trace = trace(script);
        String[] count = counts.split(", ");
        assertEquals("model: trace accepted (" + trace.lines.size() + " events, " + count[0] + " messages opened, "
                + count[1] + " proofs)", trace.verdict(ByteCheck::new));
        assertEquals("model: trace accepted (" + trace.lines.size() + " events)",
                trace.verdictWithoutKeys(ByteCheck::new));
    }

    /** Those that end with a {@code *} need keys. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            // Cipher and tag.
            "ASKED; police sends 0 s:SUPP:0:help~-1 | SUPO to SUPP, nonce 000001000000, as no known key seals it *",
            "ASKED; police sends 0 s:SUPP:0:help~16 | as no known key seals it; expected 'help' *",
            "ASKED; police sends 0 s:SUPP:0:halp | as no known key seals it; expected 'help' *",
            "ASKED; police sends 0 s:SUPP:0:helps | of 29 bytes; expected 28 in one packet",
            "ASKED; police sends 0 s://SU:0:help | police sends a multicast, SUPO to //SU, "
                    + "nonce 000001000000, of 28 bytes; expected one from [SUPO] to SUPP",
            "police asks SUHO help; police seals 0; police sends 0 s:SUHO:0:help"
                    + " | SUPO to SUHO, nonce 000001000000, as no known key seals it *",
            "ASKED; police sends 0 b:help | police sends a broadcast, SUPO to ////, of 14 bytes; expected one from",
            "police asks //// help; police seals 0; police sends 0 b:help"
                    + " | police sends a message that it has sealed without a nonce",
            "ASKED; police sends 0 c:SUPP:0:help"
                    + " | SUPO to SUPP, nonce 000001000000 in the clear: 'help'; expected it s",
            "LONG; police parts 0 f:AA:c:SUPP:0:LONG | in the clear",
            // So short a content may look as before by chance.
            "police asks SUPP hi; police seals 0; police sends 0 c:SUPP:0:hi | as no known key seals it *",
            "police asks SUPP hey; police seals 0; police sends 0 c:SUPP:0:hey | in the clear: 'hey'",
            "ASKED; police sends 0 x:535550505355504f426f00000000000000000000000000"
                    + " | of 23 bytes; expected 28 in one packet",
            "police asks //// help; police seals 0 255; police sends 0 b:halp | that says 'halp'; expected 'help'",
            "LONG; police parts 0 f:AA:s:SUPP:0:LONG~-1 | as no known key seals it *",
            // Fragments.
            "BEGUN; police sends 0 f:AJ:s:SUPP:0:LONG~20"
                    + " | other bytes as fragment 1 of SUPO to SUPP, nonce 0000010000*",
            "BEGUN; police sends 0 f:AK:s:SUPP:0:LONG | police sends other bytes as fragment 2",
            "BEGUN; police sends 0 f:BJ:s:SUPP:0:LONG | police sends other bytes as fragment 1",
            "BEGUN; police sends 0 f:AJ:s:SUPP:0:LONG~7 | police sends other bytes as fragment 1",
            "BEGUN; police sends 0 f:AB:s:SUPP:0:LONG"
                    + " | fragment 1 of SUPO to SUPP, nonce 000001000000 and does not ask",
            "LONG; police parts 0 f:AI:s:SUPP:0:LONG | fragment 0 of SUPO to SUPP, nonce 000001000000 and asks for an",
            "LONG; police parts 0 f:AB:s:SUPP:0:LONG | sends fragment 1 of a message first; expected fragment 0",
            "ASKED; police sends 0 f:AI:s:SUPP:0:help | sends a fragment, "
                    + "SUPO to SUPP, nonce 000001000000, of 28 bytes; expected 28 in one packet",
            "LONG; police sends 0 s:SUPP:0:LONG | expected 103 in fragments of 67",
            "police asks //// LONG; police seals 0 255; police sends 0 f:AI:b:LONG | and asks for an answer",
            "BEGUN; police asks //SU LONG; police seals 1 1; police parts 1 f:AA:s://SU:1:LONG | with id 0; expected 1",
            "BEGUN; police asks //SU LONG; police seals 1 1; police parts 1 f:CA:s://SU:1:LONG | with id 2; expected 1",
            "police does host-relay number=0 payload=00 asked=3; police seals 0 255; police sends 0 b:help"
                    + " | expected the bytes that its host wants to be relayed",
            // Nonces and epochs.
            "police asks SUPP help; police sends 0 s:SUPP:0:help | declares SEND of message 0; expected TAKE_UP first",
            "ASKED; police sends 0 s:SUPP:1:help | under nonce 000001000001; expected 000001000000, the next one",
            "SENT; police asks //SU help; police seals 1 1; police sends 1 s://SU:0:help"
                    + " | to //SU under nonce 000001000000; expected 000001000001",
            "ASKED; police sends 0 s:SUPP:000002000000:help | under nonce 000002000000; "
                    + "expected 000001000000",
            "SENT; police sends 0 s:SUPP:0:halp | police sends other bytes as SUPO to SUPP, nonce 000001000000",
            "police does reset why=power; police does host-id id=SUPO epoch=000001 | says that it has epoch 000001",
            "police does reset why=power; police asks SUPP help; police seals 0"
                    + " | expected that it stores an epoch before",
            "police boots 000001 | police declares an epoch stored that ends in 1; "
                    + "expected two whole records of it, above 000001",
            "police does host-id id=SUPO epoch=000000 | says that it has epoch 000000; expected 000001, as stored",
            "police EPOCH_STORED low=2 | declares an epoch stored that ends in 2; expected two whole records",
            "police boots 000002; police does host-id id=SUPO epoch=000001 | epoch 000001; expected 000002, as stored",
            "STALE; support answers STALE a:0:00000100001f0015; police STALE_HEARD number=0; "
                    + "police RESEAL number=0 key=0 | police seals message 0 anew; expected that its receiver",
            "LATE; support answers STALE a:0:00000100001f0029; police STALE_HEARD number=0; "
                    + "police RESEAL number=0 key=0; police sends 0 s:SUPP:000002000020:help | or one above a floor",
            // Answers.
            "TAKEN; support answers DELIVERED a:0:~-1 | with a wrong proof; "
                    + "expected that of SUPO to SUPP, nonce 0000010*",
            "TAKEN; support answers DELIVERED a:000002000000: | with a wrong proof *",
            "TAKEN; support answers DELIVERED a:1: | acknowledges a nonce that ends in 001; "
                    + "expected that of a message to",
            "police asks //SU help; police seals 0 1; police sends 0 s://SU:0:help; support answers DELIVERED a:0:"
                    + " | acknowledges a nonce that ends in 000; expected that of a message to it",
            "TAKEN; support answers FRAGMENTS a:0: | acknowledges delivered of a nonce that ends in 00; "
                    + "expected what it owes: [fragments of a nonce that ends in 00]",
            "TAKEN; support answers nothing a:0: | delivered of a nonce that ends in 00; expected what it owes: []",
            "TAKEN; support answers DELIVERED p:0:"
                    + " | support asks for parity of SUPO to SUPP, nonce 000001000000; expec *",
            "BEGUN; support answers FRAGMENTS a:0:00 | has the fragments 00 of SUPO to SUPP, nonce 000001000000",
            "BEGUN; support answers FRAGMENTS a:0:03 | has the fragments 03 of SUPO to SUPP, nonce 000001000000; expec",
            "ASKING; support answers FRAGMENTS a:0:05 | has the fragments 05",
            "ASKING; support answers FRAGMENTS a:0:03 | has the fragments 03",
            "ASKING; police boots 000002; police asks SUPP LONG; police seals 0; "
                    + "police parts 0 f:AA:s:SUPP:000002000000:LONG; "
                    + "support answers FRAGMENTS a:000002000000:02 | has the fragments 02 *",
            "STALE; support answers STALE a:0:000000ffffff0000 | tells the floor 000000ffffff",
            "STALE; support answers STALE a:0:00000100001fffff | says that it has been up for 6553.5 s; expected",
            "STALE; police asks SUPP help; police asks SUPP help; support answers STALE a:0:00000100001f0000"
                    + " | up for 0.0 s",
            // Answers that nobody gave.
            "SENT; police DELIVERED number=0 | declares DELIVERED of message 0; expected an acknowledgement of that",
            "SENT; thief throws a:0:~-1; police DELIVERED number=0 | declares DELIVERED of message 0 *",
            "ASKING; support answers FRAGMENTS a:0:01; police FRAGMENTS_NEW number=0 have=3 | declares FRAGMENTS_NEW",
            "SENT; police STALE_HEARD number=0 | declares STALE_HEARD",
            // Trailers.
            "ASKED; police sends 0 s:SUPP:0:help + mark | one only behind a packet that is sent again",
            "SENT; police sends 0 s:SUPP:0:help + parity | expected that its partner asks for parity first *",
            // Messages that a host is handed.
            "SENT; support hands 0 SUPP 010000 halp | support hands its host 'halp' from SUPO; expected 'help'",
            "SENT; support hands 0 SUPP 010001 help | support hands its host 'help' from SUPO; "
                    + "expected a message that it",
            "thief throws s:SUPP:0:help~-1; support hands 0 SUPP 010000 help | expected a message that it has sent",
            "thief throws s:SUPP:0:help~7; support does host-handed number=0 destination=SUPP origin=SUPN id=010000 "
                    + "content=help | expected what nobody knows *",
            "thief throws f:AA:s:SUPP:0:LONG~7~17; support does host-handed number=0 destination=SUPP origin=SUPN "
                    + "id=010000 content=help | expected what nobody knows *",
            "thief throws f:AA:b:LONG~7~17; support does host-handed number=0 destination=//// origin=SUPN id=000000 "
                    + "content=xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx"
                    + " | expected what nobody knows",
            "police asks //// LONG; police seals 0 255; police parts 0 f:AA:b:LONG; police sends 0 f:AB:b:LONG; "
                    + "support hands 0 //// 000000 LONGy | support hands its host 'xxxx",
    })
    void wrong_isRefusedByName(String script, String why) {
        TestTrace trace = trace(script);
        String verdict = trace.verdict(ByteCheck::new);
        String words = why.replaceFirst(" ?\\*$", "");
        assertTrue(verdict.startsWith("model: trace refused at event ") && verdict.contains(words), verdict);
        assertEquals(1, verdict.lines().count());
        String without = trace.verdictWithoutKeys(ByteCheck::new);
        assertTrue(why.endsWith("*") || without.contains("refused") && without.contains(words), without);
    }

    @ParameterizedTest
    @CsvSource({"destination, SUHO", "origin, SUHO", "kind, multicast", "id, 1", "index, 2", "asks, true"})
    void field_thatTheBytesDoNotSay_isRefused(String field, String value) {
        TestTrace trace = trace("BEGUN");
        trace.lines.get(trace.lines.size() - 2).addProperty(field, value);
        assertTrue(shown(trace).contains("the " + field + " '" + value + "'; expected '"), shown(trace));
    }

    @Test
    void broadcast_ofWhichNobodyKnowsWhatItSays_isItsBoards() {
        TestTrace trace = trace("police asks //// LONG; police seals 0 255; police parts 0 f:AA:b:LONG; "
                + "thief throws f:AB:b:LONG~-1; police sends 0 f:AB:b:LONG");
        trace.lines.forEach(line -> line.remove("content"));
        assertTrue(trace.verdictWithoutKeys(ByteCheck::new).contains("accepted"));
    }

    @Test
    void packet_ofWhichTheTraceEndsTooEarly_isNotMissed() {
        TestTrace trace = trace("TAKEN");
        trace.lines.removeIf(line -> line.get("event").getAsString().equals("rf-tx"));
        int heard = trace.lines.size() - 1;
        while (!trace.lines.get(heard).get("event").getAsString().equals("rf-rx")) {
            trace.lines.get(heard--).addProperty("t", 5.2);
        }
        assertTrue(shown(trace).contains("accepted"), shown(trace));
        trace.lines.remove(heard);
        assertTrue(shown(trace).contains("support hands its host"), shown(trace));
    }
}
