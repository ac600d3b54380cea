package gateway;

import java.util.Arrays;
import java.util.stream.Collectors;

/** How many messages devices have sent, and how many were acknowledged, by the kind of their destination. */
final class PlayedCount {

    private final int[] offered = new int[Kind.values().length];
    private final int[] delivered = new int[Kind.values().length];

    /** The receiver of a message: a device of the same cell, of another, one that has moved, nobody. */
    enum Kind {
        NEAR, FAR, MOVED, UNKNOWN
    }

    synchronized void offered(Kind kind) {
        offered[kind.ordinal()]++;
    }

    synchronized void delivered(Kind kind) {
        delivered[kind.ordinal()]++;
    }

    synchronized void add(PlayedCount other) {
        Arrays.setAll(offered, i -> offered[i] + other.offered[i]);
        Arrays.setAll(delivered, i -> delivered[i] + other.delivered[i]);
    }

    /** Offered and delivered of each kind, in one line. */
    @Override
    public synchronized String toString() {
        return Arrays.stream(Kind.values()).map(kind -> offered[kind.ordinal()] + " " + delivered[kind.ordinal()])
                .collect(Collectors.joining(" "));
    }
}
