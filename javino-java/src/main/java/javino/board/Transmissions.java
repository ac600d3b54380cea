package javino.board;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import javino.protocol.Outcome;

/** The transmissions that this session asked for and whose end is not known yet. For the session's thread only. */
final class Transmissions {

    private final BoardListener listener;
    private final Tally tally;
    /** Who is told the end, by numbers, which hold for one boot of the board. */
    private final Map<Integer, Consumer<Outcome>> underWay = new LinkedHashMap<>();

    Transmissions(BoardListener listener, Tally tally) {
        this.listener = listener;
        this.tally = tally;
    }

    /** Of this one the listener is told. */
    void begin(int number) {
        begin(number, outcome -> listener.transmitted(number, outcome));
    }

    void begin(int number, Consumer<Outcome> told) {
        underWay.put(number, told);
    }

    /** The board told an end; of what nobody here knows, only the counter is told. */
    void end(int number, Outcome outcome) {
        Consumer<Outcome> told = underWay.remove(number);
        if (told != null) {
            told.accept(outcome);
        } else {
            tally.count(SessionCounter.UNKNOWN_OUTCOMES);
        }
    }

    /** The board will tell no end any more. */
    void abandon() {
        List<Consumer<Outcome>> abandoned = List.copyOf(underWay.values());
        underWay.clear();
        for (Consumer<Outcome> told : abandoned) {
            tally.count(SessionCounter.ABANDONED_TRANSMISSIONS);
            told.accept(Outcome.UNDELIVERED);
        }
    }
}
