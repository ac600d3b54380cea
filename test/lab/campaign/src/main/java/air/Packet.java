package air;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javino.protocol.Airtime;

/** A packet that was on the air, and what is found out about it. */
final class Packet {

    private static final int SLOT_BITS = 16;

    /** The kind that it is drawn as. */
    enum Kind {
        FIRST("first attempt", "#2f6fb5"),
        REPEAT("repeat", "#c45a00"),
        FRAGMENT("fragment", "#8242b5"),
        ACKNOWLEDGEMENT("acknowledgement", "#2e7d32"),
        TO_MANY("multicast, broadcast", "#00808a"),
        OTHER("other", "#6b6b6b");

        final String title;
        final String colour;

        Kind(String title, String colour) {
            this.title = title;
            this.colour = colour;
        }
    }

    final String board;
    final double start;
    final double end;
    final Kind kind;
    final String address;
    /** {@code mark}, {@code parity}, or empty. */
    final String trailer;
    /** When its CRC was out. */
    final double bodyEnd;
    /** The length of a slot at its bit rate, in seconds. */
    final double slot;
    /** Boards in range, whether it was damaged there or not. */
    final Set<String> heardBy = new HashSet<>();
    final List<String> damagedAt = new ArrayList<>();
    /** The packets on the air at the same time that some board heard too, in the order of their beginnings. */
    final List<Packet> met = new ArrayList<>();
    /** The boards whose transmissions began to overlap it at a board where it was damaged; may be a jam's. */
    final Set<String> beside = new HashSet<>();
    /** Slots since its sender heard the air become quiet; NaN where that is not known, or it was not. */
    double quietSlots = Double.NaN;
    /** Why it began though another was on the air, or was damaged though none was; null where neither is so. */
    Cause cause;

    /** @param digits those of its payload, in hexadecimal */
    Packet(String board, double start, double end, int bits, int digits, Kind kind, String address, String trailer) {
        this.board = board;
        this.start = start;
        this.end = end;
        this.kind = kind;
        this.address = address;
        this.trailer = trailer;
        // The first bit is a 0, before its start.
        double bit = (end - start) / (bits - 1);
        bodyEnd = Math.min(end, start + bit * (Airtime.bits(digits / 2) - 1));
        slot = bit * SLOT_BITS;
    }

    double seconds() {
        return end - start;
    }

    boolean isAnswer() {
        return kind == Kind.ACKNOWLEDGEMENT;
    }

    boolean overlaps(double from, double to) {
        return start < to && end > from;
    }

    /** Whether there is a board that hears both. */
    boolean meets(Packet other) {
        return heardBy.contains(other.board) || other.heardBy.contains(board)
                || heardBy.stream().anyMatch(other.heardBy::contains);
    }

    /** The packets that were on the air when it began. */
    List<Packet> earlier() {
        return met.stream().filter(other -> other.start <= start && !other.isAfter(this)).toList();
    }

    /** Makes one of two that begin at once the later one, as each might be called the first. */
    private boolean isAfter(Packet other) {
        return start == other.start && board.compareTo(other.board) > 0;
    }
}
