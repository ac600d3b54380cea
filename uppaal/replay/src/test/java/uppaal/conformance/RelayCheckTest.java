package uppaal.conformance;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Board b relays between a (ROMA) and c (SUPO), whose packets reach it; its score for c is 1 at first. */
class RelayCheckTest {
    private static final String COMES = "1.0095 a>b UNICAST; 1.25 QUIET; ";
    private static final String NEW = "1.25 RELAY_NEW nonce=0; ";
    private static final String UNKNOWN = "1.25 RELAY_DISTANCE distance=0; " + NEW;
    private static final String KNOWN = "1.25 RELAY_DISTANCE distance=2; " + NEW;
    /** Its copy waits for 30 + 3 slots from 1.25 s on. */
    private static final String WAITS = COMES + UNKNOWN + "1.25 RELAY_DRAW slots=3; ";
    private static final String COPY = "1.515 RELAY_COPY path=1; 1.5152 b UNICAST hops=1; ";
    private static final String COPIED = WAITS + COPY + "1.7557 QUIET; 1.7557 RELAY_COPY_ENDED; ";
    private static final String ANSWERED = COPIED + "1.776 c>b ACK; 1.926 RELAY_ANSWERED doubt=0; ";
    /** A copy of c comes damaged, behind others of the same bytes. */
    private static final String DAMAGED = COPIED + "2.25 BUSY; 2.26 c UNICAST hops=2; "
            + "2.5041 b rf-damaged from=c packet=3 why=any start=2.26 end=2.4995; 2.51 QUIET; 2.516 ";
    private static final String DAMAGED_LATE = WAITS + "1.265 BUSY; 1.2695 c>b UNICAST hops=1; 1.51 RELAY_PEER; "
            + "1.51 COUNT counter=10; 1.51 QUIET; 3.25 BUSY; 3.26 c UNICAST hops=2; 3.5041 b rf-damaged from=c "
            + "packet=3 why=any start=3.26 end=3.4995; 3.51 QUIET; 3.516 RELAY_ANEW packet=3; "
            + "3.516 RELAY_DRAW slots=3 packet=3; 3.775 RELAY_COPY packet=3 ";
    /** It comes from so many hops away. */
    private static final String NEAR = "0.6 c>b ACK; ";
    private static final String FAR = "0.6 c>b ACK hops=1; ";

    private static void check(String story, String verdict) {
        Story.check(RelayCheck::new, "0.5 RELAY_ON on=1; " + story.replaceAll("RELAY_\\w+", "$0 place=7"),
                verdict);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "after its slots      | " + COPY + "| accepted",
            "its end not told     | " + COPY + "1.7557 QUIET; 1.77 BUSY | first that what it has copied has ended",
            "early                | 1.506 RELAY_COPY path=1 | b declares RELAY_COPY too early; expected 1.514",
            "late                 | 1.536 RELAY_COPY path=1 | RELAY_COPY at its first run()",
            "other hops           | 1.515 RELAY_COPY path=2 | ; expected path 1, with 1 hops",
            "other bytes          | 1.515 RELAY_COPY path=1; 1.5152 b OTHER hops=1 |, as it came",
            "refused with credit  | 1.515 RELAY_REFUSE | ; expected RELAY_COPY of a packet of 240 ms",
            "handed on            | 1.265 BUSY; 1.2695 c>b UNICAST hops=2; 1.51 RELAY_GONE_ON soon=0; 1.51 QUIET; "
                    + "1.7 RELAY_COPY path=1 | is Known; expected ",
            "copied by a peer     | 1.265 BUSY; 1.2695 c>b UNICAST hops=1; 1.51 RELAY_PEER; 1.51 COUNT counter=10 "
                    + "| accepted",
            "damaged, gone on     | " + DAMAGED + "RELAY_GONE_ON soon=0 packet=3; 3 QUIET | accepted",
            "damaged, for another | " + DAMAGED + "RELAY_DRAW_AGAIN slots=6 packet=3; 2.55 BUSY | accepted",
            "damaged, for none    | " + DAMAGED + "RELAY_PEER packet=3 | is Known; expected RELAY_GONE_ON",
            "begun by a damaged   | " + DAMAGED_LATE + "path=3; 3.7752 b UNICAST hops=3 | accepted",
            "begun by one before  | " + DAMAGED_LATE + "path=1; 3.7752 b UNICAST hops=1 | accepted",
            "begun by none before | " + DAMAGED_LATE + "path=0 | expected path 3, with 3 hops",
            "peer not told        | 1.265 BUSY; 1.2695 c>b UNICAST hops=1; 1.51 COUNT counter=10 "
                    + "| expected RELAY_PEER or RELAY_GONE_ON of place 7",
            "gone on not told     | 1.265 BUSY; 1.2695 c>b UNICAST hops=2; 1.51 COUNT counter=10 "
                    + "| expected RELAY_PEER or RELAY_GONE_ON of place 7",
            "acknowledged without | 1.26 BUSY; 1.776 c>b ACK; 1.926 RELAY_ANSWERED doubt=2 | accepted"})
    void copy_isJudged(String what, String story, String verdict) {
        check(story.startsWith(COMES) ? story : WAITS + story, verdict);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "nothing came           | " + NEW + "| ; expected that the packet has come to it",
            "before its damage      | 1.0095 a UNICAST; 1.2489 QUIET; 1.2489 RELAY_DISTANCE distance=0 packet=1; "
                    + "1.2489 RELAY_NEW nonce=0 packet=1; 1.2489 RELAY_DRAW slots=3; 1.2531 b rf-damaged from=a "
                    + "packet=1 why=any start=1.0095 end=1.249; 1.26 QUIET | accepted",
            "no distance            | " + COMES + NEW + "| ; expected RELAY_DISTANCE before",
            "nothing knows distance | " + FAR + COMES + KNOWN
                    + "| b tells the distance 1 of SUPO; expected one more than the hops",
            "distance read          | " + NEAR + "0.751 COUNT counter=10; " + COMES + UNKNOWN
                    + "| b tells no distance of SUPO; expected one, as it has read",
            "distance perhaps read  | " + NEAR + "0.8 COUNT counter=10; " + COMES + UNKNOWN
                    + "1.25 RELAY_DRAW slots=3 | accepted",
            "distance known         | " + NEAR + COMES + KNOWN + "1.25 RELAY_DRAW slots=15; 1.435 RELAY_COPY path=9; "
                    + "1.4352 b UNICAST hops=1 distance=1 | accepted",
            "nearer than told       | " + NEAR + "1.0095 a>b UNICAST distance=2; 1.25 QUIET; " + KNOWN
                    + "1.25 RELAY_DRAW slots=0 | accepted",
            "not nearer: told 1     | " + NEAR + "1.0095 a>b UNICAST distance=1; 1.25 QUIET; " + KNOWN
                    + "1.25 RELAY_RESERVE | accepted",
            "not nearer: told 3     | " + NEAR + "1.0095 a>b UNICAST distance=3; 1.25 QUIET; " + KNOWN
                    + "1.25 RELAY_RESERVE | accepted",
            "not nearer: unknown    | " + NEAR + "1.0095 a>b UNICAST distance=2; 1.25 QUIET; " + UNKNOWN
                    + "1.25 RELAY_RESERVE | accepted",
            "late, and away         | " + NEAR + "1.0095 a>b UNICAST distance=1; 1.25 QUIET; " + KNOWN
                    + "1.25 RELAY_RESERVE; "
                    + "3.01 BUSY; 3.0095 a>b UNICAST; 3.25 QUIET; 3.25 RELAY_ANEW; 3.25 RELAY_DRAW slots=3; "
                    + "3.515 RELAY_COPY path=1; 3.5152 b UNICAST hops=1 | accepted",
            "too many slots         | " + COMES + UNKNOWN + "1.25 RELAY_DRAW slots=128 "
                    + "| b declares RELAY_DRAW; expected 0 to 127 slots",
            "no slots               | " + COMES + UNKNOWN + "1.26 QUIET | ; expected RELAY_DRAW of place 7",
            "of one's own: known    | " + NEAR + "1 SEND pending=1; 1.0002 b UNICAST distance=1 | accepted",
            "of one's own: unknown  | 1 SEND pending=1; 1.0002 b UNICAST distance=1 | b tells the distance 1 of SUPO",
            "no relay               | 1 RELAY_ON on=0; " + COMES + NEW + "| ; expected RELAY_ON"})
    void newPacket_isJudged(String what, String story, String verdict) {
        check(story, verdict);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "copied twice in doubt | " + COPIED + "1.976 RELAY_COPY path=1 | is Known; expected ",
            "told to be for others | " + COPIED + "1.776 c>b ACK; 1.927 COUNT counter=10 "
                    + "| b declares COUNT; expected RELAY_ANSWERED of place 7 before",
            "told as a relay, too  | " + ANSWERED + "1.926 RELAY_DRAW_ANSWER slots=2; 1.926 COUNT counter=10 "
                    + "| accepted",
            "soon acknowledged     | " + ANSWERED + "1.926 RELAY_DRAW_ANSWER slots=2 | accepted",
            "other score           | " + COPIED + "1.776 c>b ACK; 1.926 RELAY_ANSWERED doubt=2 "
                    + "| b declares RELAY_ANSWERED",
            "from upstream         | " + COPIED + "1.776 a>b ACK hops=1 distance=0; 1.926 RELAY_ANSWERED doubt=1; "
                    + "1.926 RELAY_DRAW_ANSWER slots=2 | Carrying, not Kept",
            "from downstream       | " + COPIED + "1.776 c>b ACK hops=1 distance=2; 1.926 RELAY_ANSWERED doubt=1; "
                    + "1.926 RELAY_DRAW_ANSWER slots=0; 1.927 RELAY_ANSWER path=10 | accepted",
            "a peer's not told     | " + ANSWERED + "1.926 RELAY_DRAW_ANSWER slots=2; 1.927 BUSY; "
                    + "1.93 a>b ACK hops=1 distance=1; 2.08 COUNT counter=10 "
                    + "| expected RELAY_PEER or RELAY_GONE_ON of place 7, or of its answer, before",
            "a peer's told         | " + ANSWERED + "1.926 RELAY_DRAW_ANSWER slots=2; 1.927 BUSY; "
                    + "1.93 a>b ACK hops=1 distance=1; 2.08 RELAY_ANSWER_PEER; 2.08 COUNT counter=10 | accepted",
            "answered more often   | " + ANSWERED + "1.926 RELAY_DRAW_ANSWER slots=0; 1.927 RELAY_ANSWER path=9; "
                    + "1.9272 b ACK hops=1 distance=1; 2.096 RELAY_ANSWER_ENDED; 2.096 QUIET; "
                    + "2.166 RELAY_ANSWER path=9 | is Kept; expected "})
    void acknowledgement_isJudged(String what, String story, String verdict) {
        check(story, verdict);
    }
}
