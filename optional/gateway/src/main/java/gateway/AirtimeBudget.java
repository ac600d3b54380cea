package gateway;

/** How much of the air may be used: a share of the time, and at most some seconds at once. */
final class AirtimeBudget {

    private final long most;
    private final int percent;
    private double left;
    private long last;

    /**
     * @param most    ms at once.
     * @param percent of the time.
     */
    AirtimeBudget(long most, int percent, long now) {
        this.most = most;
        this.percent = percent;
        left = most;
        last = now;
    }

    /** Takes that many ms of the air, unless there are fewer left. */
    boolean take(long millis, long now) {
        left = Math.min(most, left + (now - last) * percent / 100.0);
        last = now;
        if (left < millis) {
            return false;
        }
        left -= millis;
        return true;
    }
}
