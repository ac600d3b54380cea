package live;

import java.util.Map;
import java.util.TreeMap;
import javino.protocol.Counter;

/** A board's counters as the page has them. */
final class Counters {

    private Counters() {
    }

    /** Those that a page shows: all that are not 0, but for the requests, which each question makes more. */
    static Map<String, Long> told(Map<Counter, Long> counters) {
        Map<String, Long> told = new TreeMap<>();
        counters.forEach((counter, value) -> {
            if (value != 0 && counter != Counter.SERIAL_REQUESTS) {
                told.put(counter.toString(), value);
            }
        });
        return told;
    }
}
