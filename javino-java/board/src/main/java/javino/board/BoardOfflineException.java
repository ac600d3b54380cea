package javino.board;

import javino.JavinoException;

/** A request was not performed, because the board cannot be reached or the session has ended. */
public final class BoardOfflineException extends JavinoException {

    private static final long serialVersionUID = 1L;

    /**
     * @param request describes what was asked.
     * @param why     why the board cannot be reached.
     */
    public BoardOfflineException(String request, String why) {
        super(request + " was not performed: " + why);
    }
}
