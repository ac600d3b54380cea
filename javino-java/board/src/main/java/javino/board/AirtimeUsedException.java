package javino.board;

import javino.JavinoException;

/** A message was refused, and not sent: the board has no room for it while its airtime limit holds back others. */
public final class AirtimeUsedException extends JavinoException {

    private static final long serialVersionUID = 1L;

    private final long seconds;

    /**
     * @param request describes what was asked.
     * @param seconds until the board lets a new message go.
     */
    public AirtimeUsedException(String request, long seconds) {
        super(request + " was not performed: the board's airtime limit holds messages back; try again in "
                + seconds + " s");
        this.seconds = seconds;
    }

    /** Until the board lets a new message go, in s. */
    public long seconds() {
        return seconds;
    }
}
