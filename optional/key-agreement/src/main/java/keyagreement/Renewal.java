package keyagreement;

import java.security.SecureRandom;
import java.util.Optional;
import javino.protocol.Address;
import javino.protocol.Bytes;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.Role;
import keyagreement.edhoc.Secret;

/**
 * Renews a secret that two devices have kept (SPEC 11.1): EDHOC's key update with nonces of both, each message with a
 * proof of 8 bytes.
 *
 * @param pair the addresses of who begins and who answers, 6 bytes.
 */
record Renewal(Secret kept, Bytes pair) {

    private static final int PROOF_LABEL = 32769;
    private static final int NONCE_LENGTH = 8;
    private static final int PROOF_LENGTH = 8;

    /** The side that begins. */
    static Role begin(Secret kept, Address self, Address peer, SecureRandom random) {
        Renewal renewal = new Renewal(kept, Identity.pair(self, peer));
        Bytes nonce = Bytes.random(random, NONCE_LENGTH);
        return new Role() {

            private Bytes taken;

            @Override
            public Bytes opening() {
                return renewal.message1(nonce);
            }

            @Override
            public Agreed take(Bytes message2) throws HandshakeException {
                Renewal next = renewal.updated(nonce, nonceOf(message2));
                verify(message2, taken == null ? Bytes.join(nonceOf(message2), next.proof(2, Bytes.EMPTY)) : taken);
                taken = message2;
                return new Agreed(next.proof(3, Bytes.EMPTY), next.kept, Optional.empty());
            }
        };
    }

    /**
     * The side that answers.
     *
     * @throws HandshakeException if message 1 was made with another secret than this: it is forged, or one side has not
     *                            got the last message 3.
     */
    static Role answer(Secret kept, Address self, Address peer, Bytes message1, SecureRandom random)
            throws HandshakeException {
        Renewal renewal = new Renewal(kept, Identity.pair(peer, self));
        verify(message1, renewal.message1(nonceOf(message1)));
        Bytes nonce = Bytes.random(random, NONCE_LENGTH);
        Renewal next = renewal.updated(nonceOf(message1), nonce);
        return new Role() {

            @Override
            public Bytes opening() {
                return Bytes.join(nonce, next.proof(2, Bytes.EMPTY));
            }

            @Override
            public Agreed take(Bytes message3) throws HandshakeException {
                verify(message3, next.proof(3, Bytes.EMPTY));
                return new Agreed(Bytes.EMPTY, next.kept, Optional.empty());
            }
        };
    }

    private Bytes message1(Bytes nonce) {
        return Bytes.join(nonce, proof(1, nonce));
    }

    private Renewal updated(Bytes initiatorNonce, Bytes responderNonce) {
        return new Renewal(kept.updated(Bytes.join(initiatorNonce, responderNonce)), pair);
    }

    private Bytes proof(int message, Bytes nonce) {
        return kept.export(PROOF_LABEL, Bytes.join(Bytes.of(message), pair, nonce), PROOF_LENGTH);
    }

    /** The nonce of a message 1 or 2. */
    private static Bytes nonceOf(Bytes message) throws HandshakeException {
        if (message.length() != NONCE_LENGTH + PROOF_LENGTH) {
            throw new HandshakeException("the message is refused: its length is wrong");
        }
        return message.slice(0, NONCE_LENGTH);
    }

    private static void verify(Bytes received, Bytes expected) throws HandshakeException {
        if (!received.isSame(expected)) {
            throw new HandshakeException("the message is refused: it was made with another secret, or it is damaged");
        }
    }
}
