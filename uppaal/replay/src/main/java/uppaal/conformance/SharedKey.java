package uppaal.conformance;

import java.util.Optional;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Payload;
import javino.vectors.Crypto;

/** A key that devices share, as two that come from it: what they seal and prove with it (SPEC 5 and 7.3). */
record SharedKey(Bytes encryption, Bytes authentication) {
    /** What a proof's type differs by where its maker asks for parity. */
    static final int ASKS_PARITY = 0x10;
    private static final int BLOCK = 16;

    /** @param key 16 bytes */
    static SharedKey of(Bytes key) {
        return new SharedKey(Bytes.copyOf(Crypto.kdf(key.toArray(), "JavinoEnc")),
                Bytes.copyOf(Crypto.kdf(key.toArray(), "JavinoMac")));
    }

    /** What a frame is with this content, as it crosses the air; its header and its nonce are given. */
    Bytes seal(Bytes head, Bytes content) {
        Bytes signed = Bytes.join(head, encrypt(iv(head), content));
        return Bytes.join(signed, tag(signed));
    }

    /** The content of a sealed frame; nothing where its tag is wrong. */
    Optional<Bytes> open(Bytes frame) {
        int end = frame.length() - Payload.TAG_LENGTH;
        if (end < Frame.CONTENT_AT || !frame.from(end).equals(tag(frame.slice(0, end)))) {
            return Optional.empty();
        }
        Bytes content = Bytes.EMPTY;
        Bytes before = iv(frame);
        for (Bytes block : frame.slice(Frame.CONTENT_AT, end).split(BLOCK).toList()) {
            content = Bytes.join(content, encrypt(before, block)); // of one block it is its own inverse
            before = block;
        }
        return Optional.of(content);
    }

    private Bytes iv(Bytes frame) {
        Bytes destination = frame.slice(0, Address.LENGTH);
        Bytes origin = frame.slice(Address.LENGTH, 2 * Address.LENGTH);
        Bytes nonce = frame.slice(Frame.HEADER, Frame.CONTENT_AT);
        Bytes block = Bytes.join(origin, destination, nonce, Bytes.of(0, 0));
        return Bytes.copyOf(Crypto.aes(encryption.toArray(), block.toArray()));
    }

    private Bytes encrypt(Bytes iv, Bytes content) {
        return Bytes.copyOf(Crypto.cfb(encryption.toArray(), iv.toArray(), content.toArray()));
    }

    /**
     * The proof of an acknowledgement.
     *
     * @param addresses of the sender and the acknowledger
     * @param body what comes before the proof
     */
    Bytes proof(int type, Bytes nonce, String addresses, Bytes body) {
        return tag(Bytes.join(Bytes.of(type), nonce, Bytes.ofText(addresses), body));
    }

    private Bytes tag(Bytes signed) {
        return Bytes.copyOf(Crypto.cmac(authentication.toArray(), signed.toArray())).slice(0, Payload.TAG_LENGTH);
    }
}
