package uppaal.conformance;

import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Payload;
import javino.vectors.Crypto;

/** A key that devices share, as two that come from it: what they seal and prove with it (SPEC 5 and 7.3). */
record SharedKey(Bytes encryption, Bytes authentication) {
    /** The bit of a proof's type that is set where its maker asks for parity. */
    static final int ASKS_PARITY = 0x10;

    /** @param key 16 bytes */
    static SharedKey of(Bytes key) {
        return new SharedKey(Bytes.copyOf(Crypto.kdf(key.toArray(), "JavinoEnc")),
                Bytes.copyOf(Crypto.kdf(key.toArray(), "JavinoMac")));
    }

    /** The frame with this content as it crosses the air; its header and its nonce are given. */
    Bytes seal(Bytes head, Bytes content) {
        Bytes destination = head.slice(0, Address.LENGTH);
        Bytes origin = head.slice(Address.LENGTH, 2 * Address.LENGTH);
        Bytes block = Bytes.join(origin, destination, head.from(Frame.HEADER), Bytes.of(0, 0));
        byte[] iv = Crypto.aes(encryption.toArray(), block.toArray());
        byte[] sealed = Crypto.cfb(encryption.toArray(), iv, content.toArray());
        Bytes signed = Bytes.join(head, Bytes.copyOf(sealed));
        return Bytes.join(signed, tag(signed));
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
