package keyagreement.edhoc;

import java.security.interfaces.ECPrivateKey;
import javino.protocol.Bytes;

/** One side of EDHOC: its credential, and its trust in others. */
public interface Party {

    /** Its own credential. */
    Credential own();

    /** The secret of its own credential. */
    ECPrivateKey secret();

    /**
     * Finds the other side's credential.
     *
     * @param kid as it came, not yet proved to be the sender's.
     * @throws HandshakeException if it is none, or of somebody else than who is to be talked to.
     */
    Credential find(Bytes kid) throws HandshakeException;

    /**
     * Decides about the other side, once it has proved that the credential is its own. So nobody can have somebody
     * else's credential reported as expired.
     *
     * @throws HandshakeException if it is not to be talked to.
     */
    void admit(Credential proved) throws HandshakeException;
}
