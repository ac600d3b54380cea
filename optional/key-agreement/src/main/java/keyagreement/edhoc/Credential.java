package keyagreement.edhoc;

import java.security.interfaces.ECPublicKey;
import javino.protocol.Bytes;

/**
 * An identity, in EDHOC's terms.
 *
 * @param kid     the part that the messages carry, ID_CRED (RFC 9528 section 3.5.3).
 * @param encoded CRED, a CWT claims set in CBOR (RFC 9528 section 3.5.2); never sent, but both sides must have the
 *                same.
 * @param key     the static Diffie-Hellman key, on P-256.
 */
public record Credential(Bytes kid, Bytes encoded, ECPublicKey key) {
}
