package simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

import diffuser.HostChannel;
import diffuser.HostClock;
import diffuser.TrustLevel;

import javino.board.Transmission;
import javino.protocol.Address;
import javino.protocol.HostMessage;
import javino.protocol.Key;
import javino.protocol.Outcome;
import javino.protocol.ProtocolException;

/** A computer with a board, which is killed and started again. What it is to do is not done by a later life of it. */
public class SimulatedHost implements HostClock {

    /** What a host needs for what comes, and a board for a request, in ms. */
    private static final int HOST_MILLIS = 30;
    private static final int BOARD_MILLIS = 10;

    /** What is thrown where a program is killed. */
    private static final class Killed extends Error {
        private static final long serialVersionUID = 1L;

        Killed() {
            super("killed", null, false, false);
        }
    }

    public final Address address;
    public final SimulatedBoard board;
    public final List<Program> programs = new ArrayList<>();
    protected final Network<?> network;
    protected HostChannel channel;
    /** What others are to it, by the keys of its board. */
    public TrustLevel trust = TrustLevel.PROVISIONED;
    public boolean on;
    public long killedAt = -1;
    protected int life;
    /** Told of what a step has thrown. */
    public Consumer<RuntimeException> failed = e -> {
        throw e;
    };

    public SimulatedHost(Network<?> network, Address address) {
        this.network = network;
        this.address = address;
        board = new SimulatedBoard(network, this);
    }

    public void start() {
        on = true;
        life++;
        channel = new HostChannel(programs, this::transmit, network.wrong::add);
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

    /** Where there may be a fault: before and after each thing that it does to the simulation. */
    public void fault(String where) {
        if (address.equals(network.victim) && network.faultAfter >= 0 && network.faultAfter-- == 0) {
            network.faults.merge(where, 1, Integer::sum);
            if (network.fault == Network.Fault.KILL) {
                throw new Killed();
            }
            board.reset();
        }
    }

    /** Takes a step. */
    public void within(Runnable step) {
        try {
            step.run();
            programs.forEach(Program::stepped);
        } catch (Killed e) {
            crash();
        } catch (RuntimeException e) {
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
    void told(Runnable what) {
        after(HOST_MILLIS, what);
    }

    /** The board is told something, or tells what became of it. */
    protected void later(Runnable what) {
        after(BOARD_MILLIS, what);
    }

    void receive(SimulatedChannel.Packet packet) {
        try {
            channel.receive(packet.from, packet.to, trust, HostMessage.decode(packet.message));
        } catch (ProtocolException e) {
            // A session skips it.
        }
    }

    /** Sends a message under a key with that device. */
    public CompletableFuture<Outcome> send(Address to, HostMessage message) {
        return channel.send(to, message).end();
    }

    private Transmission transmit(Address to, HostMessage message) {
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
}
