package keyagreement.edhoc;

import javino.protocol.Bytes;

/** The side that begins a handshake of three messages: by certificates, or by a secret that both have kept. */
public interface InitiatorRole {

    /** What begins it; the same bytes each time. */
    Bytes message1();

    /**
     * Takes message 2. Once it has taken one, the other side is verified, and the same message gives the same answer.
     *
     * @return message 3, which has to reach the other side.
     * @throws HandshakeException if it is damaged, forged, or from whom it must not be; another can still be taken.
     */
    Bytes message3(Bytes message2) throws HandshakeException;

    /**
     * What both sides then have.
     *
     * @throws IllegalStateException before a message 2 was taken.
     */
    Secret secret();
}
