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

    /** EDHOC_Extract. */
    static Bytes extract(Bytes salt, Bytes secret) {
        return hmac(salt, secret);
    }

    /** EDHOC_KDF. @param length the number of bytes to derive. */
    static Bytes derive(Bytes key, int label, Bytes context, int length) {
        Bytes info = Bytes.join(Cbor.integer(label), Cbor.bytes(context), Cbor.integer(length));
        ByteArrayOutputStream derived = new ByteArrayOutputStream();
        Bytes last = Bytes.EMPTY;
        for (int i = 1; derived.size() < length; i++) {
            last = hmac(key, Bytes.join(last, info, Bytes.of(i)));
            derived.writeBytes(last.toArray());
        }
        return Bytes.copyOf(derived.toByteArray()).slice(0, length);
    }

    private static Bytes hmac(Bytes key, Bytes text) {
        try {
            Mac mac = Mac.getInstance("HmacSHA256");
            mac.init(new SecretKeySpec(key.toArray(), "HmacSHA256"));
            return Bytes.copyOf(mac.doFinal(text.toArray()));
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every JDK has HMAC with SHA-256", e);
        }
    }
}
