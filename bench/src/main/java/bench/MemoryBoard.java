package bench;

import java.time.Duration;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import javino.link.InMemoryLink;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.SerialPacket;
import javino.protocol.PacketDecoder;
import javino.protocol.Status;

/**
 * A board in memory that greets, has no actions, no keys and no radio, perceives one thing, and holds its replies to
 * polls as a real one does. All of them share a thread.
 */
final class MemoryBoard implements LinkOpener {

    private static final Bytes GREETING =
            Bytes.join(Bytes.of(0, 1), Bytes.ofText("ROMA"), Bytes.of(0, 0, 1), Bytes.ofText("memory"));

    private static final Bytes NO_ACTIONS = Bytes.of(0, 0);
    /** An empty list, of keys or of counters. */
    private static final Bytes NONE = Bytes.of(0);
    private static final Bytes NOTHING_NEW = Bytes.of(0, 0);
    /** Flags of a poll (SPEC 4.3). */
    private static final int WANTED = 1;
    private static final int AT_ONCE = 2;
    private static final int LOST = 4;
    /** How often a sketch reads its sensors by default. */
    private static final Duration SAMPLE = Duration.ofMillis(20);
    private static final ScheduledExecutorService PLAYER = Executors.newSingleThreadScheduledExecutor(task -> {
        Thread thread = new Thread(task, "boards in memory");
        thread.setDaemon(true);
        return thread;
    });

    private final Duration delay;
    private final boolean silent;
    private final boolean changes;

    private MemoryBoard(Duration delay, boolean silent, boolean changes) {
        this.delay = delay;
        this.silent = silent;
        this.changes = changes;
    }

    static MemoryBoard answeringAfter(Duration delay) {
        return new MemoryBoard(delay, false, false);
    }

    static MemoryBoard silent() {
        return new MemoryBoard(Duration.ZERO, true, false);
    }

    /** Has another percept at each reading. */
    static MemoryBoard changing() {
        return new MemoryBoard(Duration.ZERO, false, true);
    }

    @Override
    public String name() {
        return "memory";
    }

    @Override
    public Link open() {
        return new Line(InMemoryLink.pair(name()));
    }

    /** The host's end of the line, with the board behind it. */
    private final class Line implements Link {

        private final InMemoryLink.Pair pair;
        private final PacketDecoder decoder = new PacketDecoder();
        private int light;
        private boolean greeted;
        private boolean told;
        private SerialPacket held;
        private Future<?> end;

        Line(InMemoryLink.Pair pair) {
            this.pair = pair;
        }

        @Override
        public synchronized void write(byte[] bytes) {
            if (held != null) {
                end.cancel(false);
                reply(held, NOTHING_NEW);
                held = null;
            }
            for (PacketDecoder.Result result : decoder.feed(bytes, bytes.length)) {
                if (!silent && result instanceof PacketDecoder.Found found) {
                    answer(found.packet());
                }
            }
        }

        private void answer(SerialPacket request) {
            Bytes message = request.frame().message();
            boolean isCommand = request.frame().destination().equals(Address.SERIAL) && message.length() > 0;
            int command = isCommand ? message.at(0) : 0;
            if (command == 'P' && greeted) {
                poll(request, message);
            } else {
                reply(request, answer(command));
            }
        }

        private Bytes answer(int command) {
            if (command == 'H') {
                greeted = true;
                told = false;
                return GREETING;
            }
            if (!greeted) {
                return Bytes.of(Status.NOT_GREETED.ordinal());
            }
            return switch (command) {
                case 'C' -> NO_ACTIONS;
                case 'L', 'S' -> NONE;
                default -> Bytes.of(Status.UNKNOWN_COMMAND.ordinal());
            };
        }

        private void poll(SerialPacket request, Bytes message) {
            int flags = message.at(1);
            told = told && (flags & (WANTED | LOST)) == WANTED;
            boolean now = !told || (flags & AT_ONCE) != 0;
            boolean news = (flags & WANTED) != 0 && (changes || now);
            held = request;
            Duration time = !news ? Duration.ofMillis(message.number(2, 4)) : now ? Duration.ZERO : SAMPLE;
            end = PLAYER.schedule(() -> endHold(request, news), time.toNanos(), TimeUnit.NANOSECONDS);
        }

        private synchronized void endHold(SerialPacket request, boolean news) {
            if (held == request) {
                held = null;
                reply(request, news ? reading() : NOTHING_NEW);
            }
        }

        private Bytes reading() {
            told = true;
            light = (light + 1) % 1024;
            Bytes literal = Bytes.ofText("light(" + light + ")");
            return Bytes.join(Bytes.of(0, 4, 'P'), Bytes.ofNumber(literal.length(), 2), literal);
        }

        private void reply(SerialPacket request, Bytes message) {
            byte[] reply =
                    new SerialPacket(request.sequence(), new Frame(Address.SERIAL, Address.SERIAL, message)).encode()
                            .toArray();
            if (delay.isZero()) {
                write(pair.board(), reply);
            } else {
                PLAYER.schedule(() -> write(pair.board(), reply), delay.toNanos(), TimeUnit.NANOSECONDS);
            }
        }

        private void write(Link board, byte[] reply) {
            try {
                board.write(reply);
            } catch (LinkException closed) {
                // The host has closed the port.
                return;
            }
        }

        @Override
        public int read(byte[] into, Duration timeout) throws LinkException {
            return pair.host().read(into, timeout);
        }

        @Override
        public void wake() {
            pair.host().wake();
        }

        @Override
        public void close() {
            pair.host().close();
        }
    }
}
