package uppaal.conformance;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.util.Arrays;
import java.util.Optional;
import javax.crypto.Cipher;
import javax.crypto.spec.IvParameterSpec;
import javax.crypto.spec.SecretKeySpec;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Payload;
import javino.vectors.Crypto;

/** A key that devices share: what they seal and prove with it (SPEC 5 and 7.3). */
final class SharedKey {
    /** What a proof's type differs by where its maker asks for parity. */
    static final int ASKS_PARITY = 0x10;

    private final byte[] encryption;
    private final byte[] authentication;

    /** @param key 16 bytes */
    SharedKey(byte[] key) {
        encryption = Crypto.kdf(key, "JavinoEnc");
        authentication = Crypto.kdf(key, "JavinoMac");
    }

    /** The header of a frame whose message has so many bytes. */
    static byte[] header(String destination, String origin, int length) {
        return javino.protocol.Frame.header(Address.parse(destination), Address.parse(origin), length).toArray();
    }

    /** What a frame is with this content, as it crosses the air. */
    Bytes seal(Frame frame, Bytes content) {
        return Bytes.copyOf(seal(frame.destination, frame.origin, Bytes.ofHex(frame.nonce).toArray(),
                content.toArray()));
    }

    byte[] seal(String destination, String origin, byte[] nonce, byte[] content) {
        byte[] header = header(destination, origin, Payload.NONCE_LENGTH + content.length + Payload.TAG_LENGTH);
        byte[] signed = join(header, nonce, Crypto.cfb(encryption, iv(destination + origin, nonce), content));
        return join(signed, tag(signed));
    }

    private byte[] tag(byte[] signed) {
        return Arrays.copyOf(Crypto.cmac(authentication, signed), Payload.TAG_LENGTH);
    }

    /** The content of a sealed frame; nothing where its tag is wrong. */
    Optional<byte[]> open(byte[] frame) {
        int end = frame.length - Payload.TAG_LENGTH;
        if (end < Frame.CONTENT_AT
                || !Arrays.equals(tag(Arrays.copyOf(frame, end)), Arrays.copyOfRange(frame, end, frame.length))) {
            return Optional.empty();
        }
        String addresses = new String(frame, 0, 2 * Address.LENGTH, StandardCharsets.US_ASCII);
        byte[] iv = iv(addresses, Arrays.copyOfRange(frame, Frame.HEADER, Frame.CONTENT_AT));
        try {
            Cipher cipher = Cipher.getInstance("AES/CFB/NoPadding");
            cipher.init(Cipher.DECRYPT_MODE, new SecretKeySpec(encryption, "AES"), new IvParameterSpec(iv));
            return Optional.of(cipher.doFinal(frame, Frame.CONTENT_AT, end - Frame.CONTENT_AT));
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every JDK has AES", e);
        }
    }

    /** @param addresses destination and origin */
    private byte[] iv(String addresses, byte[] nonce) {
        String turned = addresses.substring(Address.LENGTH) + addresses.substring(0, Address.LENGTH);
        return Crypto.aes(encryption, join(ascii(turned), nonce, new byte[2]));
    }

    /**
     * Whether an acknowledgement proves what it says.
     *
     * @param addresses of the sender and the acknowledger
     * @param message of the acknowledgement; the proof is its end
     */
    boolean isProof(int type, byte[] nonce, String addresses, byte[] message) {
        int end = message.length - Payload.TAG_LENGTH;
        byte[] right = proof(type, join(nonce, ascii(addresses), Arrays.copyOf(message, end)));
        return Arrays.equals(Arrays.copyOfRange(message, end, message.length), right);
    }

    /** The proof of what is claimed: nonce, sender, acknowledger and what comes before the proof. */
    byte[] proof(int type, byte[] claim) {
        return tag(join(new byte[] {(byte) type}, claim));
    }

    static byte[] join(byte[]... parts) {
        return Bytes.join(Arrays.stream(parts).map(Bytes::copyOf).toArray(Bytes[]::new)).toArray();
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }
}
