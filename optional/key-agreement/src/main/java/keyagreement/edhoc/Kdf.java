package keyagreement.edhoc;

import java.io.ByteArrayOutputStream;
import java.security.GeneralSecurityException;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;
import javino.protocol.Bytes;

/** SHA-256, and what EDHOC derives keys with (RFC 9528 section 4.1, RFC 5869). */
public final class Kdf {

    /** The number of bytes of a hash, and of each pseudorandom key. */
    public static final int HASH_LENGTH = 32;

    private Kdf() {
    }

    /** SHA-256 of all parts, one after the other. */
    public static Bytes hash(Bytes... parts) {
        return Bytes.join(parts).sha256();
    }

    /** EDHOC_Extract. @param salt one without a byte is {@link #HASH_LENGTH} zeros (RFC 5869 section 2.2). */
    static Bytes extract(Bytes salt, Bytes secret) {
        return hmac(salt.length() == 0 ? Bytes.copyOf(new byte[HASH_LENGTH]) : salt, secret);
    }

    /** EDHOC_KDF. @param length the number of bytes to derive. */
    static Bytes derive(Bytes key, int label, Bytes context, int length) {
        return expand(key, Bytes.join(Cbor.integer(label), Cbor.bytes(context), Cbor.integer(length)), length);
    }

    /**
     * HKDF-Expand (RFC 5869 section 2.3).
     *
     * @throws IllegalArgumentException if more than 255 hashes are needed.
     */
    static Bytes expand(Bytes key, Bytes info, int length) {
        if (length > 255 * HASH_LENGTH) {
            throw new IllegalArgumentException("HKDF derives no " + length + " bytes");
        }
        ByteArrayOutputStream derived = new ByteArrayOutputStream();
        Bytes last = Bytes.EMPTY;
        for (int i = 1; derived.size() < length; i++) {
            last = hmac(key, Bytes.join(last, info, Bytes.of(i)));
            derived.writeBytes(last.toArray());
        }
        return Bytes.copyOf(derived.toByteArray()).slice(0, length);
    }

    /** HMAC with SHA-256 (RFC 2104): 32 bytes. @param key at least a byte. */
    static Bytes hmac(Bytes key, Bytes text) {
        try {
            Mac mac = Mac.getInstance("HmacSHA256");
            mac.init(new SecretKeySpec(key.toArray(), "HmacSHA256"));
            return Bytes.copyOf(mac.doFinal(text.toArray()));
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every JDK has HMAC with SHA-256", e);
        }
    }
}
