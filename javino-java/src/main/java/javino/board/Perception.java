package javino.board;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import javino.protocol.Bytes;
import javino.protocol.ProtocolException;

/** Knows when percepts are due, and tells the listener when they have changed. For the session's thread only. */
final class Perception {

    private final Wishes wishes;
    private final BoardListener listener;
    private final Tally tally;
    /** What was told last; null where nothing holds. */
    private List<Bytes> percepts;
    private boolean leftOut;
    /** When they were asked for last, on the monotonic clock. */
    private long asked;

    Perception(Wishes wishes, BoardListener listener, Tally tally) {
        this.wishes = wishes;
        this.listener = listener;
        this.tally = tally;
    }

    /** The board came online: percepts will be told anew. */
    void forget() {
        percepts = null;
        leftOut = false;
    }

    /** Tells that nothing is perceived, once percepts are wanted no longer. */
    void followWish() {
        if (!wishes.percepts() && percepts != null) {
            tell(List.of());
            percepts = null;
        }
        if (wishes.percepts()) {
            wishes.readings().notBefore(Duration.ofNanos(nanosUntilDue()));
        } else {
            wishes.readings().none();
        }
    }

    boolean isDue() {
        return wishes.percepts() && nanosUntilDue() <= 0;
    }

    private long nanosUntilDue() {
        return percepts == null ? 0 : wishes.perceptInterval().toNanos() - (System.nanoTime() - asked);
    }

    /** They are asked for now. */
    void asked() {
        asked = System.nanoTime();
        wishes.readings().asked();
    }

    void take(List<Bytes> literals, boolean someLeftOut) {
        if (someLeftOut && !leftOut) {
            listener.warning("the board has more percepts than fit one reply; the last ones are left out");
        }
        leftOut = someLeftOut;
        if (!literals.equals(percepts)) {
            tell(literals);
            percepts = literals;
        }
        wishes.readings().taken();
    }

    private void tell(List<Bytes> literals) {
        List<String> texts = new ArrayList<>();
        for (Bytes literal : literals) {
            try {
                texts.add(literal.text());
            } catch (ProtocolException e) {
                tally.count(SessionCounter.DAMAGED_RECORDS);
                listener.warning("a percept was skipped: " + e.getMessage());
            }
        }
        listener.percepts(List.copyOf(texts));
    }
}
