package campaign;

/** The longest time in which a count did not rise. */
final class Pace {

    private long count;
    private double since = Double.NaN;
    private double longest;

    /** Takes notice of the count at a time; times rise. */
    synchronized void see(double seconds, long now) {
        if (now != count || Double.isNaN(since)) {
            since = seconds;
        }
        count = now;
        longest = Math.max(longest, seconds - since);
    }

    /** The longest time without a change of the count, in seconds. */
    synchronized double longest() {
        return longest;
    }
}
