package trace.why;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;
import trace.MalformedEventException;
import trace.TraceEvent;

/**
 * The log of a run that goes on: the last lines of its boards' trace and of its agents that {@link Why} needs. An
 * agent's lines may come before those of what it has read, as they take another way.
 */
public final class LiveLog {

    /** Of the trace's lines, and of the agents'. */
    public static final int MOST_LINES = RunLog.MOST_LINES;
    private static final Set<String> OF_TRACE = Set.of("scenario", "pin", "command", "fault", "port", "reset", "place",
            "percepts", "rf-tx", "rf-rx", "rf-damaged", "host-action", "host-transmit", "host-handed");
    private static final Set<String> POINTS = Set.of("TURN", "QUEUED", "COUNT");
    /** What has been so since the beginning. */
    private static final Set<String> LASTING =
            Set.of("scenario", "place", "agent-plan", "agent-settings", "agent-believes");
    private static final int MOST_LASTING = 2000;
    /** So much later than the trace's is the place of an agent's line, in ns: longer than the trace's way takes. */
    private static final long AGENTS_LATER = 1_000_000_000;

    /** A line, and its place among all. */
    private record Line(long at, TraceEvent event) {}

    private final Deque<Line> trace = new ArrayDeque<>();
    private final Deque<Line> agents = new ArrayDeque<>();
    /** By what they tell of. */
    private final Map<String, Line> lasting = new LinkedHashMap<>();
    private final Ordinals ordinals = new Ordinals();

    /**
     * Takes a line; one that lacks what its kind has is left out.
     *
     * @param nanos when it came.
     */
    public synchronized void add(TraceEvent event, long nanos) {
        try {
            take(event, nanos);
        } catch (MalformedEventException | IllegalStateException none) {
            // Nobody can ask of it.
            return;
        }
    }

    private void take(TraceEvent event, long nanos) {
        boolean ofAgent = event.name().startsWith("agent-") || History.PRINTS.contains(event.name());
        if (!ofAgent && !OF_TRACE.contains(event.name())
                && !(event.is("point") && POINTS.contains(event.text("name")))) {
            return;
        }
        Line line = new Line(ofAgent ? nanos + AGENTS_LATER : nanos, ordinals.number(event));
        if (LASTING.contains(event.name())) {
            if (lasting.size() < MOST_LASTING || lasting.containsKey(key(event))) {
                lasting.put(key(event), line);
            }
            return;
        }
        Deque<Line> lines = ofAgent ? agents : trace;
        lines.add(line);
        if (lines.size() > MOST_LINES) {
            lines.remove();
        }
    }

    private static String key(TraceEvent event) {
        String agent = event.textOrEmpty("agent");
        return String.join(" ", event.name(), event.board(), agent, event.textOrEmpty("place"),
                event.textOrEmpty("trigger"), event.textOrEmpty("belief"));
    }

    /** Forgets what these agents have told: they are recorded anew, and number anew. */
    public synchronized void forget(Predicate<String> which) {
        Predicate<Line> its = line -> line.event.has("agent") && which.test(line.event.text("agent"));
        agents.removeIf(its);
        lasting.values().removeIf(its);
        ordinals.forget(which);
    }

    /** All lines, in their order. */
    public synchronized List<TraceEvent> events() {
        List<Line> all = new ArrayList<>();
        Stream.of(lasting.values(), trace, agents).forEach(all::addAll);
        all.sort(Comparator.comparingLong(Line::at));
        return all.stream().map(Line::event).toList();
    }
}
