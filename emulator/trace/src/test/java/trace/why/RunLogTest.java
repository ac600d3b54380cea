package trace.why;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RunLogTest {

    private static final String PERCEPTS =
            "{\"t\":%s,\"board\":\"a\",\"event\":\"percepts\",\"percepts\":[\"light(%d)\"]}";

    @TempDir
    private Path folder;
    private final RunLog log = new RunLog(1000);

    private void add(double t, String more) {
        log.add(() -> "{\"t\":" + t + ",\"event\":\"agent-" + more);
    }

    /** A line of the trace, told when the clock shows a little less; its answer comes when it shows that. */
    private String clock(String t, String own) throws IOException {
        Queue<Double> shows = new ArrayDeque<>(List.of(Double.parseDouble(own) - 0.25, Double.parseDouble(own)));
        List<String> told = new ArrayList<>();
        log.show(shows::remove, command -> told.add(command.get("state").toString()));
        return "{\"t\":" + t + ",\"event\":\"transition\",\"machine\":\"clock\",\"host\":\"agents\",\"state\":\""
                + told.get(0) + "\"}";
    }

    /** The log by that trace, without what the emulator tells of clocks. */
    private List<String> written(String... trace) throws IOException {
        Path file = Files.write(folder.resolve("trace.jsonl"), List.of(trace));
        log.write(file, folder.resolve("run.jsonl"));
        return Files.readAllLines(folder.resolve("run.jsonl")).stream().filter(line -> !line.contains("clock"))
                .toList();
    }

    @Test
    void write_agentsOfAnotherClock_getTheBoardsTimeAndNoneTooEarly() throws Exception {
        add(1001.5, "prints\"}");
        add(1002, "event\"}");
        add(1003, "event\",\"n\":2}");
        add(1009, "event\",\"n\":3}");
        String first = PERCEPTS.formatted("1.5", 1);
        String second = PERCEPTS.formatted("2.1", 2);

        // The emulator lags behind at 1001, and stands still from 1002 to 1003; the last line is cut off.
        assertEquals(List.of(first, "{\"t\":1.5,\"event\":\"agent-prints\"}", "{\"t\":2.0,\"event\":\"agent-event\"}",
                "{\"t\":2.0,\"event\":\"agent-event\",\"n\":2}", second,
                "{\"t\":8.0,\"event\":\"agent-event\",\"n\":3}"),
                written(clock("0.0", "1000.000000"), clock("0.9", "1001.000000"), first, clock("2.0", "1002.000000"),
                        clock("2.0", "1003.000000"), second, clock("7.0", "1008.000000"), "{\"t\":3.4,\"ev"));
    }

    @Test
    void write_withoutABoardsTrace_countsFromTheBeginning() throws Exception {
        add(1001.25, "event\"}");
        log.write(folder.resolve("none"), folder.resolve("run.jsonl"));
        assertEquals(List.of("{\"t\":1.25,\"event\":\"agent-event\"}"),
                Files.readAllLines(folder.resolve("run.jsonl")));
    }

    /** Lines by which others are understood stay; one that cannot be made is counted. */
    @Test
    void write_moreLinesThanAreKept_countsThoseThatAreGone() throws Exception {
        add(1000, "plan\"}");
        for (int i = 0; i < RunLog.KEPT_LINES + 1000; i++) {
            add(1002, "event\"}");
        }
        log.add(() -> {
            throw new IllegalStateException("its agent goes on meanwhile");
        });
        List<String> lines = written();
        assertEquals(
                List.of("{\"t\":0.0,\"event\":\"agent-plan\"}", "{\"t\":2.0,\"event\":\"left-out\",\"lines\":1000}",
                        "{\"t\":2.0,\"event\":\"agent-event\"}"),
                lines.subList(0, 3));
        assertEquals(RunLog.KEPT_LINES + 3, lines.size());
    }
}
