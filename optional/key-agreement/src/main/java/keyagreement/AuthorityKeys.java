package keyagreement;

import javino.protocol.Bytes;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.Kdf;
import keyagreement.edhoc.P256;

/**
 * The public keys of an authority.
 *
 * @param certificates    the key of certificates, 33 bytes, compressed.
 * @param revocationLists the key of revocation lists, 33 bytes, compressed.
 */
public record AuthorityKeys(Bytes certificates, Bytes revocationLists) {

    private static final int LENGTH = 2 * P256.POINT_LENGTH;

    /** @throws HandshakeException if they are not two points. */
    static AuthorityKeys decode(Bytes bytes) throws HandshakeException {
        if (bytes.length() != LENGTH) {
            throw new HandshakeException("an authority's keys have " + LENGTH + " bytes");
        }
        AuthorityKeys keys = new AuthorityKeys(bytes.slice(0, P256.POINT_LENGTH), bytes.from(P256.POINT_LENGTH));
        P256.decompress(keys.certificates);
        P256.decompress(keys.revocationLists);
        return keys;
    }

    /** 66 bytes. */
    Bytes toBytes() {
        return Bytes.join(certificates, revocationLists);
    }

    /** The first byte of {@link #fingerprint}: what certificates and revocation lists call this authority. */
    public int id() {
        return fingerprint().at(0);
    }

    /** The 8 bytes by which people compare authorities. */
    public Bytes fingerprint() {
        return Kdf.hash(toBytes()).slice(0, 8);
    }
}
