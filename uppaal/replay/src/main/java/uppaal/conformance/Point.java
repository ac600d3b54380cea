package uppaal.conformance;

import java.util.List;
import java.util.Optional;
import javino.protocol.Counter;
import trace.TraceEvent;

/**
 * A transition that a board's program declares.
 *
 * @param name as in the firmware's {@code TracePoints.h}, and at the models' edges; a SEND that others of its attempt
 *     follow is a SEND_PART
 * @param number of the transmission that it is of, if it is a sender's: that of the last TURN
 * @param packets those that it may be about, as they have come; mostly one at most
 */
record Point(TraceEvent event, String name, int number, List<Reception> packets) {

    String board() {
        return event.board();
    }

    double seconds() {
        return event.seconds();
    }

    void require(boolean isRight, String expected) throws RefusedException {
        if (!isRight) {
            throw new RefusedException(toString(), expected);
        }
    }

    @Override
    public String toString() {
        return board() + " declares " + name;
    }

    boolean is(String point) {
        return name.equals(point);
    }

    /**
     * The operand that the list of points calls so.
     *
     * @throws trace.MalformedEventException if there is none
     */
    int operand(String operand) {
        return event.number(operand);
    }

    /** The counter, if it is a COUNT. */
    Optional<Counter> counter() {
        return is("COUNT") ? Counter.of(operand("counter")) : Optional.empty();
    }

    /** When the run() began that it lies in, in seconds. */
    double run() {
        return event.real("run");
    }

    /** The time from the run() before to that one, in seconds. */
    double gap() {
        return event.real("gap");
    }

    /** When that run() before began, in seconds. */
    double runBefore() {
        return run() - gap();
    }
}
