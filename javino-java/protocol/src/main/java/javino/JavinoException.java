package javino;

/** The base of all errors of a board, its link or its protocol; the message is one line with the evidence. */
public class JavinoException extends Exception {

    private static final long serialVersionUID = 1L;

    /** @param message one line: what was wrong, and where it helps, what to do. */
    public JavinoException(String message) {
        super(message);
    }

    /**
     * @param message one line: what was wrong, and where it helps, what to do.
     * @param cause   the exception that was caught, or null.
     */
    public JavinoException(String message, Throwable cause) {
        super(message, cause);
    }
}
