package javino.board;

import javino.JavinoException;
import javino.protocol.Status;

/** The board refused a request; it was not performed. */
public final class RequestFailedException extends JavinoException {

    private static final long serialVersionUID = 1L;

    private final Status status;

    /**
     * @param request describes what was asked.
     * @param status  why it was refused.
     */
    public RequestFailedException(String request, Status status) {
        super(request + " failed: " + status + ", " + status.explanation());
        this.status = status;
    }

    /** Why the request was refused. */
    public Status status() {
        return status;
    }
}
