package campaign;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import javino.protocol.Outcome;

/** Brings a board's transmissions and their outcomes together, whichever of the two is known first. */
final class Transmissions {

    private final Map<Integer, Consumer<Outcome>> underWay = new HashMap<>();
    private final Map<Integer, Outcome> early = new HashMap<>();

    /** The board has taken a message under this number. */
    void begin(int number, Consumer<Outcome> end) {
        Outcome outcome;
        synchronized (this) {
            // A future that was complete before it was looked at may be overtaken by the transmission's end.
            outcome = early.remove(number);
            if (outcome == null) {
                underWay.put(number, end);
            }
        }
        if (outcome != null) {
            end.accept(outcome);
        }
    }

    /** The session says how it ended. */
    void finish(int number, Outcome outcome) {
        Consumer<Outcome> end;
        synchronized (this) {
            end = underWay.remove(number);
            if (end == null) {
                early.put(number, outcome);
            }
        }
        if (end != null) {
            end.accept(outcome);
        }
    }
}
