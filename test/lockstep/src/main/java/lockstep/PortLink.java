package lockstep;

import java.io.ByteArrayOutputStream;
import java.time.Duration;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.SerialLink;

/** A host's end of an emulated board's port. */
final class PortLink implements Link {

    private static final String UNPLUGGED = "cannot be read; was the board unplugged?";
    /** How long a host waits that has more to write than the port takes. */
    private static final long FULL_NANOS = 1_000_000;
    /** A start bit, eight of data, a stop bit. */
    private static final int BITS_A_BYTE = 10;

    private final Simulation simulation;
    private final int board;
    private final String name;
    private final ByteArrayOutputStream come = new ByteArrayOutputStream();
    private final Signal signal;
    private final ClassLoader program = Thread.currentThread().getContextClassLoader();
    private boolean woken;
    private boolean gone;
    private boolean closed;
    /** When the bytes have come that are under way. */
    private long lastDue;
    private int baud = SerialLink.DEFAULT_BAUD;

    PortLink(Simulation simulation, int board, String name) {
        this.simulation = simulation;
        this.board = board;
        this.name = name;
        signal = new Signal(simulation);
    }

    /** The board has been unplugged. */
    void unplugged() {
        gone = true;
        signal.tell();
    }

    /** Bytes are under way from the board, and overtake none. */
    void coming(byte[] bytes, long due) {
        lastDue = Math.max(lastDue, due);
        simulation.at(lastDue, program, () -> {
            come.writeBytes(bytes);
            signal.tell();
        });
    }

    private void check() throws LinkException {
        simulation.check();
        if (gone || closed) {
            throw new LinkException(name, closed ? "was closed" : UNPLUGGED);
        }
    }

    @Override
    public void write(byte[] bytes) throws LinkException {
        for (int written = 0; written < bytes.length;) {
            check();
            int taken = simulation.emulator().write(board, bytes, written);
            if (taken < 0) {
                throw new LinkException(name, "cannot be written; was the board unplugged?");
            }
            written += taken;
            if (written < bytes.length) {
                simulation.pause(FULL_NANOS);
            }
        }
    }

    @Override
    public int read(byte[] into, Duration timeout) throws LinkException {
        check();
        signal.await(() -> gone || closed || woken || come.size() > 0, simulation.in(timeout));
        check();
        woken = false;
        byte[] all = come.toByteArray();
        int count = Math.min(all.length, into.length);
        System.arraycopy(all, 0, into, 0, count);
        come.reset();
        come.write(all, count, all.length - count);
        return count;
    }

    @Override
    public void wake() {
        simulation.check();
        woken = true;
        signal.tell();
    }

    @Override
    public Duration timeFor(int bytes) {
        return Duration.ofNanos(1_000_000_000L * BITS_A_BYTE * bytes / baud);
    }

    @Override
    public int baud() {
        return baud;
    }

    @Override
    public void setBaud(int other) {
        baud = other;
    }

    @Override
    public void close() {
        simulation.check();
        if (!closed) {
            closed = true;
            simulation.closed(board, !gone);
            signal.tell();
        }
    }
}
