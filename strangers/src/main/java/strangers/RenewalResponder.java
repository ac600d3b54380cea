package strangers;

import java.security.SecureRandom;
import javino.protocol.Address;
import javino.protocol.Bytes;
import strangers.edhoc.Answering;
import strangers.edhoc.HandshakeException;
import strangers.edhoc.Secret;

/** The side that answers a {@link RenewalInitiator}. Until {@link #finish} its kept secret must stay what it was. */
public final class RenewalResponder implements Answering {

    /**
     * Answers.
     *
     * @param self who answers.
     * @param peer who began.
     * @throws HandshakeException if message 1 was made with another secret than this: the sender has no such secret,
     *                            or it missed a message 3, or was missed one.
     */
    public RenewalResponder(Secret kept, Address self, Address peer, Bytes message1, SecureRandom random)
            throws HandshakeException {
        throw new UnsupportedOperationException();
    }

    /** 16 bytes. */
    @Override
    public Bytes message2() {
        throw new UnsupportedOperationException();
    }

    @Override
    public Secret finish(Bytes message3) throws HandshakeException {
        throw new UnsupportedOperationException();
    }
}
