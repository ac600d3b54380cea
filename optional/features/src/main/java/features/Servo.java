package features;

/** Where a servo stands, by the pulses at its pin, as Arduino's library Servo gives them. */
final class Servo {

    /** Of a pulse for 0 and for 180 degrees, in ns. */
    private static final long LEAST = 544_000;
    private static final long MOST = 2_400_000;
    private static final int HALF_TURN = 180;
    /** Interrupts lengthen pulses by as much. */
    private static final int NEAR = 3;
    /** The pulses of a servo come each 20 ms; a tone's are nearer. */
    private static final long LEAST_PERIOD = 10 * Window.MILLI;
    private static final int UNKNOWN = -1000;

    private long rise;
    private long period;
    private long degrees = UNKNOWN;

    /** Its pin has changed. @return whether the servo turns. */
    boolean turns(long nanos, boolean on) {
        if (on) {
            period = nanos - rise;
            rise = nanos;
            return false;
        }
        long at = Math.round((nanos - rise - LEAST) * (double) HALF_TURN / (MOST - LEAST));
        if (period < LEAST_PERIOD || at < -NEAR || at > HALF_TURN + NEAR || isAt(at)) {
            return false;
        }
        degrees = Math.min(Math.max(at, 0), HALF_TURN);
        return true;
    }

    boolean isAt(long angle) {
        return near(angle, degrees);
    }

    /** Whether two angles are the same, as far as can be seen. */
    static boolean near(long one, long other) {
        return Math.abs(one - other) <= NEAR;
    }

    boolean isKnown() {
        return degrees != UNKNOWN;
    }

    @Override
    public String toString() {
        return isKnown() ? degrees + " degrees" : "nowhere, as no pulses of a servo came";
    }
}
