package uppaal.replay;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.util.Arrays;
import java.util.Optional;
import javax.crypto.Cipher;
import javax.crypto.spec.IvParameterSpec;
import javax.crypto.spec.SecretKeySpec;
import javino.protocol.Address;
import javino.protocol.Payload;
import javino.vectors.Crypto;

/** A key that devices share: what they seal and prove with it (SPEC 5 and 7.3). */
final class SharedKey {
    /** What a proof's type differs by where its maker asks for parity. */
    private static final int ASKS_PARITY = 0x10;

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

    /** The frame as it crosses the air. */
    byte[] seal(String destination, String origin, byte[] nonce, byte[] content) {
        byte[] header = header(destination, origin, Payload.NONCE_LENGTH + content.length + Payload.TAG_LENGTH);
        byte[] cipher = Crypto.cfb(encryption, iv(destination, origin, nonce), content);
        byte[] signed = join(header, nonce, cipher);
        return join(signed, Arrays.copyOf(Crypto.cmac(authentication, signed), Payload.TAG_LENGTH));
    }

    /** The content of a sealed frame; nothing where its tag is wrong. */
    Optional<byte[]> open(byte[] frame) {
        int end = frame.length - Payload.TAG_LENGTH;
        if (end < Frame.CONTENT) {
            return Optional.empty();
        }
        byte[] tag = Arrays.copyOf(Crypto.cmac(authentication, Arrays.copyOf(frame, end)), Payload.TAG_LENGTH);
        return Arrays.equals(tag, Arrays.copyOfRange(frame, end, frame.length)) ? Optional.of(decrypt(frame, end))
                : Optional.empty();
    }

    private byte[] decrypt(byte[] frame, int end) {
        String addresses = new String(frame, 0, 2 * Address.LENGTH, StandardCharsets.US_ASCII);
        byte[] nonce = Arrays.copyOfRange(frame, Frame.HEADER, Frame.CONTENT);
        byte[] iv = iv(addresses.substring(0, Address.LENGTH), addresses.substring(Address.LENGTH), nonce);
        try {
            Cipher cipher = Cipher.getInstance("AES/CFB/NoPadding");
            cipher.init(Cipher.DECRYPT_MODE, new SecretKeySpec(encryption, "AES"), new IvParameterSpec(iv));
            return cipher.doFinal(frame, Frame.CONTENT, end - Frame.CONTENT);
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every JDK has AES", e);
        }
    }

    private byte[] iv(String destination, String origin, byte[] nonce) {
        return Crypto.aes(encryption, join(ascii(origin + destination), nonce, new byte[2]));
    }

    /**
     * Whether an acknowledgement proves what it says.
     *
     * @param type the proof's, of an acknowledger that does not ask for parity
     * @param message of the acknowledgement; the proof is its end
     */
    boolean isProof(int type, byte[] nonce, String sender, String acknowledger, byte[] message) {
        return isExactly(type, nonce, sender, acknowledger, message)
                || asksParity(type, nonce, sender, acknowledger, message);
    }

    /** Whether it proves that, and asks for parity (SPEC 6.1). */
    boolean asksParity(int type, byte[] nonce, String sender, String acknowledger, byte[] message) {
        return isExactly(type | ASKS_PARITY, nonce, sender, acknowledger, message);
    }

    private boolean isExactly(int type, byte[] nonce, String sender, String acknowledger, byte[] message) {
        int end = message.length - Payload.TAG_LENGTH;
        byte[] claim = join(nonce, ascii(sender + acknowledger), Arrays.copyOf(message, end));
        return Arrays.equals(Arrays.copyOfRange(message, end, message.length), proof(type, claim));
    }

    /** The proof of what is claimed: nonce, sender, acknowledger and what comes before the proof. */
    byte[] proof(int type, byte[] claim) {
        return Arrays.copyOf(Crypto.cmac(authentication, join(new byte[] {(byte) type}, claim)), Payload.TAG_LENGTH);
    }

    static byte[] join(byte[]... parts) {
        int length = Arrays.stream(parts).mapToInt(part -> part.length).sum();
        byte[] joined = new byte[length];
        int at = 0;
        for (byte[] part : parts) {
            System.arraycopy(part, 0, joined, at, part.length);
            at += part.length;
        }
        return joined;
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }
}
