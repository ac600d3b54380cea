package simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import javino.protocol.Address;
import javino.protocol.Airtime;
import javino.protocol.Bytes;
import javino.protocol.Key;
import javino.protocol.Outcome;

/** The air that boards share, as far as SPEC 6 and 7 make it slow: airtime, waits, collisions, damage. */
public final class SimulatedChannel {

    /** At 2000 bit/s. */
    public static final double BITS_A_MILLI = 2;
    private static final int FRAME_LENGTH = 64;
    private static final int SLOT_MILLIS = 8;
    private static final int QUIET_SLOTS = 6;
    private static final int WINDOW = 16;
    private static final int FREE_SLOTS = 15;
    /** Gap and acknowledgement. */
    private static final long ACKNOWLEDGED_MILLIS = 160;
    private static final long UNACKNOWLEDGED_MILLIS = 150;

    private final Network<?> network;
    private final List<Packet> waiting = new ArrayList<>();
    private final List<Packet> onAir = new ArrayList<>();
    private long began;
    private long busyUntil;
    private long freeSince;
    /** Share of bits that are wrong. */
    public double errors;
    /** Bits that have been on the air. */
    public long bits;
    /** Unicasts that have ended, and that nobody has taken. */
    public long lost;
    long nonces;

    /** A packet of a board. */
    public static final class Packet {

        public final Address from;
        public final Address to;
        public final Bytes message;
        /** Null for a broadcast. */
        final Key key;
        final long nonce;
        /** The outcome of a host's packet; else null. */
        private final CompletableFuture<Outcome> end;
        int attempt;
        private long start;
        private int slots = -1;
        private boolean damaged;
        boolean isLost;
        boolean isUntold;
        boolean isTaken;

        public Packet(Address from, Address to, Bytes message, Key key, long nonce, CompletableFuture<Outcome> end) {
            this.from = from;
            this.to = to;
            this.message = message;
            this.key = key;
            this.nonce = nonce;
            this.end = end;
        }

        void end(boolean delivered) {
            end.complete(key == null ? Outcome.SENT : delivered ? Outcome.DELIVERED : Outcome.UNDELIVERED);
        }

        /** A repeat is of the frame that was not acknowledged. */
        public int bits() {
            int length = attempt == 0 ? message.length() : Math.min(message.length(), FRAME_LENGTH);
            return Airtime.bits(10 + length + (key == null ? 0 : 14));
        }
    }

    SimulatedChannel(Network<?> network) {
        this.network = network;
    }

    public void send(Packet packet) {
        waiting.add(packet);
        draw(packet);
    }

    void forget(Packet packet) {
        waiting.remove(packet);
    }

    private void draw(Packet packet) {
        long now = network.millis();
        if (now < busyUntil) {
            return;
        }
        boolean free = packet.attempt == 0 && now - freeSince >= FREE_SLOTS * SLOT_MILLIS;
        if (packet.slots < 0) {
            packet.slots = network.random.nextInt(WINDOW << Math.min(packet.attempt, 3));
        } else if (packet.start > began) {
            // Slots that were quiet are used up.
            packet.slots = (int) Math.min(packet.slots, (packet.start - began) / SLOT_MILLIS);
        }
        packet.start = free ? now : Math.max(now, freeSince + SLOT_MILLIS * (QUIET_SLOTS + packet.slots));
        long start = packet.start;
        network.after(start - now, () -> begin(packet, start));
    }

    private void begin(Packet packet, long start) {
        long now = network.millis();
        if (!waiting.contains(packet) || packet.start != start || now < busyUntil && now - began >= SLOT_MILLIS) {
            return;
        }
        waiting.remove(packet);
        packet.slots = -1;
        if (now >= busyUntil) {
            began = now;
        }
        onAir.add(packet);
        onAir.forEach(each -> each.damaged = onAir.size() > 1);
        bits += packet.bits();
        long takes = (long) (packet.bits() / BITS_A_MILLI);
        busyUntil = Math.max(busyUntil, now + takes + 1);
        network.after(takes, () -> end(packet));
    }

    private void end(Packet packet) {
        onAir.remove(packet);
        boolean taken = false;
        for (SimulatedHost host : network.hosts.values()) {
            boolean heard = network.contact && !packet.isLost && !packet.damaged && !host.address.equals(packet.from)
                    && !isSpoilt(packet.bits(),
                            packet.key == null ? 0 : packet.attempt);
            taken |= heard && host.board.hear(packet);
        }
        // The sender knows of the delivery unless the acknowledgement is lost.
        boolean known = taken && !isSpoilt(300, 2) && !packet.isUntold;
        packet.isTaken |= taken;
        long rest = packet.key == null ? 0 : taken ? ACKNOWLEDGED_MILLIS : UNACKNOWLEDGED_MILLIS;
        if (taken) {
            busyUntil = Math.max(busyUntil, network.millis() + rest);
        }
        network.after(rest, () -> network.host(packet.from).board.sent(packet, known));
        network.after(Math.max(0, busyUntil - network.millis()), this::freed);
    }

    private void freed() {
        if (network.millis() >= busyUntil && onAir.isEmpty()) {
            freeSince = Math.max(freeSince, busyUntil);
            new ArrayList<>(waiting).forEach(this::draw);
        }
    }

    /** Whether a packet is damaged beyond mending: more than one wrong symbol; of repeats, far more can be mended. */
    private boolean isSpoilt(int bits, int attempt) {
        double expected = errors * bits;
        double borne = 1;
        double term = 1;
        for (int i = 1; i <= 1 + 4 * attempt; i++) {
            term *= expected / i;
            borne += term;
        }
        return network.random.nextDouble() >= Math.exp(-expected) * borne;
    }
}
