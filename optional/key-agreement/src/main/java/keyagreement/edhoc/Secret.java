package keyagreement.edhoc;

import javino.protocol.Bytes;

/** Two sides' secret after a handshake: PRK_out (RFC 9528 section 4.1.3). Its {@code toString} does not show it. */
public final class Secret {

    private static final int EXPORTER = 10;
    private static final int KEY_UPDATE = 11;

    private final Bytes prkOut;
    private final Bytes prkExporter;

    /** @param prkOut 32 bytes. */
    Secret(Bytes prkOut) {
        this.prkOut = prkOut;
        prkExporter = Kdf.derive(prkOut, EXPORTER, Bytes.EMPTY, Kdf.HASH_LENGTH);
    }

    /**
     * EDHOC_Exporter (RFC 9528 section 4.2.1).
     *
     * @param label  32768…65535 for private use.
     * @param length the number of bytes, up to 8160.
     */
    public Bytes export(int label, Bytes context, int length) {
        return Kdf.derive(prkExporter, label, context, length);
    }

    /** EDHOC_KeyUpdate (RFC 9528 appendix H): a secret from which this one cannot be found. */
    public Secret updated(Bytes context) {
        return new Secret(Kdf.derive(prkOut, KEY_UPDATE, context, Kdf.HASH_LENGTH));
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Secret secret && prkOut.isSame(secret.prkOut);
    }

    @Override
    public int hashCode() {
        return prkExporter.hashCode();
    }

    @Override
    public String toString() {
        return "secret of a handshake";
    }
}
