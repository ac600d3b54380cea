package javino.board;

import java.util.Collections;
import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLongArray;

/** The counters of a session, for any thread. */
final class SessionCounters {

    private final AtomicLongArray values = new AtomicLongArray(SessionCounter.values().length);

    void count(SessionCounter counter) {
        values.incrementAndGet(counter.ordinal());
    }

    Map<SessionCounter, Long> snapshot() {
        Map<SessionCounter, Long> snapshot = new EnumMap<>(SessionCounter.class);
        for (SessionCounter counter : SessionCounter.values()) {
            snapshot.put(counter, values.get(counter.ordinal()));
        }
        return Collections.unmodifiableMap(snapshot);
    }
}
