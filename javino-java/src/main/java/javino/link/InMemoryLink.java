package javino.link;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** One end of a pair of links that are joined in memory: what one end writes, the other reads. */
public final class InMemoryLink implements Link {

    /** Stands for the end of the stream; told from data by its identity. */
    private static final byte[] CLOSED = new byte[0];

    private final String name;
    private final BlockingQueue<byte[]> incoming;
    private final BlockingQueue<byte[]> outgoing;
    private ByteBuffer rest = ByteBuffer.allocate(0);
    private volatile boolean closed;

    private InMemoryLink(String name, BlockingQueue<byte[]> incoming, BlockingQueue<byte[]> outgoing) {
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
        BlockingQueue<byte[]> toBoard = new LinkedBlockingQueue<>();
        BlockingQueue<byte[]> toHost = new LinkedBlockingQueue<>();
        return new Pair(new InMemoryLink(name, toHost, toBoard), new InMemoryLink(name, toBoard, toHost));
    }

    @Override
    public void write(byte[] bytes) throws LinkException {
        if (closed) {
            throw new LinkException(name, "the link is closed");
        }
        if (bytes.length > 0) {
            outgoing.add(bytes.clone());
        }
    }

    @Override
    public int read(byte[] into, Duration timeout) throws LinkException {
        if (!rest.hasRemaining()) {
            rest = ByteBuffer.wrap(await(timeout));
        }
        int count = Math.min(rest.remaining(), into.length);
        rest.get(into, 0, count);
        return count;
    }

    private byte[] await(Duration timeout) throws LinkException {
        try {
            byte[] next = incoming.poll(timeout.toNanos(), TimeUnit.NANOSECONDS);
            if (next == CLOSED) {
                closed = true;
                incoming.add(CLOSED);
                throw new LinkException(name, "the link is closed");
            }
            return next == null ? new byte[0] : next;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new LinkException(name, "interrupted while reading");
        }
    }

    /** Closes both ends: what was written before can still be read at the other. */
    @Override
    public void close() {
        if (!closed) {
            closed = true;
            outgoing.add(CLOSED);
            incoming.add(CLOSED);
        }
    }
}
