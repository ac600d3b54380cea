package gateway;

import java.util.List;

/** How much of the air may be used: a share of the time, and at most some seconds at once. */
final class AirtimeBudget {

    private final long most;
    private final int percent;
    private double left;
    private long last;

    /**
     * @param most    ms at once.
     * @param percent share of the time.
     */
    AirtimeBudget(long most, int percent, long now) {
        this.most = most;
        this.percent = percent;
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
        left = Math.min(most, left + (now - last) * percent / 100.0);
        last = now;
    }
}
