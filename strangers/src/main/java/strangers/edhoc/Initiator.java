package strangers.edhoc;

import java.security.SecureRandom;
import javino.protocol.Bytes;

/** The side that begins EDHOC. */
public final class Initiator implements Asking {

    /** Begins a run, with a new ephemeral key. */
    public Initiator(Party self, SecureRandom random) {
        throw new UnsupportedOperationException();
    }

    /** 37 bytes. */
    @Override
    public Bytes message1() {
        throw new UnsupportedOperationException();
    }

    /** @param message2 88 bytes, where the other's certificate has 42. @return 63 bytes, where the own has 42. */
    @Override
    public Bytes message3(Bytes message2) throws HandshakeException {
        throw new UnsupportedOperationException();
    }

    @Override
    public Secret secret() {
        throw new UnsupportedOperationException();
    }

    /** The other side, as {@link Party#peer} gave it. @throws IllegalStateException before a message 2 was taken. */
    public Credential peer() {
        throw new UnsupportedOperationException();
    }
}
