package strangers.edhoc;

import java.security.SecureRandom;
import javino.protocol.Bytes;

/** The side that answers EDHOC. */
public final class Responder implements Answering {

    /**
     * Answers a message 1, with a new ephemeral key.
     *
     * @throws HandshakeException if it is no message 1 of method 3 and suite 2.
     */
    public Responder(Party self, Bytes message1, SecureRandom random) throws HandshakeException {
        throw new UnsupportedOperationException();
    }

    @Override
    public Bytes message2() {
        throw new UnsupportedOperationException();
    }

    @Override
    public Secret finish(Bytes message3) throws HandshakeException {
        throw new UnsupportedOperationException();
    }

    /** The other side, as {@link Party#peer} gave it. @throws IllegalStateException before a message 3 was taken. */
    public Credential peer() {
        throw new UnsupportedOperationException();
    }
}
