package uppaal.conformance;

import java.util.LinkedHashMap;
import java.util.Map;

/** A map that forgets what was used longest ago when it is full, so that hours of traffic do not fill the memory. */
final class BoundedMap<K, V> extends LinkedHashMap<K, V> {
    private static final long serialVersionUID = 1L;
    private static final int MOST = 1024;
    private final int most;

    BoundedMap() {
        this(MOST);
    }

    BoundedMap(int most) {
        super(MOST, 1, true);
        this.most = most;
    }

    @Override
    protected boolean removeEldestEntry(Map.Entry<K, V> eldest) {
        return size() > most;
    }
}
