package javino.protocol;

import javino.JavinoException;

/** Received bytes do not follow SPEC.md; {@link #error()} says in which way. */
public final class ProtocolException extends JavinoException {

    private static final long serialVersionUID = 1L;

    private final ProtocolError error;

    /**
     * @param error    in which way the bytes are wrong.
     * @param evidence the bytes found and those expected, in one line.
     */
    public ProtocolException(ProtocolError error, String evidence) {
        super(error + ": " + evidence);
        this.error = error;
    }

    /** The way in which the bytes are wrong. */
    public ProtocolError error() {
        return error;
    }
}
