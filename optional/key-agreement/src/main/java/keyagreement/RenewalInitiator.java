package keyagreement;

import java.security.SecureRandom;
import javino.protocol.Address;
import javino.protocol.Bytes;
import keyagreement.edhoc.InitiatorRole;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.Secret;

/** The side that begins again, from a secret that two devices have kept: EDHOC's key update with nonces of both. */
public final class RenewalInitiator implements InitiatorRole {

    private final Renewal renewal;
    private final Bytes nonce;
    private Renewal.Updated updated;
    private Bytes message2;

    /**
     * Begins.
     *
     * @param kept what both have from their last handshake or renewal.
     * @param self who begins.
     * @param peer who answers.
     */
    public RenewalInitiator(Secret kept, Address self, Address peer, SecureRandom random) {
        renewal = new Renewal(kept, Identity.pair(self, peer));
        nonce = Renewal.nonce(random);
    }

    /** 16 bytes. */
    @Override
    public Bytes message1() {
        return renewal.message1(nonce);
    }

    /** @param message2 16 bytes. @return 8 bytes. */
    @Override
    public Bytes message3(Bytes message2) throws HandshakeException {
        if (updated == null) {
            Renewal.Updated next = renewal.updated(nonce, Renewal.nonce(message2));
            Renewal.verify(message2, next.message2());
            updated = next;
            this.message2 = message2;
        }
        Renewal.verify(message2, this.message2);
        return updated.message3();
    }

    @Override
    public Secret secret() {
        if (updated == null) {
            throw new IllegalStateException("no message 2 was taken yet");
        }
        return updated.secret();
    }
}
