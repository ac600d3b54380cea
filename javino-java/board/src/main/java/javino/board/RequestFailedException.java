package javino.board;

import java.util.Optional;
import javino.JavinoException;
import javino.protocol.Status;

/** The board refused a request; it was not performed. */
public final class RequestFailedException extends JavinoException {

    private static final long serialVersionUID = 1L;

    private final Status status;
    private final String reason;

    /**
     * @param request describes what was asked.
     * @param status  why it was refused.
     */
    public RequestFailedException(String request, Status status) {
        this(request, status, Optional.empty());
    }

    /** @param said the reason that the sketch has printed: one line. */
    RequestFailedException(String request, Status status, Optional<String> said) {
        super(request + " failed: " + status + ", " + status.explanation()
                + said.map(text -> "; it says: " + text).orElse(""));
        this.status = status;
        reason = said.orElse(null);
    }

    /** Why the request was refused. */
    public Status status() {
        return status;
    }

    /**
     * What the sketch has printed before it refused an action, 3…200 characters in one line. It may be missing or
     * damaged: the line checks no text, and an action that is asked for again prints nothing.
     */
    public Optional<String> reason() {
        return Optional.ofNullable(reason);
    }
}
