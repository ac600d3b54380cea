package gateway;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import javino.Counts;
import javino.protocol.Address;
import javino.protocol.Frame;

/**
 * Frames that wait for the board, which gets one at a time: so frames that are late can still be dropped.
 * Acknowledgements go first, since a sender waits for them.
 */
final class OutgoingQueue {

    private static final int MOST = 16;

    private final Counts<GatewayCounter> counters;
    private final Deque<Waiting> waiting = new ArrayDeque<>();
    private Frame underWay;

    private static final class Waiting {
        private final Frame frame;
        private long until;

        Waiting(Frame frame, long until) {
            this.frame = frame;
            this.until = until;
        }
    }

    OutgoingQueue(Counts<GatewayCounter> counters) {
        this.counters = counters;
    }

    /**
     * Takes a frame in, unless there is no room for it, or the same waits already: then that one waits for as long as
     * the later of both may, since whoever came first may have lied about the time.
     *
     * @param missing how often it is still to be on the air; of those that their sender repeats, one at a time waits.
     * @param until   after that it is of no use, in ms.
     */
    void add(Frame frame, int missing, long until) {
        Address.Kind kind = frame.destination().kind();
        boolean repeated = kind == Address.Kind.DEVICE || kind == Address.Kind.FRAGMENT;
        List<Waiting> same = waiting.stream().filter(other -> other.frame.equals(frame)).toList();
        if (same.size() + (frame.equals(underWay) ? 1 : 0) >= (repeated ? 1 : missing)) {
            same.forEach(other -> other.until = Math.max(other.until, until));
            counters.count(GatewayCounter.DUPLICATES);
        } else if (waiting.size() == MOST) {
            counters.count(GatewayCounter.OVERFLOWED);
        } else if (kind == Address.Kind.ACKNOWLEDGEMENT) {
            waiting.addFirst(new Waiting(frame, until));
        } else {
            waiting.add(new Waiting(frame, until));
        }
    }

    /** The next frame for the board; nothing while one is under way, or none waits. */
    Optional<Frame> next(long now) {
        if (underWay != null) {
            return Optional.empty();
        }
        while (!waiting.isEmpty()) {
            Waiting next = waiting.remove();
            if (now <= next.until) {
                underWay = next.frame;
                return Optional.of(underWay);
            }
            counters.count(GatewayCounter.EXPIRED);
        }
        return Optional.empty();
    }

    /** The board has sent the frame that was under way, or has not. @return the frame if it was on the air. */
    Optional<Frame> ended(boolean sent) {
        Optional<Frame> onAir = Optional.ofNullable(underWay).filter(any -> sent);
        underWay = null;
        counters.count(sent ? GatewayCounter.RELAYED : GatewayCounter.FAILED);
        return onAir;
    }

    /** The board has gone. */
    void clear() {
        waiting.forEach(frame -> counters.count(GatewayCounter.FAILED));
        waiting.clear();
    }
}
