package javino.board;

import java.time.Duration;

/** A moment on the monotonic clock. */
record Deadline(long nanos) {

    static Deadline in(Duration duration) {
        return new Deadline(System.nanoTime() + duration.toNanos());
    }

    long nanosLeft() {
        return nanos - System.nanoTime();
    }

    Deadline orBefore(Deadline other) {
        return nanos - other.nanos < 0 ? this : other;
    }

    Deadline later(long byNanos) {
        return new Deadline(nanos + byNanos);
    }

    boolean passed() {
        return nanosLeft() <= 0;
    }
}
