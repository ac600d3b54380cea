package simulation;

import java.io.UncheckedIOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Predicate;

import diffuser.board.HostMessages;
import diffuser.board.HostService;
import diffuser.board.Sender;
import diffuser.gate.TrustLevel;

import javino.board.Transmission;
import javino.link.Time;
import javino.protocol.Address;
import javino.protocol.HostMessage;
import javino.protocol.Key;
import javino.protocol.Message;
import javino.protocol.Outcome;
import javino.protocol.ProtocolException;

/** A computer with a board, which is killed and started again. Its later life does not do what is left to do. */
public class SimulatedHost implements Time.Timer {

    /** Times that a host needs for a message, and a board for a request, in ms. */
    private static final int HOST_MILLIS = 30;
    private static final int BOARD_MILLIS = 10;
    private static final int ATTEMPTS = 8;
    private static final long BOOT_MILLIS = 1500;
    private static final long LATE_MILLIS = 3000;
    /** How long a board is away, on the average. */
    private static final long LOST_MILLIS = 60_000;

    /** Thrown where a program is killed. */
    private static final Error KILLED = new Error("killed");

    /** A program that a host runs. */
    public interface Program extends HostService {

        /** The host has started, and has nothing of before but what is on its disk. */
        void started();

        /** The host is killed. */
        default void stop() {
        }
    }

    public final Address address;
    public final Board board = new Board();
    public final List<Program> programs = new ArrayList<>();
    protected final Network<?> network;
    protected HostMessages hosts;
    protected Sender sender;
    /** The trust level of all others, by the keys of its board. */
    public TrustLevel trust = TrustLevel.PROVISIONED;
    public boolean on;
    public long killedAt = -1;
    protected int life;
    /** Told where a step has failed. */
    public Consumer<RuntimeException> failed = e -> {
        throw e;
    };

    public SimulatedHost(Network<?> network, Address address) {
        this.network = network;
        this.address = address;
    }

    public void start() {
        on = true;
        life++;
        hosts = new HostMessages(programs, network.wrong::add);
        sender = new Sender(this::transmit);
        programs.forEach(Program::started);
    }

    /** The program ends at once. */
    public void kill() {
        on = false;
        killedAt = millis();
        life++;
        programs.forEach(Program::stop);
    }

    /** It is killed, and starts again some time later. */
    public void crash() {
        kill();
        network.after(network.random.nextInt(network.restartMillis), () -> {
            if (!on) {
                start();
            }
        });
    }

    /** A point at which a fault may come: before and after each thing that it does to the simulation. */
    public void fault(String where) {
        if (address.equals(network.victim) && network.faultAfter >= 0 && network.faultAfter-- == 0) {
            network.faults.merge(where, 1, Integer::sum);
            if (network.fault == Network.Fault.KILL) {
                throw KILLED;
            }
            board.reset();
        }
    }

    /** Takes a step. */
    public void within(Runnable step) {
        try {
            step.run();
        } catch (Error e) {
            if (e != KILLED) {
                throw e;
            }
            crash();
        } catch (UncheckedIOException | IllegalStateException e) {
            failed.accept(e);
        }
    }

    @Override
    public long millis() {
        return network.millis();
    }

    @Override
    public void after(long millis, Runnable step) {
        int mine = life;
        network.after(millis, () -> {
            if (on && mine == life) {
                within(step);
            }
        });
    }

    @Override
    public void close() {
        // Nothing is done any more while it is off.
    }

    /** The host is told something by its board, some time later. */
    private void told(Runnable what) {
        after(HOST_MILLIS, what);
    }

    /** The board is told something, or tells what became of it. */
    protected void later(Runnable what) {
        after(BOARD_MILLIS, what);
    }

    /** A sealed packet has come for which the board has no key. */
    protected void noKey(Address from) {
    }

    /** The board has booted. */
    protected void booted() {
    }

    private void receive(SimulatedChannel.Packet packet) {
        try {
            hosts.receive(packet.from, packet.to, trust, HostMessage.decode(packet.message));
        } catch (ProtocolException e) {
            // A session skips it.
        }
    }

    /** Sends a message under a key with that device. */
    public CompletableFuture<Outcome> send(Address to, HostMessage message) {
        return sender.send(to, message).end();
    }

    private Transmission transmit(Address to, Message message) {
        CompletableFuture<Outcome> end = new CompletableFuture<>();
        later(() -> {
            Key key = board.keys.get(to);
            if (key == null && !to.equals(Address.BROADCAST)) {
                end.completeExceptionally(new IllegalStateException("no key"));
            } else {
                board.send(new SimulatedChannel.Packet(address, to, message.encode(), key, network.air.nonces++, end));
            }
        });
        return new Transmission(new CompletableFuture<>(), end);
    }

    /** The board of a host. */
    public final class Board {

        public final Map<Address, Key> keys = new LinkedHashMap<>();
        /** The devices whose keys it has again when it has booted. */
        public final Set<Address> stored = new HashSet<>();
        private final Set<Key> had = new HashSet<>();
        private final Map<Address, Long> newest = new HashMap<>();
        private final Deque<SimulatedChannel.Packet> packets = new ArrayDeque<>();
        private SimulatedChannel.Packet underWay;
        private boolean deaf;
        public boolean lost;
        public int eepromWrites;

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
                later(() -> packet.end(known));
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
                    network.after(wait, () -> told(() -> receive(packet)));
                }
                return false;
            }
            if (!packet.to.equals(address)) {
                return false;
            }
            Key key = keys.get(packet.from);
            if (key == null) {
                told(() -> noKey(packet.from));
                return false;
            }
            if (!key.equals(packet.key) || !on) {
                return false;
            }
            if (packet.nonce > newest.getOrDefault(packet.from, -1L)) {
                newest.put(packet.from, packet.nonce);
                told(() -> receive(packet));
                return true;
            }
            return packet.nonce == newest.get(packet.from);
        }

        /** Takes a session key. Tells whether it does. */
        public boolean set(Address device, Key key) {
            if (!had.add(key)) {
                network.wrong.add(address + " set a key a second time for " + device);
                return false;
            }
            newest.remove(device);
            if (keys.put(device, key) != null) {
                // Messages sealed with the replaced key are undelivered.
                drop(packet -> packet.to.equals(device)).forEach(packet -> later(() -> packet.end(false)));
                next();
            }
            return true;
        }

        /** Takes what is to be sent off the air. */
        private List<SimulatedChannel.Packet> drop(Predicate<SimulatedChannel.Packet> which) {
            List<SimulatedChannel.Packet> old = new ArrayList<>(packets);
            if (underWay != null) {
                old.add(0, underWay);
            }
            old.removeIf(which.negate());
            packets.removeAll(old);
            if (old.contains(underWay)) {
                network.air.forget(underWay);
                underWay = null;
            }
            return old;
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
            List<SimulatedChannel.Packet> dropped = drop(packet -> true);
            keys.keySet().retainAll(stored);
            newest.clear();
            deaf = true;
            network.after(BOOT_MILLIS, () -> {
                deaf = false;
                told(SimulatedHost.this::booted);
                dropped.forEach(packet -> later(() -> packet.end(false)));
                next();
            });
        }
    }
}
