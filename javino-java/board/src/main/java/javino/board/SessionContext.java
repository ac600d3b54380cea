package javino.board;

import java.time.Duration;
import java.util.Map;
import java.util.concurrent.atomic.AtomicReference;
import javino.Counts;
import javino.link.Time;
import javino.protocol.Counter;
import javino.protocol.ProtocolException;
import javino.protocol.Reply;

/**
 * The objects that the parts of a session share.
 *
 * @param name       the link's, for error lines.
 * @param config     the session's.
 * @param queue      the requests that wait, and the sign that the session was closed.
 * @param perception the board's percepts, and what of them is wanted.
 * @param radio      whether the radio is to be open; null where nobody said so yet.
 * @param overhear   whether the board is to overhear; null where nobody said so yet.
 * @param counters   the session's.
 * @param airtime    of the board's radio.
 * @param listener   told what happens.
 */
record SessionContext(String name, BoardConfig config, RequestQueue queue, Perception perception,
        AtomicReference<Boolean> radio, AtomicReference<Boolean> overhear, Counts<SessionCounter> counters,
        AirtimeHour airtime, ListenerGuard listener) {

    static SessionContext of(String name, BoardConfig config, BoardListener listener) {
        Counts<SessionCounter> counters = new Counts<>();
        ListenerGuard guard = new ListenerGuard(listener, counters);
        return new SessionContext(name, config, new RequestQueue(config.queueCapacity(), config.time()),
                new Perception(guard, counters, config.time()), new AtomicReference<>(), new AtomicReference<>(),
                counters, new AirtimeHour(), guard);
    }

    /**
     * The counters in a reply. If by them the board lets no new message go for now, those that it has no room for fail:
     * they would else wait for minutes without a word.
     */
    Map<Counter, Long> counted(Reply reply) throws ProtocolException {
        Map<Counter, Long> counters = reply.statistics();
        airtime.take(counters, time().nanos());
        long wait = counters.getOrDefault(Counter.AIRTIME_WAIT, 0L);
        if (wait > 0) {
            queue.takeHeld().forEach(held -> held.fail(new AirtimeUsedException(held.description(), wait)));
        }
        return counters;
    }

    Time time() {
        return config.time();
    }

    Deadline in(Duration duration) {
        return Deadline.in(duration, time());
    }
}
