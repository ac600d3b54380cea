package gateway;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import java.util.stream.Collectors;

/** The counters of a gateway. */
final class Tallies {

    private final Map<Tally, Long> values = new EnumMap<>(Tally.class);

    synchronized void count(Tally tally) {
        values.merge(tally, 1L, Long::sum);
    }

    synchronized long of(Tally tally) {
        return values.getOrDefault(tally, 0L);
    }

    /** All of them as a JSON object in one line. */
    synchronized String json() {
        return Arrays.stream(Tally.values()).map(tally -> "\"" + tally + "\":" + of(tally))
                .collect(Collectors.joining(",", "{", "}"));
    }
}
