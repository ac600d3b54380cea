package uppaal.replay;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** What is on the air at a board, as the trace tells it; and the ends of messages there that must hear of it. */
final class Ear {
    private static final int SLOT_BITS = 16;
    private static final int RATE = 2000;
    /** Where a board's bit rate is as far from that, times are not held to the model's numbers. */
    private static final double OTHER_RATE = 0.1;
    private static final double HALF_A_BIT = 0.5;

    /**
     * A carrier begins or ends.
     *
     * @param number rises with each at a board
     * @param name as in delivery.xml
     * @param begins whether it begins
     * @param owner the end that sends, if one of this board does; else null
     */
    record Sound(long number, double seconds, String name, boolean begins, End owner) {}

    private final Disturbances disturbances;
    /** All since the last quiet before the last carrier. */
    private final Deque<Sound> latest = new ArrayDeque<>();
    private final Set<End> awake = new LinkedHashSet<>();
    private int carriers;
    private long sounds;
    /** Bits a second. */
    private double rate = RATE;
    /** Whether its board writes down what its host has taken, so that it may look late at what has come. */
    private boolean busy;
    /** Whether it has sent, so that its rate is known. */
    private boolean known;
    /** Whether it sends by a serial module, whose times are others than the model's. */
    private boolean module;

    Ear(Disturbances disturbances) {
        this.disturbances = disturbances;
    }

    void useModule() {
        module = true;
    }

    void busy(boolean now) {
        busy = now;
    }

    boolean isBusy() {
        return busy;
    }

    /** Seconds a slot. */
    double slot() {
        return SLOT_BITS / rate;
    }

    /** Whether the board's times are those of the model. */
    boolean isTimed() {
        return !module && Math.abs(rate / RATE - 1) < OTHER_RATE;
    }

    /** Whether all is known of what the board has heard between two moments. */
    boolean isSure(double from, double to) {
        return disturbances.none(from, to);
    }

    /** Whether a packet of the board's own is as long as its bits take, by the first one: up to a quarter of a bit. */
    boolean fits(double bits, double seconds) {
        return module || !known || Math.abs(seconds * rate - (bits - 1)) < HALF_A_BIT / 2;
    }

    /**
     * Its own packets tell how fast a board's clock runs; one that may have broken off does so only where nothing is
     * known. The end of the last bit is not told.
     */
    void learn(double bits, double start, double end) {
        if (isSure(start, end) || !known) {
            rate = (bits - 1) / (end - start);
            known = true;
        }
    }

    /** Since when the air is quiet, in seconds; infinite where somebody sends. */
    double quietSince() {
        return carriers > 0 ? Double.POSITIVE_INFINITY
                : latest.isEmpty() ? Double.NEGATIVE_INFINITY : latest.getLast().seconds();
    }

    /**
     * How long the air has been quiet, in slots, before the board begins to send; what has begun less than so many
     * slots ago it does not hear.
     */
    double quietBefore(double seconds, double unheard) {
        int open = 0;
        double since = Double.NEGATIVE_INFINITY;
        for (Sound sound : latest) {
            if (sound.begins()) {
                if (open > 0 || sound.seconds() < seconds - unheard * slot()) {
                    open++;
                }
            } else if (open > 0) {
                open--;
                since = sound.seconds();
            }
        }
        return open > 0 ? 0 : (seconds - since) / slot();
    }

    List<Sound> latest() {
        return List.copyOf(latest);
    }

    /** This end must hear what comes, as long as something is due there. */
    void wake(End end) {
        awake.add(end);
    }

    /** Somebody begins to send. */
    void begin(double seconds, String name, End owner) throws RefusedException {
        if (carriers++ == 0) {
            prune();
        }
        tell(new Sound(sounds++, seconds, name, true, owner));
    }

    /** Somebody has ended to send. */
    void end(double seconds, String name, End owner) throws RefusedException {
        if (carriers > 0) {
            carriers--;
            tell(new Sound(sounds++, seconds, name, false, owner));
        }
    }

    /** Keeps the last carriers, up to the quiet that is now. */
    private void prune() {
        int open = 0;
        int kept = 0;
        int count = 0;
        for (Sound sound : latest) {
            if (open == 0) {
                kept = count;
            }
            open += sound.begins() ? 1 : -1;
            count++;
        }
        for (; kept > 0; kept--) {
            latest.remove();
        }
    }

    private void tell(Sound sound) throws RefusedException {
        awake.removeIf(end -> !end.isAwake());
        for (End end : List.copyOf(awake)) {
            end.hear(sound);
        }
        latest.add(sound);
    }
}
