package keyagreement.edhoc;

import javino.protocol.Bytes;

/** The side that answers a handshake of three messages. */
public interface ResponderRole {

    /** The answer to message 1; the same bytes each time. Until {@link #finish} the other side is not verified. */
    Bytes message2();

    /**
     * Takes message 3, with which the other side is verified.
     *
     * @return what both sides now have.
     * @throws HandshakeException if it is damaged, forged, or from whom it must not be; another can still be taken.
     */
    Secret finish(Bytes message3) throws HandshakeException;
}
