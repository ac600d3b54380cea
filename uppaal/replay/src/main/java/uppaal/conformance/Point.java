package uppaal.conformance;

import trace.TraceEvent;

/**
 * A transition that a board's program declares.
 *
 * @param name as in the firmware's {@code TracePoints.h}, and at the models' edges
 */
public record Point(TraceEvent event, String name) {
    static Point of(TraceEvent event) {
        return new Point(event, event.text("name"));
    }

    public String board() {
        return event.board();
    }

    public double seconds() {
        return event.seconds();
    }

    public boolean is(String point) {
        return name.equals(point);
    }

    /**
     * The operand that the list of points calls so.
     *
     * @throws trace.MalformedEventException if there is none
     */
    public int operand(String operand) {
        return event.number(operand);
    }

    /** When the run() began that it lies in, in seconds. */
    public double run() {
        return event.real("run");
    }

    /** The time from the run() before to that one, in seconds. */
    public double gap() {
        return event.real("gap");
    }
}
