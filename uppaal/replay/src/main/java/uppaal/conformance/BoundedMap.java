package uppaal.conformance;

import java.util.LinkedHashMap;
import java.util.Map;

/** A map that forgets what was put in longest ago when it is full, so that hours of traffic do not fill the memory. */
final class BoundedMap<K, V> extends LinkedHashMap<K, V> {
    private static final long serialVersionUID = 1L;
    static final int MOST = 1024;
    private final int most;

    BoundedMap() {
        this(MOST);
    }

    BoundedMap(int most) {
        this.most = most;
    }

    /** Also what is in already is the newest then. */
    @Override
    public V put(K key, V value) {
        V before = remove(key);
        super.put(key, value);
        return before;
    }

    @Override
    protected boolean removeEldestEntry(Map.Entry<K, V> eldest) {
        return size() > most;
    }
}
