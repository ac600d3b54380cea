package keyagreement;

import java.security.SecureRandom;
import javino.protocol.Bytes;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.HandshakeException.Reason;
import keyagreement.edhoc.Kdf;
import keyagreement.edhoc.Secret;

/**
 * The messages by which two devices renew a secret that both have kept (SPEC 11.1), each with a proof of 8 bytes.
 *
 * @param pair the addresses of who begins and who answers, 6 bytes.
 */
record Renewal(Secret kept, Bytes pair) {

    private static final int PROOF_LABEL = 32769;
    private static final int NONCE_LENGTH = 8;
    private static final int PROOF_LENGTH = 8;

    static Bytes nonce(SecureRandom random) {
        byte[] nonce = new byte[NONCE_LENGTH];
        random.nextBytes(nonce);
        return Bytes.copyOf(nonce);
    }

    /** That of a message 1 or 2. */
    static Bytes nonce(Bytes message) throws HandshakeException {
        if (message.length() != NONCE_LENGTH + PROOF_LENGTH) {
            throw new HandshakeException(Reason.NOT_CERTIFIED, "the message is refused: its length is wrong");
        }
        return message.slice(0, NONCE_LENGTH);
    }

    static void verify(Bytes received, Bytes expected) throws HandshakeException {
        if (!Kdf.same(received, expected)) {
            throw new HandshakeException(Reason.NOT_CERTIFIED,
                    "the message is refused: it was made with another secret, or it is damaged");
        }
    }

    Bytes message1(Bytes initiatorNonce) {
        Bytes context = Bytes.join(Bytes.of(1), pair, initiatorNonce);
        return Bytes.join(initiatorNonce, kept.export(PROOF_LABEL, context, PROOF_LENGTH));
    }

    /** What both have after the two nonces. */
    record Updated(Secret secret, Bytes pair, Bytes responderNonce) {

        Bytes message2() {
            return Bytes.join(responderNonce, proof(2));
        }

        Bytes message3() {
            return proof(3);
        }

        private Bytes proof(int number) {
            return secret.export(PROOF_LABEL, Bytes.join(Bytes.of(number), pair), PROOF_LENGTH);
        }
    }

    Updated updated(Bytes initiatorNonce, Bytes responderNonce) {
        return new Updated(kept.updated(Bytes.join(initiatorNonce, responderNonce)), pair, responderNonce);
    }
}
