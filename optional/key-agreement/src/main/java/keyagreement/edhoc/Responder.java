package keyagreement.edhoc;

import java.security.SecureRandom;
import java.security.interfaces.ECPublicKey;
import java.util.Optional;
import javino.protocol.Bytes;
import keyagreement.edhoc.KeySchedule.Proof;
import keyagreement.edhoc.KeySchedule.Second;
import keyagreement.edhoc.KeySchedule.Third;

/** The side that answers EDHOC. */
public final class Responder implements Role {

    /** C_R. */
    private static final Bytes IDENTIFIER = Bytes.of(0x01);

    private final Party self;
    private final P256.Pair ephemeral;
    private final Bytes message2;
    private final Third third;

    /**
     * Answers a message 1, with a new ephemeral key.
     *
     * @throws HandshakeException if it is no message 1 of method 3 and suite 2.
     */
    public Responder(Party self, Bytes message1, SecureRandom random) throws HandshakeException {
        this(self, message1, P256.generate(random), IDENTIFIER);
    }

    Responder(Party self, Bytes message1, P256.Pair ephemeral, Bytes identifier) throws HandshakeException {
        this.self = self;
        this.ephemeral = ephemeral;
        ECPublicKey gX = read(message1);
        Credential own = self.own();
        Second second = Second.of(message1, ephemeral.x(), P256.agree(ephemeral.secret(), gX));
        Bytes prk3e2m = second.prk3e2m(P256.agree(self.secret(), gX));
        Proof proof = new Proof(own.kid(), second.mac(prk3e2m, identifier, own, Bytes.EMPTY), Bytes.EMPTY);
        Bytes plaintext2 = Bytes.join(Cbor.identifier(identifier), proof.encode());
        message2 = Cbor.bytes(Bytes.join(ephemeral.x(), second.crypt(plaintext2)));
        third = second.third(prk3e2m, plaintext2, own);
    }

    /** G_X. */
    private static ECPublicKey read(Bytes message1) throws HandshakeException {
        CborReader message = new CborReader(message1);
        int method = message.integer();
        if (method != KeySchedule.METHOD) {
            throw CborReader.refused("its method is " + method + ", not " + KeySchedule.METHOD);
        }
        readSuites(message);
        ECPublicKey gX = P256.withX(message.bytes(P256.COORDINATE_LENGTH));
        message.identifier();
        message.externalData();
        return gX;
    }

    /** The last one is chosen, and those before it, of which this side must know none, would be preferred. */
    private static void readSuites(CborReader message) throws HandshakeException {
        boolean several = message.isArray();
        int count = several ? message.array() : 1;
        if (several && count < 2) {
            throw CborReader.refused("an array has a single suite");
        }
        for (int i = 1; i <= count; i++) {
            if (message.integer() == KeySchedule.SUITE != (i == count)) {
                throw CborReader.refused("its suite is not " + KeySchedule.SUITE);
            }
        }
    }

    /** 88 bytes, where the own certificate has 42. */
    @Override
    public Bytes opening() {
        return message2;
    }

    @Override
    public Agreed take(Bytes message3) throws HandshakeException {
        CborReader message = new CborReader(message3);
        Bytes ciphertext3 = message.bytes();
        message.end();
        Bytes plaintext3 = third.open(ciphertext3);
        Proof proof = Proof.read(new CborReader(plaintext3));
        Credential initiator = self.find(proof.kid());
        Bytes prk4e3m = third.prk4e3m(P256.agree(ephemeral.secret(), initiator.key()));
        proof.verify(third.mac(prk4e3m, initiator, proof.externalData()));
        self.admit(initiator);
        return new Agreed(Bytes.EMPTY, third.secret(prk4e3m, plaintext3, initiator), Optional.of(initiator));
    }
}
