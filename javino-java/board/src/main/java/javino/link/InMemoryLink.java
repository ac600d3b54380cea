package javino.link;

import java.time.Duration;

/** One end of a pair of links that are joined in memory: what one end writes, the other reads. */
public final class InMemoryLink implements Link {

    private static final String CLOSED = "the link is closed";

    private final String name;
    private final Incoming incoming;
    private final Incoming outgoing;
    private volatile boolean closed;

    private InMemoryLink(String name, Incoming incoming, Incoming outgoing) {
        this.name = name;
        this.incoming = incoming;
        this.outgoing = outgoing;
    }

    /**
     * Two joined ends.
     *
     * @param host  to be used by the host.
     * @param board to be used by what plays the board.
     */
    public record Pair(InMemoryLink host, InMemoryLink board) {
    }

    /** A new pair, whose name appears in errors. */
    public static Pair pair(String name) {
        Incoming toBoard = new Incoming(name);
        Incoming toHost = new Incoming(name);
        return new Pair(new InMemoryLink(name, toHost, toBoard), new InMemoryLink(name, toBoard, toHost));
    }

    @Override
    public void write(byte[] bytes) throws LinkException {
        if (closed) {
            throw new LinkException(name, CLOSED);
        }
        outgoing.add(bytes.clone());
    }

    @Override
    public int read(byte[] into, Duration timeout) throws LinkException {
        try {
            return incoming.read(into, timeout);
        } catch (LinkException e) {
            closed = true;
            throw e;
        }
    }

    @Override
    public void wake() {
        incoming.wake();
    }

    /** Closes both ends: what was written before can still be read at the other. */
    @Override
    public void close() {
        if (!closed) {
            closed = true;
            outgoing.end(CLOSED);
            incoming.end(CLOSED);
        }
    }
}
