package uppaal.conformance;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import trace.TraceEvent;

/** What has come to each board, and what of it a point may be about. */
final class Arrivals {
    /** By board, what it may not have read yet, and at least the last. */
    private final Map<String, Deque<Reception>> all = new HashMap<>();
    private final Header header;
    private final double arrival;

    Arrivals(Header header) {
        this.header = header;
        arrival = PhysicalLimits.ARRIVAL_BITS * header.bit();
    }

    Reception add(TraceEvent event, Transmission packet) throws RefusedException {
        Deque<Reception> here = all.computeIfAbsent(event.board(), added -> new ArrayDeque<>());
        RefusedException.require(here.stream().noneMatch(each -> each.packet() == packet),
                event.board() + " hears " + packet + " twice", "once");
        boolean isAtOnce = event.is("rf-rx") && !packet.isOfModule();
        double readBy = event.seconds() + (isAtOnce ? arrival : header.longest());
        Reception reception =
                new Reception(event, packet, Math.max(here.isEmpty() ? 0 : here.getLast().readBy(), readBy));
        here.add(reception);
        return reception;
    }

    /**
     * Those that a point may be about: the packet that it names, as that has come last, and others before that its
     * board may not have read.
     *
     * @param told until when the trace has told what happened
     */
    List<Reception> of(TraceEvent point, double told) throws RefusedException {
        if (!point.has("packet")) {
            return List.of();
        }
        int named = point.number("packet");
        Deque<Reception> here = all.getOrDefault(point.board(), new ArrayDeque<>());
        RefusedException.require(point.seconds() > told - 2 * arrival
                || here.stream().anyMatch(each -> each.packet().number() == named),
                point.board() + " tells of packet " + named, "one that has come to it");
        if (!point.has("run")) {
            return List.of();
        }
        double runBefore = point.real("run") - point.real("gap");
        while (here.size() > 1 && here.getFirst().readBy() < runBefore) {
            here.removeFirst();
        }
        return here.stream().filter(each -> each.packet().number() <= named && each.readBy() >= runBefore).toList();
    }

    /** A board forgets what it has not read, but its points still name what has come last. */
    void forget(String board) {
        Deque<Reception> here = all.getOrDefault(board, new ArrayDeque<>());
        if (!here.isEmpty()) {
            Reception last = here.getLast();
            here.clear();
            here.add(new Reception(last.event(), last.packet(), Double.NEGATIVE_INFINITY));
        }
    }
}
