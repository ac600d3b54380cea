package uppaal.conformance;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Payload;
import javino.vectors.Crypto;

/** A key that devices share: what they seal and prove with it (SPEC 5 and 7.3). */
final class SharedKey {
    /** What a proof's type differs by where its maker asks for parity. */
    static final int ASKS_PARITY = 0x10;
    private static final int BLOCK = 16;

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
        byte[] signed = join(header, nonce, Crypto.cfb(encryption, iv(origin + destination, nonce), content));
        return join(signed, tag(signed));
    }

    private byte[] tag(byte[] signed) {
        return Arrays.copyOf(Crypto.cmac(authentication, signed), Payload.TAG_LENGTH);
    }

    /** The content of a sealed frame; nothing where its tag is wrong. */
    Optional<Bytes> open(Bytes frame) {
        int end = frame.length() - Payload.TAG_LENGTH;
        if (end < Frame.CONTENT_AT || !frame.from(end).equals(Bytes.copyOf(tag(frame.slice(0, end).toArray())))) {
            return Optional.empty();
        }
        String addresses = new String(frame.toArray(), StandardCharsets.US_ASCII);
        byte[] before = iv(addresses.substring(Address.LENGTH, 2 * Address.LENGTH)
                + addresses.substring(0, Address.LENGTH), frame.slice(Frame.HEADER, Frame.CONTENT_AT).toArray());
        byte[] content = {};
        for (Bytes block : frame.slice(Frame.CONTENT_AT, end).split(BLOCK).toList()) {
            content = join(content, Crypto.cfb(encryption, before, block.toArray()));
            before = block.toArray();
        }
        return Optional.of(Bytes.copyOf(content));
    }

    /** @param addresses origin and destination */
    private byte[] iv(String addresses, byte[] nonce) {
        return Crypto.aes(encryption, join(ascii(addresses), nonce, new byte[2]));
    }

    /**
     * Whether an acknowledgement proves what it says.
     *
     * @param addresses of the sender and the acknowledger
     * @param message of the acknowledgement; the proof is its end
     */
    boolean isProof(int type, String nonce, String addresses, Bytes message) {
        int end = message.length() - Payload.TAG_LENGTH;
        byte[] claim = join(Bytes.ofHex(nonce).toArray(), ascii(addresses), message.slice(0, end).toArray());
        return message.from(end).equals(Bytes.copyOf(proof(type, claim)));
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
