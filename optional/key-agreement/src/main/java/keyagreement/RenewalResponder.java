package keyagreement;

import java.security.SecureRandom;
import javino.protocol.Address;
import javino.protocol.Bytes;
import keyagreement.edhoc.ResponderRole;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.Secret;

/** The side that answers a {@link RenewalInitiator}. Until {@link #finish} its kept secret must stay what it was. */
public final class RenewalResponder implements ResponderRole {

    private final Renewal.Updated updated;

    /**
     * Answers.
     *
     * @param kept what both have from their last handshake or renewal.
     * @param self who answers.
     * @param peer who began.
     * @throws HandshakeException if message 1 was made with another secret than this: it is forged, or one side has not
     *                            got the last message 3.
     */
    public RenewalResponder(Secret kept, Address self, Address peer, Bytes message1, SecureRandom random)
            throws HandshakeException {
        Renewal renewal = new Renewal(kept, Identity.pair(peer, self));
        Bytes nonce = Renewal.nonce(message1);
        Renewal.verify(message1, renewal.message1(nonce));
        updated = renewal.updated(nonce, Renewal.nonce(random));
    }

    /** 16 bytes. */
    @Override
    public Bytes message2() {
        return updated.message2();
    }

    @Override
    public Secret finish(Bytes message3) throws HandshakeException {
        Renewal.verify(message3, updated.message3());
        return updated.secret();
    }
}
