package uppaal.conformance;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import trace.TraceEvent;

/** The packets that have come to each board, and those that a point may be about. */
final class Arrivals {
    /**
     * By board and number, what it may not have read yet, and the last. Of two at once either may end first. A board
     * without trace points reads nothing, so that it has the latest alone.
     */
    private final Map<String, TreeMap<Integer, Reception>> all = new HashMap<>();
    /** By board, when packets have begun to overlap there last, in seconds. */
    private final Map<String, Double> overlapped = new HashMap<>();
    private final Header header;
    private final double arrival;

    Arrivals(Header header) {
        this.header = header;
        arrival = PhysicalLimits.ARRIVAL_BITS * header.bit();
    }

    private TreeMap<Integer, Reception> at(String board) {
        return all.computeIfAbsent(board, added -> new TreeMap<>());
    }

    void overlap(TraceEvent collision) {
        overlapped.put(collision.board(), collision.seconds());
    }

    /** Whether no other packet has overlapped with one that the trace tells now to have come. */
    boolean isAlone(TraceEvent came) {
        return overlapped.getOrDefault(came.board(), Double.NEGATIVE_INFINITY) < came.real("start") - arrival;
    }

    /** @param isAlone else its board may find wrong bits in what is intact by the trace, and mend them */
    Reception add(TraceEvent event, Transmission packet, boolean isAlone) throws RefusedException {
        TreeMap<Integer, Reception> here = at(event.board());
        boolean isAtOnce = event.is("rf-rx") && isAlone && !packet.isOfModule();
        double readBy = event.seconds() + (isAtOnce ? arrival : header.longest());
        Reception reception = new Reception(event, packet,
                Math.max(here.isEmpty() ? 0 : here.lastEntry().getValue().readBy(), readBy));
        RefusedException.require(here.put(packet.number(), reception) == null,
                event.board() + " hears " + packet + " twice", "once");
        if (here.size() > BoundedMap.MOST) {
            here.pollFirstEntry();
        }
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
        TreeMap<Integer, Reception> here = at(point.board());
        RefusedException.require(point.seconds() > told - 2 * arrival || here.containsKey(named),
                point.board() + " tells of packet " + named, "one that has come to it");
        if (!point.has("run") || here.isEmpty()) {
            return List.of();
        }
        double runBefore = point.real("run") - point.real("gap");
        here.headMap(named).values().removeIf(each -> each.readBy() < runBefore);
        return here.headMap(named, true).values().stream().filter(each -> each.readBy() >= runBefore).toList();
    }

    /** A board forgets what it has not read, but its points still name what has come last. */
    void forget(String board) {
        at(board).replaceAll((number, each) -> new Reception(each.event(), each.packet(), Double.NEGATIVE_INFINITY));
    }
}
