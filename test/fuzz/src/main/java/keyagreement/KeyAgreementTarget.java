package keyagreement;

import java.security.SecureRandom;
import java.security.interfaces.ECPrivateKey;
import java.time.LocalDate;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.ProtocolError;
import javino.protocol.ProtocolException;
import keyagreement.edhoc.Credential;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.Initiator;
import keyagreement.edhoc.P256;
import keyagreement.edhoc.Party;
import keyagreement.edhoc.Responder;

/**
 * The same bytes as each thing that an attacker may send. A host message, certificate or revocation list that can be
 * read is written as it was; what is no message of a handshake is refused, and says why; and no message 2 or 3 is
 * taken, since nobody here has made one.
 */
public final class KeyAgreementTarget {

    private static final int MESSAGE_2_LENGTH = 88;
    private static final SecureRandom RANDOM = new SecureRandom();
    private static final Host HOST = new Host();
    private static final Responder ANSWERED = answered();

    private KeyAgreementTarget() {
    }

    /** Something that may refuse what it is given. */
    private interface Reading {
        void run() throws HandshakeException;
    }

    /** A host with a certificate, whose authority it asks for the keys of others. */
    private static final class Host implements Party {
        private final Authority authority = Authority.create(LocalDate.EPOCH, RANDOM);
        private final P256.Pair keys = P256.generate(RANDOM);

        @Override
        public Credential own() {
            Bytes kid = Bytes.copyOf(new byte[Certificate.LENGTH]);
            return new Credential(kid, kid, keys.key());
        }

        @Override
        public ECPrivateKey secret() {
            return keys.secret();
        }

        @Override
        public Credential find(Bytes kid) throws HandshakeException {
            return Certificate.decode(kid).credential(authority.keys());
        }

        @Override
        public void admit(Credential proved) {
            // Nobody is past or revoked.
        }
    }

    public static void fuzzerTestOneInput(byte[] data) {
        Bytes bytes = Bytes.copyOf(data);
        try {
            holds(HostMessage.decode(bytes).encode().equals(bytes), "a host message");
        } catch (ProtocolException none) {
            holds(none.error() == ProtocolError.BAD_HOST_MESSAGE, "what is no host message");
        }
        reads(() -> {
            Certificate certificate = Certificate.decode(bytes);
            holds(certificate.toBytes().equals(bytes), "a certificate");
            certificate.credential(HOST.authority.keys());
        });
        reads(() -> {
            RevocationList revocationList = RevocationList.decode(bytes);
            holds(revocationList.toBytes().equals(bytes), "a revocation list");
            holds(!revocationList.isOf(HOST.authority.keys()), "nobody has signed it");
        });
        reads(() -> holds(new Responder(HOST, bytes, RANDOM).opening().length() == MESSAGE_2_LENGTH, "message 2"));
        reads(() -> {
            new Initiator(HOST, RANDOM).take(bytes);
            throw new AssertionError("a message 2 that nobody has made is taken");
        });
        reads(() -> {
            ANSWERED.take(bytes);
            throw new AssertionError("a message 3 that nobody has made is taken");
        });
    }

    private static void reads(Reading reading) {
        try {
            reading.run();
        } catch (HandshakeException refused) {
            holds(!refused.getMessage().isEmpty(), "a refusal says why");
        }
    }

    private static void holds(boolean condition, String what) {
        if (!condition) {
            throw new AssertionError(what + " is not as it must be");
        }
    }

    private static Responder answered() {
        try {
            return new Responder(HOST, new Initiator(HOST, RANDOM).opening(), RANDOM);
        } catch (HandshakeException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}
