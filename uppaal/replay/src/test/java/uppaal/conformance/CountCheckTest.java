package uppaal.conformance;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CountCheckTest {
    /** Counters of SPEC 4.5, of radioAcknowledged, radioUndelivered, radioResent, radioDeferred, radioStale, … */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "1 COUNT counter=22; 1 DELIVERED | accepted",
            "1 DELIVERED | b declares DELIVERED; expected COUNT of radioAcknowledged before",
            "1 COUNT counter=22; 1 UNDELIVERED | expected no COUNT of radioAcknowledged before",
            "1 COUNT counter=22; 1 QUIET | no COUNT of radioAcknowledged",
            "1 UNDELIVERED | accepted",
            "1 TAKE_UP key=0; 1.1 COUNT counter=23; 1.1 UNDELIVERED | accepted",
            "1 TAKE_UP key=0; 1.1 UNDELIVERED | COUNT of radioUndelivered before",
            "1 TAKE_UP key=0; 2 SEND pending=1; 3 COUNT counter=25; 3 SEND pending=1 | accepted",
            "1 TAKE_UP key=0; 2 SEND pending=3; 3 SEND pending=2; 4 COUNT counter=25; 4 SEND pending=2 | accepted",
            "1 TAKE_UP key=0; 2 SEND pending=1; 3 SEND pending=1 | COUNT of radioResent before",
            "1 TAKE_UP key=0; 2 COUNT counter=25; 2 SEND pending=1 | no COUNT of radioResent",
            "1 TAKE_UP key=0; 2 SEND pending=1; 3 RESEAL key=0; 4 SEND pending=1 | accepted",
            "1 OWE_STALE nonce=0 key=1; 1 COUNT counter=27 | accepted",
            "1 OWE_STALE nonce=0 key=1; 1 QUIET | expected COUNT of radioStale",
            "1 COUNT counter=27 | expected what it counts so before",
            "1 RELAY_COPY place=1; 1 COUNT counter=36 | expected COUNT of relayCopies",
            "1 COUNT counter=36; 1 QUIET | accepted",
            "1 CONTEND slots=9; 2 BUSY; 2 COUNT counter=26; 3 CONTEND slots=2; 4 QUIET; 5 BUSY; 6 QUIET | accepted",
            "1 CONTEND slots=9; 2 BUSY; 3 QUIET | b declares QUIET; expected COUNT of radioDeferred before",
            "1 CONTEND slots=9; 2 BUSY; 2 COUNT counter=26; 3 SEND pending=3; 3 BUSY; 4 PART_SENT; 5 QUIET; "
                    + "6 BUSY; 7 QUIET | radioDeferred",
            "1 CONTEND slots=9; 2 ANSWER key=1; 2 BUSY; 3 QUIET | accepted",
            "1 CONTEND slots=9; 2 BUSY; 2 PASSED; 3 QUIET | accepted",
            "1 CONTEND slots=9; 2 COPIED; 3 BUSY; 4 QUIET | accepted",
            "1 BUSY; 2 PUT_OFF slots=3 | COUNT of radioDeferred before",
            "1 BUSY; 2 COUNT counter=26; 2 PUT_OFF slots=3 | accepted",
            "1 ANSWER key=1; 1 BUSY; 2 PUT_OFF slots=3 | accepted",
            "1 FRAGMENT; 6.0005 COUNT counter=21; 7 QUIET | accepted",
            "1 FRAGMENT; 2 FRAGMENT; 6.0005 COUNT counter=21; 7.0005 COUNT counter=21; 8 QUIET | accepted",
            "1 FRAGMENT; 5.9 COUNT counter=21; 7 QUIET | no COUNT of radioExpired before, as no fragment came 5 s",
            "1 FRAGMENT; 6.1 COUNT counter=21; 7 QUIET | no COUNT of radioExpired",
            "1 COUNT counter=21; 1 FRAGMENT | accepted",
            "1 QUEUED nonce=0 key=1; 1 QUEUED nonce=0 key=1 | b declares QUEUED; expected it once in a run()",
            "1 HANDED message=0; 1 HANDED message=0 | accepted",
            "1 FRAGMENT gap=0.27; 1 FRAGMENT gap=0.27 | accepted",
            "1 FRAGMENT; 1 FRAGMENT | b declares FRAGMENT; expected it once in a run()",
            "1 HANDED message=0; 1 HANDED message=1; 2 HANDED message=1 | accepted",
            "1 COUNT counter=26; 1 COUNT counter=26 | accepted",
            "1 RELAY_COPY place=1; 2 b reset why=power; 3 QUIET | accepted"})
    void counter_isWithItsPoint(String story, String verdict) {
        Story.check(CountCheck::new, story, verdict);
    }
}
