package keyagreement.edhoc;

import java.security.KeyPair;
import java.security.SecureRandom;
import java.security.interfaces.ECPrivateKey;
import java.security.interfaces.ECPublicKey;
import javino.protocol.Bytes;

/** A key pair for one run. @param x G_X or G_Y, 32 bytes. */
record Ephemeral(ECPrivateKey secret, Bytes x) {

    static Ephemeral random(SecureRandom random) {
        KeyPair pair = P256.generate(random);
        return new Ephemeral((ECPrivateKey) pair.getPrivate(), P256.x((ECPublicKey) pair.getPublic()));
    }

    @Override
    public String toString() {
        return "ephemeral key " + x;
    }
}
