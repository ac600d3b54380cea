package bench;

import java.time.Duration;
import java.util.concurrent.locks.LockSupport;
import javino.link.InMemoryLink;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.Packet;
import javino.protocol.PacketDecoder;

/** A board in memory that greets, has no actions, and perceives one thing. */
final class MemoryBoard implements LinkOpener {

    private static final Bytes GREETING =
            Bytes.join(Bytes.of(0, 1), Bytes.ofText("ROMA"), Bytes.of(0, 0, 1), Bytes.ofText("memory"));

    private static final Bytes NO_ACTIONS = Bytes.of(0, 0);

    private final Duration delay;
    private final boolean silent;
    private final int step;
    private int light;

    private MemoryBoard(Duration delay, boolean silent, int step) {
        this.delay = delay;
        this.silent = silent;
        this.step = step;
    }

    static MemoryBoard answeringAfter(Duration delay) {
        return new MemoryBoard(delay, false, 0);
    }

    static MemoryBoard silent() {
        return new MemoryBoard(Duration.ZERO, true, 0);
    }

    /** Answers at once, each time with another percept. */
    static MemoryBoard changing() {
        return new MemoryBoard(Duration.ZERO, false, 1);
    }

    @Override
    public String name() {
        return "memory";
    }

    @Override
    public Link open() {
        InMemoryLink.Pair pair = InMemoryLink.pair(name());
        Thread thread = new Thread(() -> serve(pair.board()), "board in memory");
        thread.setDaemon(true);
        thread.start();
        return pair.host();
    }

    private void serve(Link line) {
        PacketDecoder decoder = new PacketDecoder();
        byte[] buffer = new byte[1024];
        try {
            while (true) {
                int count = line.read(buffer, Duration.ofSeconds(1));
                for (PacketDecoder.Result result : decoder.feed(buffer, count)) {
                    if (!silent && result instanceof PacketDecoder.Found found) {
                        answer(line, found.packet());
                    }
                }
            }
        } catch (LinkException closed) {
            // The host has closed the port.
            return;
        }
    }

    private void answer(Link line, Packet request) throws LinkException {
        if (!delay.isZero()) {
            LockSupport.parkNanos(delay.toNanos());
        }
        Bytes message = switch (request.frame().message().at(0)) {
            case 'P' -> percepts();
            case 'C' -> NO_ACTIONS;
            default -> GREETING;
        };
        line.write(
                new Packet(request.sequence(), new Frame(Address.SERIAL, Address.SERIAL, message)).encode().toArray());
    }

    private Bytes percepts() {
        light = (light + step) % 1024;
        Bytes literal = Bytes.ofText("light(" + light + ")");
        return Bytes.join(Bytes.of(0, 0, 'P'), Bytes.ofNumber(literal.length(), 2), literal);
    }
}
