package trace.why;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.stream.Stream;
import trace.TraceEvent;
import trace.TraceReader;

/** The run's log, {@code build/run.jsonl}: the boards' trace and the last lines of the agents, in the order of time. */
public final class RunLog {

    /** Of the agents' lines; older ones are forgotten, but for their plans and settings. */
    public static final int MOST_LINES = 10_000;

    private final Deque<String> lines = new ArrayDeque<>();
    private final List<String> kept = new ArrayList<>();

    /** Takes a line of an agent. */
    public synchronized void add(String line) {
        lines.add(line);
        if (lines.size() > MOST_LINES) {
            String oldest = lines.remove();
            if (oldest.contains("\"event\":\"agent-plan\"") || oldest.contains("\"event\":\"agent-settings\"")) {
                kept.add(oldest);
            }
        }
    }

    /** All events of a run. @param trace the boards', if there is one. */
    public synchronized List<TraceEvent> merged(Path trace) throws IOException {
        boolean none = !Files.exists(trace) || Files.size(trace) == 0;
        List<TraceEvent> all = new ArrayList<>(none ? List.of() : TraceReader.all(trace));
        Stream.of(kept, lines).flatMap(Collection::stream).forEach(line -> all.add(TraceEvent.parse(0, line)));
        all.sort(Comparator.comparingDouble(TraceEvent::seconds));
        return all;
    }
}
