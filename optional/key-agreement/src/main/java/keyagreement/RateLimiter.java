package keyagreement;

/**
 * Lets something be done now and then. When it may be done again is drawn: so nobody knows the moment, and nobody can
 * be first each time.
 */
final class RateLimiter {

    /** From one to the next, at least, and up to twice that as a random part. */
    static final int GAP_MILLIS = 1000;

    private final Shared shared;
    private long next = Long.MIN_VALUE;

    RateLimiter(Shared shared) {
        this.shared = shared;
    }

    /** Whether it may be done now; if so, it counts as done. */
    boolean take(long now) {
        if (now < next) {
            shared.count(Event.LIMITED);
            return false;
        }
        next = now + GAP_MILLIS + shared.random().nextInt(2 * GAP_MILLIS);
        return true;
    }
}
