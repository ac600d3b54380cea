package strangers;

import java.security.SecureRandom;
import javino.protocol.Address;
import javino.protocol.Bytes;
import strangers.edhoc.Asking;
import strangers.edhoc.HandshakeException;
import strangers.edhoc.Secret;

/** The side that begins again, from a secret that two devices have kept: EDHOC's key update with nonces of both. */
public final class RenewalInitiator implements Asking {

    /**
     * Begins.
     *
     * @param kept what both have from their last handshake or renewal.
     * @param self who begins.
     * @param peer who answers.
     */
    public RenewalInitiator(Secret kept, Address self, Address peer, SecureRandom random) {
        throw new UnsupportedOperationException();
    }

    /** 16 bytes. */
    @Override
    public Bytes message1() {
        throw new UnsupportedOperationException();
    }

    /** @param message2 16 bytes. @return 8 bytes. */
    @Override
    public Bytes message3(Bytes message2) throws HandshakeException {
        throw new UnsupportedOperationException();
    }

    @Override
    public Secret secret() {
        throw new UnsupportedOperationException();
    }
}
