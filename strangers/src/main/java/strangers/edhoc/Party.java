package strangers.edhoc;

import java.security.interfaces.ECPrivateKey;
import javino.protocol.Bytes;

/** What one side of EDHOC is and believes. */
public interface Party {

    /** Its own credential. */
    Credential own();

    /** The secret of its own credential. */
    ECPrivateKey secret();

    /**
     * Finds the other side's credential, and decides whether that is somebody to talk to.
     *
     * @param kid as it came, not yet proved to be the sender's.
     * @throws HandshakeException if it is nobody to talk to.
     */
    Credential peer(Bytes kid) throws HandshakeException;
}
