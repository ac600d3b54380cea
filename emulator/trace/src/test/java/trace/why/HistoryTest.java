package trace.why;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import trace.TraceEvent;

class HistoryTest {

    private static TraceEvent event(double t, String name, String more) {
        return TraceEvent.parse(0, "{\"t\":%s,\"event\":\"%s\"%s}".formatted(t, name, more));
    }

    private static List<TraceEvent> actions(String name, double... times) {
        return IntStream.range(0, times.length).mapToObj(n -> event(times[n], name,
                ",\"board\":\"b\",\"agent\":\"A\",\"request\":" + n + ",\"action\":\"go\"")).toList();
    }

    @Test
    void boardOf_isThatAtTheAgentsPort() {
        History history = new History(List.of(
                event(0, "scenario",
                        ",\"boards\":[{\"name\":\"one\",\"port\":\"a/usb\"},{\"name\":\"two\",\"port\":\"b/usb\"},"
                                + "{\"name\":\"three\",\"port\":\"bot\"},{\"name\":\"four\",\"port\":\"robot\"}]"),
                event(0, "agent-settings", ",\"agent\":\"A\",\"port\":\"/tmp/b/usb\""),
                event(0, "agent-settings", ",\"agent\":\"B\",\"port\":\"ports/robot\"")));

        assertEquals("two", history.boardOf("A"));
        assertEquals("four", history.boardOf("B"));
    }

    @Test
    void same_ofALogWithoutItsBeginning_countsFromTheEnd() {
        List<TraceEvent> boards = actions("host-action", 1.1, 2.1, 3.1);
        List<TraceEvent> all = actions("agent-action", 1, 2, 3);
        List<TraceEvent> last = all.subList(1, 3);
        History whole = new History(Stream.concat(boards.stream(), all.stream()).toList());
        History part = new History(Stream.of(boards, List.of(event(2, RunLog.LEFT_OUT, ",\"lines\":7")), last)
                .flatMap(List::stream).toList());

        for (int n = 0; n < 3; n++) {
            assertEquals(Optional.of(all.get(n)), whole.same(boards.get(n), boards, all));
            assertEquals(Optional.of(all.get(n)).filter(last::contains), part.same(boards.get(n), boards, last));
        }
        assertEquals(Optional.of(boards.get(2)), part.same(last.get(1), last, boards));
    }
}
