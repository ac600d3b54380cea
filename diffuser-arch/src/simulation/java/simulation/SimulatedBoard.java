package simulation;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

import javino.protocol.Address;
import javino.protocol.Key;

/** The board of a host. */
public final class SimulatedBoard {

    private static final int ATTEMPTS = 8;
    private static final long BOOT_MILLIS = 1500;
    private static final long LATE_MILLIS = 3000;
    /** How long a board is away, on the average. */
    private static final long LOST_MILLIS = 60_000;

    private final Network<?> network;
    private final SimulatedHost host;
    public final Map<Address, Key> keys = new LinkedHashMap<>();
    /** Of these, those that it has again when it has booted. */
    public final Set<Address> stored = new HashSet<>();
    private final Set<Key> had = new HashSet<>();
    private final Map<Address, Long> newest = new HashMap<>();
    private final Deque<SimulatedChannel.Packet> packets = new ArrayDeque<>();
    private SimulatedChannel.Packet underWay;
    private boolean deaf;
    public boolean lost;
    public int eepromWrites;

    SimulatedBoard(Network<?> network, SimulatedHost host) {
        this.network = network;
        this.host = host;
    }

    void send(SimulatedChannel.Packet packet) {
        if (packet.key != null) {
            packet.isLost = packet.message.length() > network.longest || isOneOf(network.lost);
            packet.isUntold = isOneOf(network.untold);
        }
        packets.add(packet);
        next();
    }

    private boolean isOneOf(double share) {
        return share > 0 && network.random.nextDouble() < share;
    }

    private void next() {
        if (underWay == null && !packets.isEmpty() && !deaf) {
            underWay = packets.poll();
            network.air.send(underWay);
        }
    }

    /** The packet has been on the air. */
    void sent(SimulatedChannel.Packet packet, boolean known) {
        if (packet != underWay) {
            return;
        }
        underWay = null;
        if (packet.key == null || known || ++packet.attempt == ATTEMPTS) {
            network.air.lost += packet.key == null || packet.isTaken ? 0 : 1;
            host.later(() -> packet.end(known));
        } else {
            packets.add(packet);
        }
        next();
    }

    /** A packet comes undamaged. Tells whether it is acknowledged. */
    boolean hear(SimulatedChannel.Packet packet) {
        if (deaf) {
            return false;
        }
        if (packet.key == null) {
            network.listener.accept(packet);
            for (int i = network.random.nextDouble() < network.twice ? 2 : 1; i > 0; i--) {
                long wait = network.random.nextDouble() < network.late ? network.random.nextLong(LATE_MILLIS) : 0;
                network.after(wait, () -> host.told(() -> host.receive(packet)));
            }
            return false;
        }
        if (!packet.to.equals(host.address)) {
            return false;
        }
        Key key = keys.get(packet.from);
        if (key == null) {
            host.told(() -> host.programs.forEach(program -> program.noKey(packet.from)));
            return false;
        }
        if (!key.equals(packet.key) || !host.on) {
            return false;
        }
        if (packet.nonce > newest.getOrDefault(packet.from, -1L)) {
            newest.put(packet.from, packet.nonce);
            host.told(() -> host.receive(packet));
            return true;
        }
        return packet.nonce == newest.get(packet.from);
    }

    /** Takes a session key. Tells whether it does. */
    public boolean set(Address device, Key key) {
        if (!had.add(key)) {
            network.wrong.add(host.address + " set a key a second time for " + device);
            return false;
        }
        newest.remove(device);
        if (keys.put(device, key) != null) {
            undeliver(device);
        }
        return true;
    }

    /** What is sealed with a key that was replaced is undelivered. */
    private void undeliver(Address device) {
        List<SimulatedChannel.Packet> old = new ArrayList<>(packets);
        if (underWay != null) {
            old.add(underWay);
        }
        old.removeIf(packet -> !packet.to.equals(device));
        packets.removeAll(old);
        old.forEach(packet -> host.later(() -> packet.end(false)));
        if (old.contains(underWay)) {
            network.air.forget(underWay);
            underWay = null;
            next();
        }
    }

    /** Does nothing of what it is told from now on, and says nothing, until it boots. */
    public void lose() {
        lost = true;
        deaf = true;
        network.after(network.random.nextLong(2 * LOST_MILLIS), () -> {
            lost = false;
            reset();
        });
    }

    /** Boots. */
    public void reset() {
        List<SimulatedChannel.Packet> lost = new ArrayList<>(packets);
        if (underWay != null) {
            lost.add(0, underWay);
            network.air.forget(underWay);
        }
        underWay = null;
        packets.clear();
        keys.keySet().retainAll(stored);
        newest.clear();
        deaf = true;
        network.after(BOOT_MILLIS, () -> {
            deaf = false;
            host.told(() -> host.programs.forEach(Program::booted));
            lost.forEach(packet -> host.later(() -> packet.end(false)));
            next();
        });
    }
}
