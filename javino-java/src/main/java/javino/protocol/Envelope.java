package javino.protocol;

import java.security.MessageDigest;

/** The secure envelope of unicast and multicast: {@code nonce(6) ‖ ciphertext ‖ tag(8)} (SPEC 5). */
public final class Envelope {

    /** The bytes of a tag. */
    public static final int TAG_LENGTH = 8;
    /** The bytes that sealing adds to a content. */
    public static final int OVERHEAD = Nonce.LENGTH + TAG_LENGTH;

    private Envelope() {
    }

    /**
     * What a sealed frame held.
     *
     * @param nonce   6 bytes; whether it is new is for the caller to judge.
     * @param content the plain content.
     */
    public record Opened(Bytes nonce, Bytes content) {
    }

    /**
     * Seals a content.
     *
     * @param key     shared with the destination.
     * @param nonce   never used before by this origin.
     * @param content at most 494 bytes.
     * @return the frame as it goes on the air.
     */
    public static Frame seal(Key key, Address origin, Address destination, Nonce nonce, Bytes content) {
        Bytes number = nonce.toBytes();
        Bytes cipher = Aes.cfbEncrypt(key.encryption(), iv(key, origin, destination, number), content);
        Bytes header = Frame.header(destination, origin, content.length() + OVERHEAD);
        Bytes signed = Bytes.join(number, cipher);
        return new Frame(destination, origin, Bytes.join(signed, tag(key, header, signed)));
    }

    /**
     * Opens a sealed frame.
     *
     * @throws ProtocolException BAD_TAG if the frame is too short or was not sealed so with this key.
     */
    public static Opened open(Key key, Frame frame) throws ProtocolException {
        Bytes message = frame.message();
        if (message.length() < OVERHEAD) {
            throw new ProtocolException(ProtocolError.BAD_TAG,
                    "a sealed message has at least 14 bytes, not " + message.length());
        }
        int tagAt = message.length() - TAG_LENGTH;
        Bytes signed = message.slice(0, tagAt);
        Bytes expected = tag(key, frame.header(), signed);
        if (!MessageDigest.isEqual(expected.toArray(), message.from(tagAt).toArray())) {
            throw new ProtocolException(ProtocolError.BAD_TAG,
                    "frame from " + frame.origin() + " to " + frame.destination() + " was changed, or has another key");
        }
        Bytes nonce = signed.slice(0, Nonce.LENGTH);
        Bytes iv = iv(key, frame.origin(), frame.destination(), nonce);
        return new Opened(nonce, Aes.cfbDecrypt(key.encryption(), iv, signed.from(Nonce.LENGTH)));
    }

    /** NIST SP 800-38A appendix C: the enciphered nonce is an unpredictable IV. */
    private static Bytes iv(Key key, Address origin, Address destination, Bytes nonce) {
        return Aes.encrypt(key.encryption(),
                Bytes.join(origin.toBytes(), destination.toBytes(), nonce, Bytes.of(0, 0)));
    }

    private static Bytes tag(Key key, Bytes header, Bytes signed) {
        return Aes.cmac(key.authentication(), Bytes.join(header, signed)).slice(0, TAG_LENGTH);
    }
}
