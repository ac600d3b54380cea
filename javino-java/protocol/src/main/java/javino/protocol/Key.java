package javino.protocol;

import java.math.BigInteger;
import java.security.GeneralSecurityException;
import java.security.SecureRandom;
import javax.crypto.Cipher;
import javax.crypto.spec.SecretKeySpec;

/** A shared key of 16 bytes (SPEC 5). Its {@code toString} does not show it. */
public final class Key {

    /** The number of bytes. */
    public static final int LENGTH = 16;

    /** 01 ‖ "JavinoChk" ‖ 00 ‖ 0080 (NIST SP 800-108 section 4.1), with CMAC's padding of an incomplete block. */
    private static final BigInteger CHECKED = new BigInteger("014a6176696e6f43686b000080800000", 16);
    private static final BigInteger R128 = BigInteger.valueOf(0x87);

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
        return of(Bytes.random(source, LENGTH));
    }

    /** The secret itself. */
    public Bytes bytes() {
        return bytes;
    }

    /**
     * The check value, by which two sides see that they have the same key: 3 bytes (SPEC 5.2).
     * It is an AES-CMAC (NIST SP 800-38B section 6.2) of 13 bytes, which are one block.
     */
    public Bytes check() {
        BigInteger subkey = twice(twice(encrypt(BigInteger.ZERO)));
        return Bytes.ofHex(hex(encrypt(CHECKED.xor(subkey)))).slice(0, 3);
    }

    /** Multiplied by x in the field of NIST SP 800-38B section 5.3. */
    private static BigInteger twice(BigInteger block) {
        BigInteger doubled = block.shiftLeft(1);
        return doubled.testBit(8 * LENGTH) ? doubled.clearBit(8 * LENGTH).xor(R128) : doubled;
    }

    private BigInteger encrypt(BigInteger block) {
        try {
            Cipher cipher = Cipher.getInstance("AES/ECB/NoPadding");
            cipher.init(Cipher.ENCRYPT_MODE, new SecretKeySpec(bytes.toArray(), "AES"));
            return new BigInteger(1, cipher.doFinal(Bytes.ofHex(hex(block)).toArray()));
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every JDK has AES", e);
        }
    }

    private static String hex(BigInteger block) {
        return String.format("%032x", block);
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
