package javino.fake;

import java.util.List;
import javino.protocol.Bytes;

/** The percepts of a fake board, and the reading that it told last. */
final class Percepts {

    private List<Bytes> current = List.of();
    /** Null: the board tells the next one at once. */
    private List<Bytes> told;
    private long toldAt;

    synchronized void set(List<Bytes> literals) {
        current = literals;
    }

    synchronized void forgetReading() {
        told = null;
    }

    /** How long until the board may tell a reading, as things are now. */
    synchronized long nanosUntilReading(Poll poll) {
        if (!poll.wantsPercepts()) {
            return Long.MAX_VALUE;
        }
        if (told == null || poll.wantsThemNow()) {
            return 0;
        }
        return told.equals(current) ? Long.MAX_VALUE : Math.max(0, toldAt + poll.leastNanos() - System.nanoTime());
    }

    /** A reply with all percepts that fit. */
    synchronized Bytes tell(int flags) {
        told = current;
        toldAt = System.nanoTime();
        Bytes records = Bytes.EMPTY;
        int leftOut = 0;
        for (Bytes literal : current) {
            Bytes longer = Bytes.join(records, Poll.record('P', literal));
            leftOut |= longer.length() > Poll.ROOM ? Poll.LEFT_OUT : 0;
            records = longer.length() > Poll.ROOM ? records : longer;
        }
        return Bytes.join(Bytes.of(0, flags | Poll.READING | leftOut), records);
    }
}
