package trace;

/** A line is no event, or its event lacks a field; the message says which line it is, and why. */
public final class MalformedEventException extends IllegalArgumentException {

    private static final long serialVersionUID = 1L;

    private final int number;

    MalformedEventException(int number, String why) {
        super("line " + number + " is no line of a trace: " + why);
        this.number = number;
    }

    /** The line's number. */
    public int number() {
        return number;
    }
}
