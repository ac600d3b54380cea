package gateway;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import java.util.stream.Collectors;

/** The counters of a gateway. */
final class GatewayCounters {

    private final Map<GatewayCounter, Long> values = new EnumMap<>(GatewayCounter.class);

    synchronized void count(GatewayCounter counter) {
        values.merge(counter, 1L, Long::sum);
    }

    synchronized long of(GatewayCounter counter) {
        return values.getOrDefault(counter, 0L);
    }

    /** All of them as a JSON object in one line. */
    synchronized String json() {
        return Arrays.stream(GatewayCounter.values()).map(counter -> "\"" + counter + "\":" + of(counter))
                .collect(Collectors.joining(",", "{", "}"));
    }
}
