package keyagreement.edhoc;

import javino.protocol.Bytes;

/** Secrets that a test knows. */
public final class Secrets {

    private Secrets() {
    }

    /** @param prkOut PRK_out, 32 bytes. */
    public static Secret of(Bytes prkOut) {
        return new Secret(prkOut);
    }
}
