package gateway;

import java.util.List;

/**
 * How much of the air may be used: a share of each hour, and at most some seconds at once. What fills it within an hour
 * and what it holds at its beginning are that share together: as a board's own limit has it, and as laws count.
 */
final class AirtimeBudget {

    private static final double HOUR_MILLIS = 3_600_000;

    private final long most;
    private final double rate;
    private double left;
    private long last;

    /**
     * @param most    ms at once, less than that share of an hour.
     * @param percent share of each hour.
     */
    AirtimeBudget(long most, int percent, long now) {
        this.most = most;
        rate = percent / 100.0 - most / HOUR_MILLIS;
        left = most;
        last = now;
    }

    /** Takes that many ms of the air, unless there are fewer left. */
    boolean take(long millis, long now) {
        return takeOfAll(List.of(this), millis, now);
    }

    /** Takes that many ms of each, unless one has fewer left: then of none, so nothing pays for what is not sent. */
    static boolean takeOfAll(List<AirtimeBudget> budgets, long millis, long now) {
        budgets.forEach(budget -> budget.fill(now));
        if (budgets.stream().anyMatch(budget -> budget.left < millis)) {
            return false;
        }
        budgets.forEach(budget -> budget.left -= millis);
        return true;
    }

    private void fill(long now) {
        left = Math.min(most, left + (now - last) * rate);
        last = now;
    }
}
