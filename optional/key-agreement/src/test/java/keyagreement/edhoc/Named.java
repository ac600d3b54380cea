package keyagreement.edhoc;

import java.math.BigInteger;
import java.security.interfaces.ECPrivateKey;
import java.util.Map;
import javino.protocol.Bytes;

/** A party that knows others by name. */
record Named(Credential own, ECPrivateKey secret, Map<Bytes, Credential> others) implements Party {

    /** @param cred as in {@link Credential}; the key pair is this number's. */
    static Named of(Bytes kid, Bytes cred, String number) throws HandshakeException {
        ECPrivateKey secret = P256.secret(new BigInteger(number, 16));
        return new Named(new Credential(kid, cred, P256.withX(P256.publicX(secret))), secret, Map.of());
    }

    Named knowing(Named other) {
        return new Named(own, secret, Map.of(other.own.kid(), other.own));
    }

    @Override
    public Credential find(Bytes kid) throws HandshakeException {
        if (!others.containsKey(kid)) {
            throw new HandshakeException("nobody has the name " + kid);
        }
        return others.get(kid);
    }

    @Override
    public void admit(Credential proved) {
        // Whoever is known.
    }
}
