package javino.board;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javino.protocol.Counter;

/**
 * How much of the last hour a board's radio has sent, which is what laws limit: by the counters that the board's host
 * reads once a minute or so. It adds over boots of the board. What was sent before the first reading is not known, nor
 * what a board sent between the last reading and its boot. For any thread.
 */
public final class AirtimeHour {

    private static final long HOUR = Duration.ofHours(1).toNanos();
    private static final long MINUTE = Duration.ofMinutes(1).toNanos();
    private static final long SECOND = Duration.ofSeconds(1).toNanos();
    private static final double PERMILLE_OF_ALL = 1000;
    private static final double PERMILLE_A_PERCENT = 10;
    /** A small chip counts no further (SPEC 4.5). */
    private static final long SMALL_MOST = 0xFFFF;

    /** At least a minute apart; only the first one may be older than an hour. */
    private final List<Reading> readings = new ArrayList<>();
    private Reading last;
    private long counted;
    private double most;
    private long goesOn;
    private boolean isStopped;

    /** @param sent since the first reading, in s. */
    private record Reading(long nanos, long sent) {
    }

    /**
     * The state at the last reading.
     *
     * @param share percent of the hour before, 0 to 100, in steps of 0.1; also if it was watched for a part of it only.
     * @param most  the most in any hour since the first reading.
     * @param waitSeconds for how many s the board's airtime limit holds back a new message; 0: not at all.
     */
    public record Use(double share, double most, long waitSeconds) {

        /** In percent, with what the board waits for. */
        @Override
        public String toString() {
            return String.format(Locale.ROOT, "%.1f %% of the last hour, at most %.1f %% of one", share, most)
                    + (waitSeconds == 0 ? "" : "; its limit holds messages back for " + waitSeconds + " s");
        }
    }

    /** Takes the counters that a board with a radio has told at that time. */
    synchronized void take(Map<Counter, Long> counters, long nanos) {
        // A board leaves out what is 0 where not all fit.
        long count = counters.getOrDefault(Counter.RADIO_AIRTIME, 0L);
        long risen = count < counted ? count : count - counted;
        last = new Reading(nanos, last == null ? 0 : last.sent + risen);
        isStopped = count == SMALL_MOST && count == counted;
        counted = count;
        if (readings.isEmpty() || nanos - readings.get(readings.size() - 1).nanos >= MINUTE) {
            readings.add(last);
        }
        while (readings.size() > 1 && nanos - readings.get(1).nanos >= HOUR) {
            readings.remove(0);
        }
        most = Math.max(most, share());
        goesOn = nanos + counters.getOrDefault(Counter.AIRTIME_WAIT, 0L) * SECOND;
    }

    /** The state; nothing before the first reading, and when the counter has stopped. */
    synchronized Optional<Use> use(long nanos) {
        return Optional.ofNullable(last).filter(any -> !isStopped)
                .map(known -> new Use(share(), most, Math.max(0, (goesOn - nanos + SECOND - 1) / SECOND)));
    }

    /** Where the hour begins between two readings, the board counts as having sent evenly between them. */
    private double share() {
        Reading first = readings.get(0);
        Reading second = readings.size() > 1 ? readings.get(1) : last;
        long before = Math.max(0, last.nanos - HOUR - first.nanos);
        double sentBefore = before == 0 ? 0
                : (double) (second.sent - first.sent) * before / (second.nanos - first.nanos);
        return Math.round((last.sent - first.sent - sentBefore) * SECOND / HOUR * PERMILLE_OF_ALL) / PERMILLE_A_PERCENT;
    }
}
