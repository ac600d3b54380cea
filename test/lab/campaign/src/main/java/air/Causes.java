package air;

import java.util.ArrayList;
import java.util.List;

/** Finds out of each packet how long its sender had waited, which others it met, and why. */
final class Causes {

    private final List<Packet> packets;
    private final List<AirTrace.Jam> jams;
    private final double longest;

    private Causes(List<Packet> packets, List<AirTrace.Jam> jams) {
        this.packets = packets;
        this.jams = jams;
        longest = packets.stream().mapToDouble(Packet::seconds).max().orElse(0);
    }

    /** @param packets in the order of their beginnings */
    static void find(List<Packet> packets, List<AirTrace.Jam> jams) {
        Causes causes = new Causes(packets, jams);
        causes.meet();
        for (int i = 0; i < packets.size(); i++) {
            causes.wait(i);
        }
        packets.forEach(packet -> packet.cause = causes.cause(packet));
    }

    private void meet() {
        List<Packet> onAir = new ArrayList<>();
        for (Packet next : packets) {
            onAir.removeIf(packet -> packet.end <= next.start);
            for (Packet packet : onAir) {
                if (!packet.board.equals(next.board) && packet.meets(next)) {
                    packet.met.add(next);
                    next.met.add(packet);
                }
            }
            onAir.add(next);
        }
    }

    /** Nobody can hear what began less than a slot ago. */
    private void wait(int index) {
        Packet packet = packets.get(index);
        double quietSince = Double.NEGATIVE_INFINITY;
        for (int i = index - 1; i >= 0 && packets.get(i).start + longest > quietSince; i--) {
            Packet before = packets.get(i);
            boolean audible = before.board.equals(packet.board) || before.heardBy.contains(packet.board);
            if (audible && before.start <= packet.start - packet.slot) {
                quietSince = Math.max(quietSince, before.end);
            }
        }
        if (quietSince <= packet.start && quietSince > Double.NEGATIVE_INFINITY) {
            packet.quietSlots = (packet.start - quietSince) / packet.slot;
        }
    }

    private Cause cause(Packet packet) {
        List<Packet> earlier = packet.earlier();
        if (earlier.isEmpty()) {
            return packet.damagedAt.isEmpty() || !packet.met.isEmpty() ? null : whyDamaged(packet);
        }
        List<Packet> audible = earlier.stream().filter(other -> other.heardBy.contains(packet.board)).toList();
        return audible.stream().filter(other -> packet.start - other.start >= packet.slot).findFirst()
                .map(other -> whyNotHeard(other, packet))
                .orElse(audible.isEmpty() ? Cause.HIDDEN : Cause.SAME_SLOT);
    }

    private static Cause whyDamaged(Packet packet) {
        if (packet.beside.isEmpty()) {
            return Cause.NOISE;
        }
        return packet.beside.contains("jam") ? Cause.JAM : Cause.UNFINISHED;
    }

    private Cause whyNotHeard(Packet other, Packet packet) {
        double heardAt = other.start + other.slot;
        List<Packet> beside = other.met.stream()
                .filter(third -> third != packet && third.overlaps(other.start, heardAt)).toList();
        if (beside.stream().anyMatch(third -> third.board.equals(packet.board))) {
            return Cause.OWN;
        }
        boolean jammed = other.beside.contains("jam")
                && jams.stream().anyMatch(jam -> jam.start() < heardAt && jam.end() > other.start);
        boolean buried = jammed || beside.stream().anyMatch(third -> third.heardBy.contains(packet.board));
        return buried ? Cause.BURIED : Cause.MISSED;
    }
}
