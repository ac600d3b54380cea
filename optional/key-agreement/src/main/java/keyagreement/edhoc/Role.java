package keyagreement.edhoc;

import java.util.Optional;
import javino.protocol.Bytes;

/** One side of a handshake of three messages: by certificates, or by a secret that both have kept. */
public interface Role {

    /**
     * The result once the other side is verified.
     *
     * @param answer an initiator's message 3; else nothing.
     * @param secret the one that both sides have.
     * @param peer   the other side, as {@link Party#find} gave it; nothing where it was known before.
     */
    record Agreed(Bytes answer, Secret secret, Optional<Credential> peer) {
    }

    /** Message 1 or 2; the same bytes each time. */
    Bytes opening();

    /**
     * Takes message 2 or 3, by which the other side is verified.
     *
     * @throws HandshakeException if it is damaged, forged, or from whom it must not be; another can still be taken.
     */
    Agreed take(Bytes message) throws HandshakeException;
}
