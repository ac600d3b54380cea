package campaign;

import harness.Emulator;
import harness.Table;
import harness.Transmitter;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Function;
import javino.link.LinkException;
import javino.protocol.Address;
import javino.protocol.Airtime;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.Payload;
import lockstep.Simulation;

/** A board in a cell that is not one of its own: it sends what it likes, whatever is on the air (`Transmitter`). */
final class Attacker implements AutoCloseable {

    private static final double BIT_RATE = 2000;

    private final Field.Post post;
    private final Transmitter transmitter;
    private boolean ended;
    private String failure = "";

    Attacker(Field field, int cell) throws LinkException {
        post = post(cell);
        transmitter = Transmitter.of(field.emulator(), post.name());
    }

    /** Adds an attacker to a cell of a scenario that has not started. */
    static void join(Emulator.Scenario scenario, int cell) {
        scenario.board(post(cell).name(), "Transmitter",
                Map.of("position", Field.position(cell), "resetOnOpen", false));
    }

    private static Field.Post post(int cell) {
        return new Field.Post("attacker" + cell, Address.parse(Table.text("X%03d", cell)));
    }

    Field.Post post() {
        return post;
    }

    /** Sends a packet, and waits until it was on the air. */
    void send(byte[] payload) throws LinkException {
        transmitter.send(payload);
    }

    /**
     * Goes on sending from now on, with random pauses.
     *
     * @param share  the share of the air that it takes, over 0 and under 1.
     * @param forger makes each packet.
     */
    void flood(double share, EmulatedTime time, Random random, Function<Random, byte[]> forger) {
        Simulation.here().thread("attacker", () -> {
            try {
                while (!ended) {
                    byte[] packet = forger.apply(random);
                    send(packet);
                    double pause = Airtime.bits(packet.length) / BIT_RATE * (1 - share) / share;
                    time.pause(-Math.log(1 - random.nextDouble()) * pause);
                }
            } catch (LinkException | AssertionError broken) {
                if (!ended) {
                    failure = post.name() + ": " + broken.getMessage();
                }
            }
        }).start();
    }

    /** Why the flood has stopped by itself; empty if it has not. */
    String failure() {
        return failure;
    }

    /** A frame with random bytes where nonce, content and tag are. */
    static byte[] forgedFrame(Field.Post from, Field.Post to, Random random) {
        return new Frame(to.address(), from.address(), random(30, random)).encode().toArray();
    }

    /** A fragment that begins a message, and asks which of it are here. */
    static byte[] forgedFragment(Field.Post from, Field.Post to, Random random) {
        Bytes begun =
                new Frame(to.address(), from.address(), random(400, random)).encode().slice(0, Payload.PART_LENGTH);
        return new Frame(Address.fragment(random.nextInt(26), 8), from.address(), begun).encode().toArray();
    }

    /**
     * A last fragment of one byte, in the next message of a sender whose messages all go in fragments: it tells a wrong
     * length.
     *
     * @param ended how many of its messages have ended: their ids run from 0 (SPEC 7.1), and one is under way.
     */
    static byte[] forgedEnd(Field.Post from, long ended, Random random) {
        Address to = Address.fragment((int) (ended + 1) % 64, 1 + random.nextInt(3));
        return new Frame(to, from.address(), random(1, random)).encode().toArray();
    }

    /** A broadcast of nothing that a host hands on, so that only the way to there is taken up. */
    static byte[] noise(Field.Post from, Random random) {
        return new Frame(Address.BROADCAST, from.address(), random(40, random)).encode().toArray();
    }

    private static Bytes random(int length, Random random) {
        byte[] bytes = new byte[length];
        random.nextBytes(bytes);
        return Bytes.copyOf(bytes);
    }

    @Override
    public void close() {
        ended = true;
        transmitter.close();
    }

    static List<Field.Cell> pairs(int count) {
        return java.util.Collections.nCopies(count, new Field.Cell("Station", 2));
    }
}
