package strangers.edhoc;

import javino.protocol.Bytes;

/** What two sides have after a handshake: PRK_out (RFC 9528 section 4.1.3). Its {@code toString} does not show it. */
public final class Secret {

    private final Bytes prkOut;

    /** @param prkOut 32 bytes. */
    Secret(Bytes prkOut) {
        this.prkOut = prkOut;
    }

    /**
     * EDHOC_Exporter (RFC 9528 section 4.2.1).
     *
     * @param label  32768…65535 for private use.
     * @param length the number of bytes, up to 8160.
     */
    public Bytes export(int label, Bytes context, int length) {
        throw new UnsupportedOperationException();
    }

    /** EDHOC_KeyUpdate (RFC 9528 appendix H): a secret from which this one cannot be found. */
    public Secret updated(Bytes context) {
        throw new UnsupportedOperationException();
    }
}
