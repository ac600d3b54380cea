package javino;

import java.util.Collections;
import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * How often each of some events has happened. For any thread.
 *
 * @param <E> the events.
 */
public final class Counts<E extends Enum<E>> {

    private final Map<E, Long> counts = new ConcurrentHashMap<>();

    /** Counts an event. */
    public void count(E event) {
        counts.merge(event, 1L, Long::sum);
    }

    /** How often an event has happened. */
    public long of(E event) {
        return counts.getOrDefault(event, 0L);
    }

    /** How often each of all events has happened, in their order. */
    public Map<E, Long> all(Class<E> events) {
        Map<E, Long> all = new EnumMap<>(events);
        for (E event : events.getEnumConstants()) {
            all.put(event, of(event));
        }
        return Collections.unmodifiableMap(all);
    }
}
