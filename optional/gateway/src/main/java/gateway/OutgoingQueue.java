package gateway;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.Optional;
import javino.protocol.Address;
import javino.protocol.Frame;

/**
 * What waits for the board, which gets one frame at a time: so what has come too late can still be dropped.
 * Acknowledgements go first, since a sender waits for them.
 */
final class OutgoingQueue {

    private static final int MOST = 16;

    private final GatewayCounters counters;
    private final Deque<Waiting> waiting = new ArrayDeque<>();
    private Frame underWay;

    private record Waiting(Frame frame, long until) {
    }

    OutgoingQueue(GatewayCounters counters) {
        this.counters = counters;
    }

    /** Takes a frame in, unless there is no room for it, or the same waits already and would be repeated. */
    void add(Frame frame, long until) {
        Address.Kind kind = frame.destination().kind();
        boolean repeated = kind == Address.Kind.DEVICE || kind == Address.Kind.FRAGMENT;
        if (repeated && (frame.equals(underWay) || waiting.stream().anyMatch(other -> other.frame.equals(frame)))) {
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
        for (Iterator<Waiting> each = waiting.iterator(); each.hasNext();) {
            Waiting next = each.next();
            each.remove();
            if (now <= next.until) {
                underWay = next.frame;
                return Optional.of(underWay);
            }
            counters.count(GatewayCounter.EXPIRED);
        }
        return Optional.empty();
    }

    /** The board has sent the frame that was under way, or has not. */
    void ended(boolean sent) {
        underWay = null;
        counters.count(sent ? GatewayCounter.RELAYED : GatewayCounter.FAILED);
    }

    /** The board has gone. */
    void clear() {
        waiting.forEach(frame -> counters.count(GatewayCounter.FAILED));
        waiting.clear();
    }
}
