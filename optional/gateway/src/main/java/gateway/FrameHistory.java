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
        /**
         * Frames that another gateway of this cell has to relay are on the air within so long: none keeps one longer.
         */
        private static final long ECHO_MILLIS = Router.LIFE_MILLIS + 3000;

        /** So long, at most, a sender lets pass between two attempts: its time-outs count quiet air only. */
        private static final long ATTEMPTS_MILLIS = 60_000;

        private static final long NEVER = Long.MIN_VALUE / 2;

        private final Map<String, Integer> arrivals = new HashMap<>();
        private int onAir;
        private long last;
        private long lastRelay = NEVER;
        private long lastOwn = NEVER;
        private int attempts;
        private long lastAttempt = NEVER;

        private void expire(long now) {
            if (now - last > ROUND_MILLIS) {
                arrivals.clear();
                onAir = 0;
            }
        }

        private void seen(long now) {
            expire(now);
            last = now;
        }

        /**
         * It was heard here. Tells whether that is a gateway's doing: one of this cell has it to relay, and its
         * origin was not heard with it before that. (Otherwise an attacker who copies frames could stop all repeats.)
         */
        boolean isEcho(long now) {
            if (now - lastRelay < ECHO_MILLIS && now - lastOwn >= ECHO_MILLIS) {
                return true;
            }
            lastOwn = now;
            return false;
        }

        /** Whether a broadcast may be a relay's copy, as its origin has just sent it here. */
        boolean mayBeCopy(long now) {
            return now - lastAttempt < ROUND_MILLIS;
        }

        /** Its origin has sent it here once more: for the n-th time, which is told. */
        int attempted(long now) {
            attempts = now - lastAttempt > ATTEMPTS_MILLIS ? 1 : attempts + 1;
            lastAttempt = now;
            return attempts;
        }

        /** It is on the air here once more. */
        void onAir(long now) {
            seen(now);
            onAir++;
        }

        /**
         * The number of the attempt of another cell that comes now. It is 0 for one of no use:
         * <ol>
         * <li>it has come before, by another gateway or topic, or twice by the broker;</li>
         * <li>too many cells tell of it;</li>
         * <li>it was on the air here that often already.</li>
         * </ol>
         *
         * @param attempt how often it was heard there; 0 if that is not said: then it is one more.
         */
        int next(String cell, int attempt, long now) {
            expire(now);
            int before = arrivals.getOrDefault(cell, 0);
            int nth = attempt == 0 ? before + 1 : attempt;
            return nth <= before || before == 0 && arrivals.size() == MOST_CELLS || nth <= onAir ? 0 : nth;
        }

        /** A gateway of this cell is about to send it. A frame that has only come, and is never sent, has no echo. */
        void relayed(long now) {
            lastRelay = now;
        }

        /** How often it has yet to be on the air here, until it was so for the n-th time. */
        int missing(int nth) {
            return nth - onAir;
        }

        /** The n-th attempt of another cell has come. Tells whether nobody else has told of it yet. */
        boolean arrived(String cell, int nth, long now) {
            seen(now);
            arrivals.put(cell, nth);
            return onAir == 0 && arrivals.size() == 1;
        }
    }

    /** The record of a frame; a new one if there is none. */
    Sighting of(Bytes frame) {
        return frames.getOrDefault(frame, new Sighting());
    }

    /** The same; it is remembered from now on. */
    Sighting remember(Bytes frame) {
        Sighting sighting = of(frame);
        frames.renew(frame, sighting);
        return sighting;
    }
}
