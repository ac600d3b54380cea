package highway;

/** Emulated time, as far as it can be told from outside: what the trace said last, and the time since then. */
final class Clock {

    private double lastSeconds;
    private long lastNanos = System.nanoTime();

    /** An event of the trace has told the emulated time. */
    synchronized void set(double seconds) {
        lastSeconds = seconds;
        lastNanos = System.nanoTime();
    }

    /** Emulated seconds now; exact when an event has just come. */
    synchronized double seconds() {
        return lastSeconds + (System.nanoTime() - lastNanos) / 1e9;
    }
}
