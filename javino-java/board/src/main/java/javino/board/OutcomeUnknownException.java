package javino.board;

import javino.JavinoException;

/** The board was lost or reset while a request was under way; nobody knows whether it was performed. */
public final class OutcomeUnknownException extends JavinoException {

    private static final long serialVersionUID = 1L;

    /**
     * @param request describes what was asked.
     * @param why     the event meanwhile, in one line.
     */
    public OutcomeUnknownException(String request, String why) {
        super(why + "; it is not known whether " + request + " was performed");
    }
}
