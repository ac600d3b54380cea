package trace.why;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import trace.TraceEvent;
import trace.TraceReader;

/** The run's log, {@code build/run.jsonl}: the boards' trace and the last lines of the agents, in the order of time. */
public final class RunLog {

    /** Of the agents' lines; older ones are forgotten, but for the plans and settings at the beginning. */
    public static final int MOST_LINES = 10_000;
    private static final Pattern KEPT = Pattern.compile("\"event\":\"agent-(plan|settings|believes)\"");
    private static final int MOST_KEPT = 1000;

    private final Deque<Supplier<String>> lines = new ArrayDeque<>();
    private final List<String> kept = new ArrayList<>();

    /** Takes a line of an agent, whose text is made when the log is read. */
    public synchronized void add(Supplier<String> line) {
        lines.add(line);
        if (lines.size() > MOST_LINES) {
            Supplier<String> oldest = lines.remove();
            if (kept.size() < MOST_KEPT) {
                keep(oldest.get());
            }
        }
    }

    private void keep(String line) {
        kept.add(KEPT.matcher(line).find() ? line : "");
    }

    /** Makes the texts of all lines until now, while the agents can. */
    public synchronized void settle() {
        List<String> texts = lines.stream().map(Supplier::get).toList();
        lines.clear();
        texts.forEach(text -> lines.add(() -> text));
    }

    /** All events of a run. @param trace the boards', if there is one. */
    public synchronized List<TraceEvent> merged(Path trace) throws IOException {
        boolean none = !Files.exists(trace) || Files.size(trace) == 0;
        List<TraceEvent> all = new ArrayList<>(none ? List.of() : TraceReader.all(trace));
        Stream.concat(kept.stream().filter(line -> !line.isEmpty()), lines.stream().map(Supplier::get))
                .forEach(line -> all.add(TraceEvent.parse(0, line)));
        all.sort(Comparator.comparingDouble(TraceEvent::seconds));
        return all;
    }
}
