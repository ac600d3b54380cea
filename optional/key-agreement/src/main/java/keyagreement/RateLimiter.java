package keyagreement;

import java.util.Random;

/**
 * Lets something be done now and then. When it may be done again is drawn: so nobody knows the moment, and nobody can
 * be first each time.
 */
final class RateLimiter {

    /** From one to the next, at least, and up to twice that as a random part. */
    static final int GAP_MILLIS = 1000;

    private final Random random;
    private long next = Long.MIN_VALUE;

    RateLimiter(Random random) {
        this.random = random;
    }

    /** Whether it may be done now; if so, it counts as done. */
    boolean take(long now) {
        boolean permitted = now >= next;
        next = permitted ? now + GAP_MILLIS + random.nextInt(2 * GAP_MILLIS) : next;
        return permitted;
    }
}
