package javino.link;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;

/** The bytes that came over a link and were not read yet. Any thread adds; one reads. */
final class Incoming {

    /** Ends a read; told from data by its identity, and so is the next. */
    private static final byte[] WAKE = new byte[0];
    private static final byte[] END = new byte[0];

    private final String name;
    private final BlockingQueue<byte[]> chunks = new LinkedBlockingQueue<>();
    private final AtomicBoolean woken = new AtomicBoolean();
    private volatile String endedWhy;
    private ByteBuffer rest = ByteBuffer.allocate(0);

    /** @param name the link's, for error lines. */
    Incoming(String name) {
        this.name = name;
    }

    /** Adds bytes, which nobody may change afterwards. */
    void add(byte[] bytes) {
        if (bytes.length > 0) {
            chunks.add(bytes);
        }
    }

    /** Ends what comes. Bytes added before can still be read; the first reason given stands. */
    void end(String why) {
        if (endedWhy == null) {
            endedWhy = why;
        }
        chunks.add(END);
    }

    void wake() {
        // Once, however often it is called before the next read.
        if (woken.compareAndSet(false, true)) {
            chunks.add(WAKE);
        }
    }

    /** As {@link Link#read}. */
    int read(byte[] into, Duration timeout) throws LinkException {
        if (!rest.hasRemaining()) {
            rest = ByteBuffer.wrap(await(timeout));
        }
        int count = Math.min(rest.remaining(), into.length);
        rest.get(into, 0, count);
        return count;
    }

    private byte[] await(Duration timeout) throws LinkException {
        try {
            byte[] next = chunks.poll(timeout.toNanos(), TimeUnit.NANOSECONDS);
            if (next == END) {
                chunks.add(END);
                throw new LinkException(name, endedWhy);
            }
            if (next == WAKE) {
                woken.set(false);
            }
            return next == null ? WAKE : next;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new LinkException(name, "interrupted while reading");
        }
    }
}
