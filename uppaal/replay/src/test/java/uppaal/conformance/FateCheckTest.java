package uppaal.conformance;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FateCheckTest {
    private static final String ON = "0.5 b host-id id=SUPP epoch=000001; 0.6 QUIET; ";
    /** It ends at 1.2395 s. */
    private static final String HEARD = "1 a>b UNICAST; ";
    /** Counters of SPEC 4.5: radioNotForUs, radioSent, radioRepeats. */
    private static final String NOT_FOR_US = "COUNT counter=10; ";
    private static final String BLOCKED = "COUNT counter=29; ";
    private static final String DROPPED = "COUNT counter=20; ";
    private static final String REPLAYED = "COUNT counter=14; ";
    private static final String FIRST_BOOT = "0.7 EPOCH_STORED low=1; 0.7 a host-id id=ROMA; ";
    private static final String SENT = "COUNT counter=17; ";
    private static final String REPEATS = "COUNT counter=19; ";
    private static final String QUEUED = "QUEUED nonce=0 key=1; ";
    private static final String TO_ALL = "1 a>b BROADCAST; 1.2405 ";
    private static final String TO_GROUP = "1 a>b MULTICAST; 1.2405 ";
    private static final String OF_ALL = "1 a>b FIRST_TO_ALL; 1.1625 ";
    private static final String UNICASTS_ONLY = "0.7 b host-id id=SUPP unicastsOnly=true; ";
    private static final String END = "2 QUIET | ";

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "told               | " + HEARD + "1.2405 " + QUEUED + "2 QUIET | accepted",
            "counted            | " + HEARD + "1.2405 " + NOT_FOR_US + "2 QUIET | accepted",
            "not told           | " + HEARD + "2 QUIET | b has not told what became of a unicast of ROMA; expected",
            "other counter      | " + HEARD + "1.2405 " + SENT + "2 QUIET | became of",
            "counted twice      | " + HEARD + "1.2405 " + NOT_FOR_US + "1.2405 " + NOT_FOR_US
                    + "2 QUIET | b counts radioNotForUs of no packet that came; expected each once",
            "counted of none    | 0.9 " + NOT_FOR_US + "2 QUIET | of no packet that came",
            "before damage      | 0.9 a host-id id=ROMA; 1 a UNICAST; 1.2396 QUEUED nonce=0 key=1 packet=1; "
                    + "1.242 b rf-damaged from=a packet=1 start=1.0001 end=1.2396; 2 QUIET | accepted",
            "of none that came  | 1 a UNICAST; 1.2396 QUEUED nonce=0 key=1 packet=1; 2 QUIET "
                    + "| b tells of packet 1; expected one that has come to it",
            "behind another     | 1 a>b FIRST; " + "1.2 a>b UNICAST; 1.4405 " + QUEUED + "2 QUIET | accepted",
            "other nonce        | " + HEARD + "1.2405 QUEUED nonce=1 key=1; 2 QUIET | expected its nonce",
            "whole of a part    | 1 a>b FIRST; 1.1625 " + QUEUED + "2 QUIET | tells QUEUED of a fragment of SUPO",
            "part of a whole    | " + HEARD + "1.2405 FRAGMENT; 2 QUIET | expected a fragment",
            "no answer          | " + HEARD + "1.2405 DELIVERED; 2 QUIET | expected an acknowledgement",
            "own of another     | 0.7 a host-id id=ROMA; 0.7 c RELAY_ON on=1; 0.8 c QUIET; 1 a>c UNICAST; "
                    + "1.2405 c COUNT counter=11; 2 c QUIET | expected a packet of its own address",
            "forged as a whole  | 1 a>b FIRST; 1.1625 FRAGMENT; 1.1625 COUNT counter=13; 2 QUIET | accepted",
            "first run          | " + HEARD + "1.2415 QUIET | accepted",
            "late               | " + HEARD + "1.26 " + NOT_FOR_US + END + "of no packet that came",
            "mended, overlapped | 1.2386 b rf-collision boards=a,c; " + HEARD + "1.26 " + NOT_FOR_US + END + "accepted",
            "of one before      | 0.9 b rf-collision boards=a,c; " + HEARD + "1.26 " + NOT_FOR_US + END
                    + "of no packet that came",
            "reset              | " + HEARD + "1.3 b reset why=fault; 2 QUIET | accepted",
            "numbered otherwise | 1.0001 c>b UNICAST; 1 a>b UNICAST; 2 COUNT counter=26 packet=2; "
                    + "3 COUNT counter=26 packet=2; 4 QUIET | accepted",
            "unplugged          | " + HEARD + "1.24 b fault do=unplug; 1.2405 " + NOT_FOR_US + "2 QUIET | accepted",
            "two at once        | " + HEARD + "1.2595 a>b UNICAST; 2 QUIET | accepted",
            "assembled message  | 1 a>b FIRST; 1.1625 FRAGMENT; 2 a>b LATER; 3 QUIET "
                    + "| b has not told what became of a fragment of SUPO",
            "ignored message    | 1 a>b FIRST; 1.1625 " + NOT_FOR_US + "2 a>b LATER; 3 QUIET | accepted",
            "behind the last    | 1 a>b FIRST; 1.1625 FRAGMENT; 1.1625 " + QUEUED + "2 a>b LATER; 3 QUIET | accepted",
            "not blocked        | 0.7 b host-radio radio=open; " + HEARD + "1.2405 " + BLOCKED
                    + "2 a>b UNICAST; 2.2405 "
                    + BLOCKED + "3 QUIET | b counts radioBlocked of a unicast of ROMA; expected a radio that its",
            "blocked again      | 0.7 b host-radio radio=open; 0.8 b host-radio radio=blocked; " + HEARD + "1.2405 "
                    + BLOCKED + "2 a>b UNICAST; 2.2405 " + BLOCKED + "3 QUIET | accepted",
            "not its own        | " + HEARD + "1.2405 COUNT counter=11; 2 QUIET | expected a packet of its own address",
            "for this device    | 0.7 b host-id id=SUPO; " + HEARD + "1.2405 " + NOT_FOR_US
                    + "2 QUIET | expected a packet for another device",
            "a right frame      | 0.7 a host-id id=ROMA; " + HEARD + "1.2405 COUNT counter=8; 2 QUIET "
                    + "| expected a packet that is none of our firmware's",
            "a wrong frame      | " + HEARD + "1.2405 COUNT counter=8; 2 QUIET | accepted",
            "room for the first | 0.7 a host-id id=SUPO; 1 a>b FIRST; 1.1625 " + DROPPED
                    + "2 QUIET | expected that it has no",
            "room for one       | 0.7 a host-id id=SUPO; 0.8 c>b FIRST; 1 a>b FIRST; 1.1625 " + DROPPED
                    + "2 QUIET | accepted",
            "room again         | 0.7 a host-id id=SUPO; 0.8 c>b FIRST; 8 a>b FIRST; 8.1625 " + DROPPED
                    + "9 QUIET | expected that it has no room",
            "room for messages  | 0.7 a host-id id=SUPO; " + HEARD + "1.2405 " + QUEUED + "8 a>b FIRST; 8.1625 "
                    + DROPPED + "9 QUIET | accepted",
            "a small board      | 0.65 c host-id id=SUPP epoch=000001; 0.66 c QUIET; 0.7 a host-id id=SUPO; "
                    + "1 a>c FIRST; 1.1625 c " + DROPPED + "2 c QUIET | accepted",
            "never came         | " + FIRST_BOOT + HEARD + "1.2405 " + REPLAYED
                    + "2 QUIET | expected a packet that has come to it before",
            "came before        | " + FIRST_BOOT + HEARD + "1.2405 " + QUEUED + "2 a>b UNICAST; 2.2405 " + REPLAYED
                    + "3 QUIET | accepted",
            "lost its memory    | " + FIRST_BOOT + "0.71 b reset why=power; 0.72 b host-id id=SUPP epoch=000002; "
                    + "0.73 QUIET; " + HEARD + "1.2405 " + REPLAYED + "2 QUIET | accepted",
            "acknowledged again | " + HEARD + "1.2405 " + REPEATS + "1.2405 OWE_DELIVERED nonce=0 key=1; 2 QUIET "
                    + "| accepted",
            "not acknowledged   | " + HEARD + "1.2405 " + REPEATS + "2 QUIET | expected OWE_DELIVERED",
            "to all             | " + TO_ALL + QUEUED + END + "accepted",
            "to all, dropped    | " + TO_ALL + NOT_FOR_US + END + "expected a packet for another device",
            "to group           | " + TO_GROUP + QUEUED + END + "accepted",
            "to group, dropped  | " + TO_GROUP + NOT_FOR_US + END + "expected a packet for another device",
            "to other group     | 0.7 b host-id id=ROMA; " + TO_GROUP + NOT_FOR_US + END + "accepted",
            "part of broadcast  | " + OF_ALL + "FRAGMENT; " + END + "accepted",
            "only: to all       | " + UNICASTS_ONLY + TO_ALL + NOT_FOR_US + END + "accepted",
            "only: all, blocked | " + UNICASTS_ONLY + TO_ALL + BLOCKED + END + "accepted",
            "only: takes all's  | " + UNICASTS_ONLY + TO_ALL + QUEUED + END
                    + "b tells QUEUED of a broadcast of ROMA; expected radioNotForUs, as it has sealed unicasts only",
            "only: not told     | " + UNICASTS_ONLY + "1 a>b BROADCAST; " + END
                    + "b has not told what became of a broadcast",
            "only: to group     | " + UNICASTS_ONLY + TO_GROUP + NOT_FOR_US + END + "accepted",
            "only: takes group's| " + UNICASTS_ONLY + TO_GROUP + QUEUED + END + "expected radioNotForUs, as it",
            "only: without key  | " + UNICASTS_ONLY + TO_GROUP + "COUNT counter=12; " + END
                    + "expected radioNotForUs, as it",
            "only: its own      | 0.7 b host-id id=ROMA unicastsOnly=true; " + TO_ALL + "COUNT counter=11; " + END
                    + "expected radioNotForUs, as it",
            "only: part to all  | " + UNICASTS_ONLY + OF_ALL + NOT_FOR_US + END + "accepted",
            "only: takes part   | " + UNICASTS_ONLY + OF_ALL + "FRAGMENT; " + END + "expected radioNotForUs, as it",
            "only: part dropped | " + UNICASTS_ONLY + OF_ALL + DROPPED + END + "accepted",
            "only: unicast      | " + UNICASTS_ONLY + HEARD + "1.2405 " + QUEUED + END + "accepted",
            "only: its unicast  | 0.7 b host-id id=SUPO unicastsOnly=true; " + HEARD + "1.2405 " + NOT_FOR_US + END
                    + "expected a packet for another device",
            "only: on after it  | " + UNICASTS_ONLY + "0.8 b fault do=unplug; 0.9 QUIET; " + TO_ALL + NOT_FOR_US + END
                    + "accepted",
            "other sketch       | " + UNICASTS_ONLY + "0.71 b reset why=power; 0.72 b host-id id=SUPP; 0.73 QUIET; "
                    + TO_ALL + QUEUED + END + "accepted",
            "not taken yet      | " + HEARD + "1.2405 " + QUEUED + "2 a>b UNICAST; 2.2405 " + REPEATS
                    + "3 QUIET | accepted"})
    void fate_isJudged(String what, String story, String verdict) {
        Story.check(FateCheck::new, ON + story, verdict);
    }
}
