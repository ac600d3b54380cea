package keyagreement.edhoc;

import java.security.SecureRandom;
import java.security.interfaces.ECPublicKey;
import java.util.Optional;
import javino.protocol.Bytes;
import keyagreement.edhoc.KeySchedule.Proof;
import keyagreement.edhoc.KeySchedule.Second;
import keyagreement.edhoc.KeySchedule.Third;

/** The side that begins EDHOC. */
public final class Initiator implements Role {

    /** C_I. Nothing here needs connection identifiers, but RFC 9528 has them. */
    private static final Bytes IDENTIFIER = Bytes.of(0x00);

    private final Party self;
    private final P256.Pair ephemeral;
    private final Bytes message1;
    private Bytes taken;
    private Agreed agreed;

    /** Begins a run, with a new ephemeral key. */
    public Initiator(Party self, SecureRandom random) {
        this(self, P256.generate(random), Cbor.integer(KeySchedule.SUITE), IDENTIFIER);
    }

    /** @param suites encoded. */
    Initiator(Party self, P256.Pair ephemeral, Bytes suites, Bytes identifier) {
        this.self = self;
        this.ephemeral = ephemeral;
        message1 = Bytes.join(Cbor.integer(KeySchedule.METHOD), suites, Cbor.bytes(ephemeral.x()),
                Cbor.identifier(identifier));
    }

    /** 37 bytes. */
    @Override
    public Bytes opening() {
        return message1;
    }

    /** @param message2 88 bytes, where the other's certificate has 42. Message 3 has 63, where the own has 42. */
    @Override
    public Agreed take(Bytes message2) throws HandshakeException {
        // A second answer is never made: it would be sealed with the same key and nonce.
        if (taken == null) {
            agreed = verify(message2);
            taken = message2;
        } else if (!message2.equals(taken)) {
            throw CborReader.refused("another message 2 was taken");
        }
        return agreed;
    }

    private Agreed verify(Bytes received) throws HandshakeException {
        CborReader message = new CborReader(received);
        Bytes content = message.bytes();
        message.end();
        if (content.length() < P256.COORDINATE_LENGTH) {
            throw CborReader.refused("it is too short");
        }
        Bytes gY = content.slice(0, P256.COORDINATE_LENGTH);
        ECPublicKey theirs = P256.withX(gY);
        Second second = Second.of(message1, gY, P256.agree(ephemeral.secret(), theirs));
        Bytes plaintext2 = second.crypt(content.from(P256.COORDINATE_LENGTH));
        CborReader plaintext = new CborReader(plaintext2);
        Bytes cR = plaintext.identifier();
        Proof proof = Proof.read(plaintext);
        Credential responder = self.find(proof.kid());
        Bytes prk3e2m = second.prk3e2m(P256.agree(ephemeral.secret(), responder.key()));
        proof.verify(second.mac(prk3e2m, cR, responder, proof.externalData()));
        self.admit(responder);
        Third third = second.third(prk3e2m, plaintext2, responder);
        Credential own = self.own();
        Bytes prk4e3m = third.prk4e3m(P256.agree(self.secret(), theirs));
        Bytes plaintext3 = new Proof(own.kid(), third.mac(prk4e3m, own, Bytes.EMPTY), Bytes.EMPTY).encode();
        return new Agreed(Cbor.bytes(third.seal(plaintext3)), third.secret(prk4e3m, plaintext3, own),
                Optional.of(responder));
    }
}
