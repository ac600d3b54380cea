package harness;

import java.util.HashMap;
import java.util.Map;
import trace.TraceEvent;

/**
 * Counts, of two boards, the packets of each that were on the air while the other one was sending, and so not
 * listening.
 */
public final class CrossedPackets {

    private record Packet(double start, double end, boolean crossed) {}

    private final Map<String, Packet> last = new HashMap<>();
    private final Map<String, Long> crossed = new HashMap<>();

    /** Takes notice of an event of the trace. */
    public synchronized void see(TraceEvent event) {
        if (!event.name().equals("rf-tx")) {
            return;
        }
        Packet packet = new Packet(event.real("start"), event.real("end"), false);
        for (Map.Entry<String, Packet> each : last.entrySet()) {
            Packet other = each.getValue();
            if (each.getKey().equals(event.board()) || other.end < packet.start || packet.end < other.start) {
                continue;
            }
            if (!other.crossed) {
                crossed.merge(each.getKey(), 1L, Long::sum);
            }
            if (!packet.crossed) {
                crossed.merge(event.board(), 1L, Long::sum);
            }
            packet = new Packet(packet.start, packet.end, true);
            each.setValue(new Packet(other.start, other.end, true));
        }
        last.put(event.board(), packet);
    }

    /** The number of packets of this board that crossed others. */
    public synchronized long of(String board) {
        return crossed.getOrDefault(board, 0L);
    }
}
