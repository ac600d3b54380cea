package uppaal.conformance;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AirCheckTest {
    private static final String SEND = "1 a SEND pending=1; ";
    private static final String PACKET = "1.25 a rf-tx packet=1 payload=UNICAST kind=any start=1.0002 ";
    /** It breaks off before its trailer. */
    private static final String BROKEN =
            "1.2397 a rf-tx packet=1 payload=UNICAST kind=any trailer=mark bits=480 start=1.0002 end=1.2397; ";
    /** Board b listens, and hears a carrier. */
    private static final String HEARD = "0.9 QUIET; 1 a SEND pending=1; 1.0075 BUSY; ";

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "declared             | " + SEND + "1.0002 a UNICAST | accepted",
            "not declared         | 0.5 a host-id id=ROMA epoch=000001; 1 a UNICAST "
                    + "| s, a, rf-tx): a sends a unicast of ROMA that it has not declared; expected one of ANSWER",
            "other than declared  | 1 a ANSWER key=1; 1.0002 a UNICAST | ; expected ANSWER",
            "other hops           | 1 a RELAY_COPY place=1 path=1; 1.0002 a UNICAST hops=2 "
                    + "| of path 2; expected RELAY_COPY, as it has declared, of path 1",
            "distance of no relay | " + SEND + "1.0002 a UNICAST distance=1 "
                    + "| of path 8; expected SEND, as it has declared, of path 0",
            "late                 | " + SEND + "1.002 a UNICAST | behind its SEND; expected at once",
            "nothing on the air   | " + SEND + "2 a SEND pending=1 "
                    + "| a has declared SEND at 1.000000 s, and nothing was on the air",
            "reset before         | " + SEND + "1.0001 a reset why=power; 2 a SEND pending=1; 2.0002 a UNICAST "
                    + "| accepted"})
    void begins_isJudged(String what, String story, String verdict) {
        Story.check(AirCheck::new, story, verdict);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "other bits            | " + PACKET
                    + "bits=481 end=1.2402 | a sends 481 bits; expected 480 for these bytes",
            "ends before it begins | " + PACKET + "bits=480 end=0.9 | a sends 480 bits in -0.1",
            "sent twice            | " + PACKET + "bits=480 end=1.2397; " + PACKET + "bits=480 end=1.2397 "
                    + "| a sends packet 1 again; expected each packet once",
            "too slow              | " + PACKET + "bits=480 end=1.2452 "
                    + "| a sends 480 bits in 0.245000 s; expected 0.2395",
            "trailer lost by reset | " + BROKEN + "1.243 a reset why=fault; 2 a QUIET | accepted",
            "power cut before      | 1.2396 a fault do=power-cut until=1.4396; " + BROKEN
                    + "1.4396 a reset why=power | accepted",
            "no power              | 1.1 a fault do=power-cut until=1.2; 1.3 a QUIET | expected nothing before a reset",
            "power back too soon   | 1.1 a fault do=power-cut until=1.3; 1.2 a reset why=power "
                    + "| a begins anew; expected that its power is back at 1.300000 s",
            "trailer missing       | " + BROKEN + "2 a QUIET | expected 492 for these bytes and this trailer",
            "long before reset     | " + BROKEN + "1.5 a reset why=fault | expected 492"})
    void ends_isJudged(String what, String story, String verdict) {
        Story.check(AirCheck::new, SEND + story, verdict);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "as sent               | " + HEARD + "1.0002 a>b UNICAST | accepted",
            "twice                 | " + HEARD + "1.0002 a>b UNICAST; 1.0002 a~b UNICAST | twice",
            "changed               | " + HEARD + "1.0002 a UNICAST; 1.0002 a~b OTHER | other than it was sent",
            "never sent            | 1 a~b UNICAST; 9 c QUIET | ; expected one that another board sent",
            "by its sender         | " + HEARD + "1.0002 a UNICAST; 1.0002 a~a UNICAST "
                    + "| ; expected one that another board sent",
            "no carrier declared   | 0.9 QUIET; " + SEND + "1.0002 a>b UNICAST | b declares no carrier",
            "no quiet declared     | 1 MEMORY kept=0; 12 a QUIET "
                    + "| b has declared nothing since 1.000000 s; expected QUIET",
            "quiet, then nothing   | 1 MEMORY kept=0; 2 QUIET; 30 a QUIET | accepted",
            "busy by a long jam    | 1 MEMORY kept=0; 2 - fault do=jam until=12; 13 a QUIET; 14 QUIET | accepted",
            "without power         | 1 MEMORY kept=0; 2 b fault do=power-cut until=20; 19 a QUIET | accepted",
            "without a radio       | 1 EPOCH_STORED low=1; 12 a QUIET | accepted",
            "sent into             | 0.9 QUIET; " + SEND + "1.05 SEND pending=1; 1.0002 a>b UNICAST "
                    + "| b has sent at 1.050000 s into",
            "carrier in silence    | 5.9 QUIET; 6 BUSY | ; expected silence",
            "carrier of a packet that the end cuts off | 5.9 QUIET; 5.998 - command do=send payload=00; 6 BUSY "
                    + "| accepted"})
    void reaches_isJudged(String what, String story, String verdict) {
        Story.check(AirCheck::new, story, verdict);
    }
}
