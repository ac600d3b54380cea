package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Comparator;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A genuine story is accepted; with a line changed, left out (no new line) or repeated it is refused. */
class ModelReplayTest {
    private static final String UNICAST = """
            0.010 QUIET
            0.500 host-transmit number=0 destination=SUPP asked=0.499
            0.501 TAKE_UP key=1
            0.501 CONTEND slots=3
            0.523 SEND pending=1
            0.524 BUSY
            0.700 QUIET
            0.700 AWAIT rounds=0
            0.850 ATTEMPT_FAILED attempts=1
            0.850 CONTEND slots=20
            0.900 BUSY
            0.950 QUIET
            1.110 SEND pending=1
            1.111 BUSY
            1.300 QUIET
            1.300 AWAIT rounds=0
            1.350 BUSY
            1.450 QUIET
            1.451 DELIVERED
            1.500 host-outcome number=0 outcome=delivered
            """;
    private static final String RECEIVED = """
            0.010 QUIET
            0.100 BUSY
            0.300 QUIET
            0.300 QUEUED nonce=7 key=1
            0.350 HANDED message=0
            0.360 host-handed number=0 destination=BUSS
            0.400 host-taking number=0
            0.410 TAKEN message=0
            0.410 OWE_DELIVERED nonce=7 key=1
            0.411 ANSWER key=1
            0.412 BUSY
            0.500 QUIET
            0.600 BUSY
            0.700 OWE_DELIVERED nonce=7 key=1
            0.700 PUT_OFF slots=3
            0.710 QUIET
            0.734 ANSWER key=1
            0.735 BUSY
            0.800 QUIET
            """;
    private static final String FRAGMENTS = """
            0.010 QUIET
            0.500 host-transmit number=0 destination=SUPP asked=0.499
            0.501 TAKE_UP key=1
            0.501 CONTEND slots=0
            0.502 SEND pending=7
            0.503 BUSY
            0.700 QUIET
            0.700 PART_SENT
            0.708 SEND pending=6
            0.709 BUSY
            0.900 QUIET
            0.900 PART_SENT
            0.908 SEND pending=4
            0.909 BUSY
            1.100 QUIET
            1.100 AWAIT rounds=0
            1.120 BUSY
            1.200 QUIET
            1.200 FRAGMENTS_NEW have=5
            1.208 SEND pending=2
            1.209 BUSY
            1.400 QUIET
            1.400 AWAIT rounds=0
            1.551 ATTEMPT_FAILED attempts=1
            1.551 CONTEND slots=0
            1.553 SEND pending=2
            1.554 BUSY
            1.700 QUIET
            1.700 AWAIT rounds=0
            1.720 BUSY
            1.800 QUIET
            1.800 DELIVERED
            """;

    private static Optional<String> refusal(String story) {
        return Story.refusal(story, "", ModelReplay::new);
    }

    private static void refused(String story, String from, String to, String why) {
        String lines = sorted(
                to == null ? story.lines().filter(line -> !line.contains(from)).reduce("", (a, b) -> a + b + "\n")
                        : story.replace(from, to.replace(';', '\n')));
        assertTrue(!lines.equals(story), from);
        String refusal = refusal(lines).orElse("accepted");
        assertTrue(refusal.contains(why), refusal);
    }

    private static String sorted(String lines) {
        return lines.lines().sorted(Comparator.comparing(line -> line.split(" ")[0]))
                .collect(Collectors.joining("\n"));
    }

    @Test
    void genuineStories_areAccepted() {
        assertEquals(Optional.empty(), refusal(UNICAST));
        assertEquals(Optional.empty(), refusal(UNICAST.substring(0, UNICAST.indexOf("0.850"))
                + "0.850 BUSY\n0.850 ATTEMPT_FAILED attempts=1"));
        assertEquals(Optional.empty(), refusal(RECEIVED));
        assertEquals(Optional.empty(), refusal(FRAGMENTS));
        assertEquals(Optional.empty(), refusal("0.010 QUIET\n0.501 TAKE_UP key=255\n0.501 CONTEND slots=3\n"
                + "0.523 SEND pending=1\n0.524 BUSY\n0.700 QUIET\n0.700 SENT\n"));
        assertEquals(Optional.empty(), refusal(RECEIVED.replace("0.700 PUT_OFF", "0.700 OWE_TWICE\n0.700 PUT_OFF")
                + "0.824 ANSWER key=1\n0.825 BUSY\n0.900 QUIET\n"));
    }

    /** The host has asked again before the reply came: the board reads that, and answers it, before what is taken. */
    @ParameterizedTest
    @ValueSource(strings = {
            "0.405 HANDED message=0", "0.405 HANDED message=0\n0.406 host-handed number=0 destination=BUSS",
            "0.405 HANDED message=0\n0.4105 host-handed number=0 destination=BUSS"})
    void message_thatIsHandedAgainWhileItIsTaken_isAccepted(String again) {
        assertEquals(Optional.empty(), refusal(sorted(RECEIVED + again)));
    }

    @Test
    void reset_whileAMessageWaits_leavesNoneThatWaits() {
        assertEquals(Optional.empty(), refusal("0.500 host-transmit number=0 destination=SUPP asked=0.499\n"
                + "0.501 BUSY\n0.502 b reset\n0.900 QUIET\n"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "0.501 TAKE_UP |                                     | expected TAKE_UP first",
            "0.850 CONTEND | 0.854 CONTEND                       | expected CONTEND before, as messages wait",
            "0.500 host-transmit |                               | expected that its host has asked for it",
            "0.523 SEND    | 0.510 SEND                          | SEND too early; expected 0.514",
            "0.501 CONTEND slots=3 | 0.501 CONTEND slots=0 | by 0.523",
            "0.850 ATTEMPT | 0.775 ATTEMPT                       | too early; expected 0.85",
            "0.850 ATTEMPT | 0.775 BUSY;0.775 ATTEMPT            | too early; expected quiet air",
            "0.850 ATTEMPT_FAILED attempts=1 | 0.850 ATTEMPT_FAILED attempts=2 | expected attempts 1",
            "rounds=0      | rounds=3                            | expected rounds 0",
            "1.110 SEND    | 1.002 SEND                          | too early",
            "1.110 SEND    | 0.940 SEND                          | expected quiet air",
            "0.950 QUIET   | 0.950 QUIET;0.950 CONTEND slots=2   | after 1.014",
            "0.950 QUIET   | 0.950 QUIET;0.950 CONTEND slots=8   | expected at most 7 slots",
            "0.524 BUSY | 0.524 BUSY;0.524 host-transmit number=1 destination=BUSS asked=0.524;0.524 TURN number=1;"
                    + "0.524 TAKE_UP key=2;0.524 CONTEND slots=3 | its Sender transmission 1 is Ready",
            "1.451 DELIVERED | 1.451 DELIVERED;1.452 SEND pending=1 | expected TAKE_UP first",
            "1.500 host-outcome | 1.500 crash                    | b's program crashes; expected that it runs on",
            "1.451 DELIVERED | 1.451 SENT       | declares SENT, but its Sender"})
    void unicast_changed_isRefused(String from, String to, String why) {
        refused(UNICAST, from, to, why);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "0.350 HANDED  |                                     | expected HANDED first",
            "0.300 QUEUED  |                                     | expected QUEUED before",
            "0.350 HANDED message=0 | 0.310 QUEUED nonce=8 key=1;0.350 HANDED message=1 | message 1 is Queued",
            "0.400 host-taking |                                 | declares TAKEN, but its Receiver",
            "0.410 OWE     |                                     | expected OWE_DELIVERED for message 0",
            "0.410 OWE_DELIVERED nonce=7 | 0.410 OWE_DELIVERED nonce=8 | expected OWE_DELIVERED for message 0",
            "0.410 TAKEN message=0 | 0.410 TAKEN message=1         | expected one that is in its inbox",
            "0.410 TAKEN message=0 | 0.410 TAKEN message=0;0.411 HANDED message=0 | expected QUEUED before",
            "0.411 ANSWER  |                                     | expected PUT_OFF",
            "0.412 BUSY    | 0.412 BUSY;0.420 ANSWER key=1       | expected that it owes one",
            "0.700 OWE_DELIVERED nonce=7 | 0.700 OWE_DELIVERED nonce=6 | taken last of this key",
            "0.700 OWE_DELIVERED | 0.700 OWE_FRAGMENTS            | expected FRAGMENT in the same run()",
            "0.734 ANSWER  | 0.720 ANSWER                        | too early",
            "0.700 PUT_OFF slots=3 | 0.700 PUT_OFF slots=2        | by 0.734",
            "0.700 PUT_OFF slots=3 | 0.700 PUT_OFF slots=6        | expected 2 to 5",
            "0.700 PUT_OFF slots=3 | 0.701 BUSY                   | expected PUT_OFF",
            "0.800 QUIET   | 0.800 QUIET;0.801 PUT_OFF slots=3   | expected that it owes an answer"})
    void received_changed_isRefused(String from, String to, String why) {
        refused(RECEIVED, from, to, why);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "0.708 SEND pending=6 | 0.708 SEND pending=12 | expected pending 6",
            "1.208 SEND pending=2 | 1.208 SEND pending=6 | expected pending 2",
            "1.208 SEND pending=2 | 1.208 SEND pending=1 | expected pending 2",
            "1.553 SEND pending=2 | 1.553 SEND pending=4 | expected pending 2",
            "FRAGMENTS_NEW | FRAGMENTS_KNOWN                     | declares ATTEMPT_FAILED; expected attempts 2"})
    void fragments_changed_areRefused(String from, String to, String why) {
        refused(FRAGMENTS, from, to, why);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"4.451 | accepted", "3.000 | too early; expected 4.45",
            "4.600 | by 4.590"})
    void copiedByRelay_waitsFor20Rounds(double failed, String why) {
        String copied = UNICAST.substring(0, UNICAST.indexOf("1.451")) + "1.451 COPIED\n"
                + (failed - 0.01) + " QUIET\n" + failed + " ATTEMPT_FAILED attempts=2\n";
        String refusal = refusal(copied).orElse("accepted");
        assertTrue(refusal.contains(why), refusal);
    }

    @Test
    void attempt_thatDoesNotFail_isRefused() {
        String silent = UNICAST.substring(0, UNICAST.indexOf("0.850"));
        assertTrue(refusal(silent + "0.856 QUIET").orElse("").contains("expected ATTEMPT_FAILED of transmission 0"));
        assertEquals(Optional.empty(), refusal(silent + "0.851 QUIET"));
    }

    /** In a run() that sends something else, contention may count no slots. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"1.208 | accepted", "1.100 | too early; expected 1.104", "1.220 | by 1.22"})
    void contention_countsNoSlotsUpToACopy(String sent, String why) {
        String story = UNICAST.substring(0, UNICAST.indexOf("0.900")) + "0.950 RELAY_COPY gap=0.099\n0.951 BUSY\n"
                + "1.000 QUIET\n" + sent + " SEND pending=1\n";
        String refusal = refusal(story).orElse("accepted");
        assertTrue(refusal.contains(why), refusal);
    }

    @Test
    void serialModule_hasNoTimers() {
        String late = UNICAST.replace("0.523 SEND", "0.503 SEND").replace("0.850 ATTEMPT", "0.710 ATTEMPT")
                .replace("0.850 CONTEND", "0.710 CONTEND");
        assertEquals(Optional.empty(), Story.refusal(late, ",\"module\":\"hc-12\"", ModelReplay::new));
        assertTrue(refusal(late).isPresent());
    }
}
