package keyagreement.edhoc;

import javino.JavinoException;

/**
 * A message of a handshake that was refused. It changes nothing: the same handshake can still take the genuine message
 * that comes later, so that a forger ends none.
 */
public final class HandshakeException extends JavinoException {

    private static final long serialVersionUID = 1L;

    /** Why. Only what is behind a proof, so not the first, may be told to agents: anybody can cause the rest. */
    public enum Reason {
        /** The message is damaged or forged, or its certificate is not what it must be. */
        NOT_CERTIFIED,
        /** A revocation list of the authority names the certificate. */
        REVOKED,
        /** The certificate's last day is past. */
        EXPIRED
    }

    private final Reason reason;

    /** @param message one line. */
    public HandshakeException(Reason reason, String message) {
        super(message);
        this.reason = reason;
    }

    /** A message proves nothing. */
    public HandshakeException(String message) {
        this(Reason.NOT_CERTIFIED, message);
    }

    /** Why. */
    public Reason reason() {
        return reason;
    }
}
