package javino.board;

import javino.JavinoException;

/** A request was not performed, because the board speaks the older protocol, which has no such request (SPEC 8). */
public final class LegacyBoardException extends JavinoException {

    private static final long serialVersionUID = 1L;

    /** @param request describes what was asked. */
    public LegacyBoardException(String request) {
        this(request, "which has percepts and actions only; for all else flash a sketch with the library JavinoBDI");
    }

    /**
     * @param request describes what was asked.
     * @param remedy  the lack of the older protocol, and what to do.
     */
    LegacyBoardException(String request, String remedy) {
        super(request + " was not performed: the board speaks the older protocol, " + remedy);
    }
}
