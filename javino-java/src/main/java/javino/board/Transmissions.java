package javino.board;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import javino.protocol.Outcome;

/** The transmissions that this session asked for and whose end is not known yet. For the session's thread only. */
final class Transmissions {

    private final BoardListener listener;
    private final Tally tally;
    /** Numbers, which hold for one boot of the board. */
    private final Set<Integer> underWay = new LinkedHashSet<>();

    Transmissions(BoardListener listener, Tally tally) {
        this.listener = listener;
        this.tally = tally;
    }

    void begin(int number) {
        underWay.add(number);
    }

    /** The board told an end; of what nobody here knows, only the counter is told. */
    void end(int number, Outcome outcome) {
        if (underWay.remove(number)) {
            listener.transmitted(number, outcome);
        } else {
            tally.count(SessionCounter.UNKNOWN_OUTCOMES);
        }
    }

    /** The board will tell no end any more. */
    void abandon() {
        List<Integer> abandoned = List.copyOf(underWay);
        underWay.clear();
        for (int number : abandoned) {
            tally.count(SessionCounter.ABANDONED_TRANSMISSIONS);
            listener.transmitted(number, Outcome.UNDELIVERED);
        }
    }
}
