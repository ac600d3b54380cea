package javino.board;

import javino.JavinoException;

/** A request was refused, and not performed, because too many others wait for the board. */
public final class QueueFullException extends JavinoException {

    private static final long serialVersionUID = 1L;

    /**
     * @param request  describes what was asked.
     * @param capacity how many requests may wait.
     */
    public QueueFullException(String request, int capacity) {
        super(request + " was not performed: " + capacity + " requests are waiting for the board already");
    }
}
