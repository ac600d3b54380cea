package trace.why;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.util.List;
import org.junit.jupiter.api.Test;
import trace.TraceEvent;

/** A robot that switches its lamp, while its log forgets what is old. */
class LiveLogTest {

    private static final long SECOND = 1_000_000_000;

    private final LiveLog log = new LiveLog();
    private long nanos;

    /** Lines as they come, with their times in s. */
    private void come(double seconds, String... lines) {
        for (String line : lines) {
            log.add(TraceEvent.parse(0, "{\"t\":" + seconds + "," + line.replace('\'', '"') + "}"), nanos);
        }
    }

    private void begin() {
        come(0, "'event':'scenario','boards':[{'name':'robot','port':'ttyRobot'}]",
                "'event':'agent-settings','agent':'one','port':'ports/ttyRobot'");
    }

    /** The agent decides at a time to switch, and the board does so a tenth of a second later. */
    private void switches(int number, double seconds, String answer) {
        decides(number, seconds);
        come(seconds + 0.1, "'event':'pin','board':'robot','pin':13,'name':'lamp','level':" + number % 2);
        come(seconds + 0.2, "'event':'host-action','board':'robot','action':'flip','asked':" + (seconds + 0.1)
                + ",'replied':" + (seconds + 0.2) + ",'done':true");
        come(seconds + 0.2,
                "'event':'agent-performed','agent':'one','request':" + number + ",'error':'" + answer + "'");
    }

    private void decides(int number, double seconds) {
        come(seconds, "'event':'agent-event','agent':'one','number':" + number + ",'trigger':'+turn(" + number
                + ")[source(percept)]'",
                "'event':'agent-choice','agent':'one','number':" + number + ",'trigger':'+turn(" + number
                        + ")','asked':[],'plan':'','place':'a.asl:3','intention':" + number,
                "'event':'agent-action','agent':'one','request':" + number + ",'action':'flip','intention':" + number
                        + ",'plan':'','place':'a.asl:3','step':'flip'");
    }

    private List<String> why(String line) {
        return new Why(log.events()).of(JsonParser.parseString(line.replace('\'', '"')).getAsJsonObject());
    }

    private void assertTurned(int number, double seconds) {
        List<String> answer = why("{'event':'pin','board':'robot','pin':13,'t':" + seconds + "}");
        assertTrue(answer.get(1).endsWith("because of flip, within which the pin changed"), answer::toString);
        assertTrue(answer.get(4).endsWith("for +turn(" + number + ")"), answer::toString);
    }

    @Test
    void pin_isBecauseOfItsOwnAction_alsoWhenOlderLinesAreForgotten() {
        begin();
        for (int i = 1; i < LiveLog.MOST_LINES; i++) {
            switches(i, i, "");
        }

        assertTrue(log.events().size() <= 2 * LiveLog.MOST_LINES + 2);
        assertTurned(LiveLog.MOST_LINES - 1000, LiveLog.MOST_LINES - 1000 + 0.1);
        assertTurned(LiveLog.MOST_LINES - 1, LiveLog.MOST_LINES - 1 + 0.1);
        assertThrows(IllegalArgumentException.class, () -> assertTurned(1, 1.1));
    }

    @Test
    void action_thatNeverReachedTheBoard_isNoneOfItsActions() {
        begin();
        decides(1, 1);
        come(1, "'event':'agent-performed','agent':'one','request':1,'error':'port_off'");
        switches(2, 2, "");

        assertTurned(2, 2.1);
    }

    @Test
    void recording_thatBeginsLater_countsOnFromThere() {
        begin();
        switches(1, 1, "");
        log.forget(agent -> true);
        come(2, "'event':'host-action','board':'robot','action':'flip','asked':1.9,'replied':2,'done':true",
                "'event':'agent-settings','agent':'one','port':'ports/ttyRobot'");
        switches(1, 3, "");

        assertTurned(1, 3.1);
        assertEquals(1, log.events().stream().filter(each -> each.is("agent-action")).count());
        List<String> answer = why("{'event':'pin','board':'robot','pin':13,'t':1.1}");
        assertEquals(
                "first cause: no agent of the log asked for flip: another host did, or it was before the recording",
                answer.get(2));
    }

    @Test
    void agent_whoseLinesComeBeforeThoseOfItsBoard_isToldBehindThem() {
        begin();
        come(1, "'event':'percepts','board':'robot','percepts':['dark']");
        nanos = SECOND;
        come(2, "'event':'percepts','board':'robot','percepts':[]");
        nanos = 2 * SECOND;
        come(2.5, "'event':'agent-event','agent':'one','number':1,'trigger':'+dark[source(percept)]'");
        nanos += SECOND / 2;
        come(3, "'event':'command','do':'sensor','board':'robot','pin':'A0','value':7",
                "'event':'percepts','board':'robot','percepts':['dark']");

        assertEquals(List.of("    3.0000 s  one believes dark", "    3.0000 s  robot's board tells dark",
                "    3.0000 s  the sensor changed before that reading",
                "first cause: the sensor at robot's A0 was set to 7"), new Why(log.events()).answer("dark", ""));
    }

    @Test
    void message_whoseBoardIsToldOfMuchLater_isKnownByItsId() {
        begin();
        come(1, "'event':'agent-message','agent':'one','from':'ROMA','id':'000007','content':'tell;help',"
                + "'how':'passed'");
        nanos = 100 * SECOND;
        come(1, "'event':'point','board':'robot','name':'QUEUED','packet':5",
                "'event':'rf-tx','board':'bus','packet':5,'sealed':true,'kind':'unicast'",
                "'event':'host-handed','board':'robot','number':0,'id':'000007','content':'tell;help'",
                "'event':'percepts','board':'robot','percepts':['dark']");

        List<String> answer = why("{'event':'agent-message','agent':'one'}");
        assertTrue(answer.get(2).endsWith("packet 5 of bus, sealed"), answer::toString);
        come(2, "'event':'agent-event','agent':'one','number':1,'trigger':'+dark[source(percept)]'");
        assertTrue(new Why(log.events()).answer("dark", "").get(1).endsWith("robot's board tells dark"));
    }

    @Test
    void loop_ofGoals_hasAnEnd() {
        begin();
        for (int i = 1; i < LiveLog.MOST_LINES / 2; i++) {
            come(i, "'event':'agent-event','agent':'one','number':" + i + ",'trigger':'+!go','intention':" + i
                    + ",'plan':'','place':'a.asl:1','step':'!!go'",
                    "'event':'agent-choice','agent':'one','number':" + i + ",'trigger':'+!go','asked':[],'plan':'',"
                            + "'place':'a.asl:1','intention':" + (i + 1));
        }

        List<String> answer = why("{'event':'agent-event','number':" + (LiveLog.MOST_LINES / 2 - 1) + "}");
        assertEquals("first cause: and so on: the plan (a.asl:1) comes back to itself", answer.get(answer.size() - 1));
    }

    @Test
    void line_thatNobodyHasTold_isNotThere() {
        come(0, "'event':'scenario','boards':[7]", "'event':'point','board':'robot'", "'event':'agent-action'");
        begin();
        JsonObject line = new JsonObject();
        line.addProperty("event", "pin");
        assertEquals("the log does not have that line, or no longer: ask for what is newer",
                assertThrows(IllegalArgumentException.class, () -> new Why(log.events()).of(line)).getMessage());
    }
}
