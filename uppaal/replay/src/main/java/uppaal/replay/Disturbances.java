package uppaal.replay;

import java.util.ArrayList;
import java.util.List;

/**
 * When boards may hear what the trace does not tell, or not hear what it tells: noise, jams, packets that break off.
 */
final class Disturbances {
    private record Span(double from, double to) {}

    private final List<Span> spans = new ArrayList<>();

    void add(double from, double to) {
        spans.add(new Span(from, to));
    }

    boolean none(double from, double to) {
        return spans.stream().noneMatch(span -> span.from <= to && from <= span.to);
    }

    /** What ended before then concerns nobody any more. */
    void forget(double before) {
        spans.removeIf(span -> span.to < before);
    }
}
