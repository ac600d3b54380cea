package keyagreement.edhoc;

import javino.protocol.Bytes;

/** Computations of both sides of EDHOC, by method 3 and suite 2; the names are those of RFC 9528 sections 4 and 5. */
final class KeySchedule {

    static final int METHOD = 3;
    static final int SUITE = 2;
    static final int MAC_LENGTH = 8;

    private static final int KEY_LENGTH = 16;
    private static final int NONCE_LENGTH = 13;

    private KeySchedule() {
    }

    /** How one side shows who it is: what a plaintext has after C_R. */
    record Proof(Bytes kid, Bytes mac, Bytes externalData) {

        static Proof read(CborReader from) throws HandshakeException {
            return new Proof(from.identifier(), from.bytes(MAC_LENGTH), from.externalData());
        }

        Bytes encode() {
            return Bytes.join(Cbor.identifier(kid), Cbor.bytes(mac), externalData);
        }

        /** @throws HandshakeException if the MAC is another. */
        void verify(Bytes expected) throws HandshakeException {
            if (!mac.isSame(expected)) {
                throw CborReader.refused("its sender has not the key of its certificate, or it is damaged");
            }
        }
    }

    /**
     * After message 1.
     *
     * @param th2   TH_2.
     * @param prk2e PRK_2e.
     */
    record Second(Bytes th2, Bytes prk2e) {

        static Second of(Bytes message1, Bytes gY, Bytes gXY) {
            Bytes th2 = Kdf.hash(Cbor.bytes(gY), Cbor.bytes(Kdf.hash(message1)));
            return new Second(th2, Kdf.extract(th2, gXY));
        }

        /** Encrypts or decrypts PLAINTEXT_2. */
        Bytes crypt(Bytes text) {
            Bytes stream = Kdf.derive(prk2e, 0, th2, text.length());
            byte[] crypted = new byte[text.length()];
            for (int i = 0; i < crypted.length; i++) {
                crypted[i] = (byte) (text.at(i) ^ stream.at(i));
            }
            return Bytes.copyOf(crypted);
        }

        /** PRK_3e2m. */
        Bytes prk3e2m(Bytes gRX) {
            return Kdf.extract(Kdf.derive(prk2e, 1, th2, Kdf.HASH_LENGTH), gRX);
        }

        /** MAC_2. */
        Bytes mac(Bytes prk3e2m, Bytes cR, Credential responder, Bytes externalData) {
            return Kdf.derive(prk3e2m, 2,
                    Bytes.join(Cbor.identifier(cR), idCred(responder), Cbor.bytes(th2), responder.encoded(),
                            externalData),
                    MAC_LENGTH);
        }

        Third third(Bytes prk3e2m, Bytes plaintext2, Credential responder) {
            return new Third(Kdf.hash(Cbor.bytes(th2), plaintext2, responder.encoded()), prk3e2m);
        }
    }

    /**
     * After message 2.
     *
     * @param th3     TH_3.
     * @param prk3e2m PRK_3e2m.
     */
    record Third(Bytes th3, Bytes prk3e2m) {

        /** PRK_4e3m. */
        Bytes prk4e3m(Bytes gIY) {
            return Kdf.extract(Kdf.derive(prk3e2m, 5, th3, Kdf.HASH_LENGTH), gIY);
        }

        /** MAC_3. */
        Bytes mac(Bytes prk4e3m, Credential initiator, Bytes externalData) {
            return Kdf.derive(prk4e3m, 6,
                    Bytes.join(idCred(initiator), Cbor.bytes(th3), initiator.encoded(), externalData), MAC_LENGTH);
        }

        /** CIPHERTEXT_3. */
        Bytes seal(Bytes plaintext3) {
            return cipher().seal(plaintext3, associated());
        }

        /** PLAINTEXT_3. */
        Bytes open(Bytes ciphertext3) throws HandshakeException {
            return cipher().open(ciphertext3, associated()).orElseThrow(
                    () -> CborReader.refused("it is damaged, or of another handshake"));
        }

        private Ccm cipher() {
            return new Ccm(Kdf.derive(prk3e2m, 3, th3, KEY_LENGTH), Kdf.derive(prk3e2m, 4, th3, NONCE_LENGTH),
                    MAC_LENGTH);
        }

        private Bytes associated() {
            return Cbor.array(Cbor.text("Encrypt0"), Cbor.bytes(Bytes.EMPTY), Cbor.bytes(th3));
        }

        Secret secret(Bytes prk4e3m, Bytes plaintext3, Credential initiator) {
            Bytes th4 = Kdf.hash(Cbor.bytes(th3), plaintext3, initiator.encoded());
            return new Secret(Kdf.derive(prk4e3m, 7, th4, Kdf.HASH_LENGTH));
        }
    }

    /** ID_CRED: a map with the kid alone. */
    private static Bytes idCred(Credential of) {
        return Cbor.map(Cbor.integer(4), Cbor.bytes(of.kid()));
    }
}
