package javino.board;

import java.time.Duration;
import javino.link.Time;

/** A moment on the monotonic clock of a time. */
record Deadline(Time time, long nanos) {

    static Deadline in(Duration duration, Time time) {
        return new Deadline(time, time.nanos() + duration.toNanos());
    }

    long nanosLeft() {
        return nanos - time.nanos();
    }

    Deadline orBefore(Deadline other) {
        return nanos - other.nanos < 0 ? this : other;
    }

    Deadline later(long byNanos) {
        return new Deadline(time, nanos + byNanos);
    }

    boolean passed() {
        return nanosLeft() <= 0;
    }
}
