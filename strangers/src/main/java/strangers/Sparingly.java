package strangers;

import java.util.LinkedHashMap;
import java.util.Map;
import javino.protocol.Address;

/** Lets something be done now and then: so often for each device, and so often for all together. */
final class Sparingly {

    /** From one answer to a device to the next, and from one answer to the next, at least. */
    static final long ORIGIN_GAP_MILLIS = 5000;
    static final long BOARD_GAP_MILLIS = 2000;
    private static final int MOST = 64;
    private static final long NEVER = Long.MIN_VALUE / 2;

    private final Map<Address, Long> last = new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Address, Long> eldest) {
            return size() > MOST;
        }
    };
    private long any = NEVER;

    /** Whether it may be done now; if so, it counts as done. */
    boolean take(Address origin, long now) {
        if (now - any < BOARD_GAP_MILLIS || now - last.getOrDefault(origin, NEVER) < ORIGIN_GAP_MILLIS) {
            return false;
        }
        any = now;
        last.remove(origin);
        last.put(origin, now);
        return true;
    }
}
