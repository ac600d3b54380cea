package javino.board;

import javino.JavinoException;

/** The board has no room for a message, which is not sent: those before it wait there until its budget allows more airtime. */
public final class AirtimeUsedException extends JavinoException {

    private static final long serialVersionUID = 1L;

    private final long seconds;

    /**
     * @param request describes what was asked.
     * @param seconds until the board lets the next message go.
     */
    public AirtimeUsedException(String request, long seconds) {
        super(request + " was not performed: the board's budget of airtime is used, and messages wait there; try again"
                + " in " + seconds + " s");
        this.seconds = seconds;
    }

    /** Until the board lets the next message go, in s. */
    public long seconds() {
        return seconds;
    }
}
