package javino.link;

import java.time.Duration;

/** An open two-way stream of bytes to a board. One thread reads and writes; any may wake it, or close. */
public interface Link extends AutoCloseable {

    /**
     * Writes all the bytes.
     *
     * @throws LinkException if the link is broken or closed.
     */
    void write(byte[] bytes) throws LinkException;

    /**
     * Waits until at least one byte is there, and reads all that are.
     *
     * @param into    filled from its start.
     * @param timeout how long to wait at most.
     * @return how many bytes were read, or 0 if none came in time, or {@link #wake} was called.
     * @throws LinkException if the link is broken or closed.
     */
    int read(byte[] into, Duration timeout) throws LinkException;

    /** Ends a {@link #read} that waits, or the coming one. Never waits; does nothing if the link is closed. */
    void wake();

    /**
     * How long bytes take on the line.
     *
     * @return zero, unless the link is slow and knows its speed.
     */
    default Duration timeFor(int bytes) {
        return Duration.ZERO;
    }

    /**
     * The speed of the line.
     *
     * @return bits a second; zero if the link has no speed.
     */
    default int baud() {
        return 0;
    }

    /**
     * Changes the speed of the line, which stays open, so that a board is not reset. Bytes still on the line may be
     * damaged. Does nothing if the link has no speed.
     *
     * @param baud bits a second.
     * @throws LinkException if the link is broken, or does not take this speed.
     */
    default void setBaud(int baud) throws LinkException {
    }

    /** Closes the link; a second time does nothing. */
    @Override
    void close();
}
