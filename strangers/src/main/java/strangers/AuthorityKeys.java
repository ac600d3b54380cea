package strangers;

import javino.protocol.Bytes;

/** The public keys of an authority. */
public record AuthorityKeys(Bytes certificates, Bytes notices) {

    /** The first byte of SHA-256 of both. */
    public int id() {
        throw new UnsupportedOperationException();
    }
}
