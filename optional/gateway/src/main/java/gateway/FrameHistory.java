package gateway;

import java.util.HashMap;
import java.util.Map;
import javino.protocol.Bytes;

/**
 * The frames of the last seconds: how often each was on the air here, and how often it came from where.
 *
 * <p>A sender repeats the same bytes until it hears an acknowledgement. So they may have to pass again, and only the
 * numbers tell a repeat from a copy by another way.
 */
final class FrameHistory {

    private static final int MOST = 2048;
    private static final int MOST_CELLS = 8;

    private final BoundedMap<Bytes, Sighting> frames = new BoundedMap<>(MOST);

    /** One frame. */
    static final class Sighting {

        /** After so much silence the same bytes are a new message: copies by other ways are not that late. */
        private static final long ROUND_MILLIS = 3000;
        /** What came from another cell is on the air here within so long: a gateway keeps nothing for longer. */
        private static final long ECHO_MILLIS = Router.LIFE_MILLIS + 3000;

        private static final long NEVER = Long.MIN_VALUE / 2;

        private final Map<String, Integer> arrivals = new HashMap<>();
        private int onAir;
        private long last;
        private long lastArrival = NEVER;
        private long lastOwn = NEVER;

        private void seen(long now) {
            if (now - last > ROUND_MILLIS) {
                arrivals.clear();
                onAir = 0;
            }
            last = now;
        }

        /**
         * It was heard here. Tells whether that is a gateway's doing: it has just come from another cell, and its
         * origin was not heard with it before that. (Who copies frames could stop all repeats otherwise.)
         */
        boolean isEcho(long now) {
            if (now - lastArrival < ECHO_MILLIS && now - lastOwn >= ECHO_MILLIS) {
                return true;
            }
            lastOwn = now;
            return false;
        }

        /** It is on the air here once more: for the n-th time, which is told. */
        int onAir(long now) {
            seen(now);
            return ++onAir;
        }

        /**
         * It has come from another cell.
         *
         * @param attempt how often it was heard there; 0 if that is not said: then it is one more.
         * @return which attempt it is; 0 if that has come before, by another gateway or topic, or twice by the broker,
         * or if too many cells tell of it.
         */
        int arrived(String cell, int attempt, long now) {
            seen(now);
            lastArrival = now;
            int before = arrivals.getOrDefault(cell, 0);
            int nth = attempt == 0 ? before + 1 : attempt;
            if (nth <= before || before == 0 && arrivals.size() == MOST_CELLS) {
                return 0;
            }
            arrivals.put(cell, nth);
            return nth;
        }

        /** Whether nobody has told of it yet but one cell. */
        boolean isNew() {
            return onAir == 0 && arrivals.size() == 1;
        }

        /** Whether a cell's n-th attempt stands for one that has not been on the air here. */
        boolean lacks(int nth) {
            return nth > onAir;
        }
    }

    Sighting of(Bytes frame) {
        Sighting sighting = frames.get(frame);
        if (sighting == null) {
            sighting = new Sighting();
        }
        frames.renew(frame, sighting);
        return sighting;
    }
}
