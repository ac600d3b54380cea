package javino.protocol;

import java.security.SecureRandom;

/** A shared key of 16 bytes (SPEC 5). Its {@code toString} does not show it. */
public final class Key {

    /** The number of bytes. */
    public static final int LENGTH = 16;

    private final Bytes bytes;

    private Key(Bytes bytes) {
        this.bytes = bytes;
    }

    /** @throws IllegalArgumentException if there are not 16 bytes. */
    public static Key of(Bytes bytes) {
        if (bytes.length() != LENGTH) {
            throw new IllegalArgumentException("a key has 16 bytes, not " + bytes.length());
        }
        return new Key(bytes);
    }

    /**
     * Reads 32 hexadecimal digits.
     *
     * @throws IllegalArgumentException if the text is anything else; the message does not repeat it.
     */
    public static Key ofHex(String hex) {
        if (!hex.matches("[0-9A-Fa-f]{32}")) {
            throw new IllegalArgumentException("a key is written as 32 hexadecimal digits");
        }
        return of(Bytes.ofHex(hex));
    }

    /** A new key. */
    public static Key random(SecureRandom source) {
        byte[] bytes = new byte[LENGTH];
        source.nextBytes(bytes);
        return of(Bytes.copyOf(bytes));
    }

    /** The secret itself. */
    public Bytes bytes() {
        return bytes;
    }

    /** Kenc, with which contents are enciphered (SPEC 5.2). */
    Bytes encryption() {
        return derive("JavinoEnc");
    }

    /** Kmac, with which frames are authenticated (SPEC 5.2). */
    Bytes authentication() {
        return derive("JavinoMac");
    }

    /** The check value, by which two sides see that they have the same key: 3 bytes (SPEC 5.2). */
    public Bytes check() {
        return derive("JavinoChk").slice(0, 3);
    }

    /** NIST SP 800-108 section 4.1, counter mode, r = 8, L = 128, empty context. */
    private Bytes derive(String label) {
        return Aes.cmac(bytes, Bytes.join(Bytes.of(1), Bytes.ofText(label), Bytes.of(0, 0, 0x80)));
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Key key && bytes.equals(key.bytes);
    }

    @Override
    public int hashCode() {
        return bytes.hashCode();
    }

    @Override
    public String toString() {
        return "key with check value " + check();
    }
}
