package javino.vectors;

import static javino.vectors.Wire.bytes;
import static javino.vectors.Wire.join;
import static javino.vectors.Wire.text;

import java.math.BigInteger;
import java.security.GeneralSecurityException;
import java.util.Arrays;
import javax.crypto.Cipher;
import javax.crypto.spec.SecretKeySpec;

/**
 * The modes of SPEC 5 by the letter of the standards, on nothing but the JDK's AES on single blocks. For whoever checks
 * boards too: it shares nothing with library and firmware.
 */
public final class Crypto {

    private static final int BLOCK = 16;

    private Crypto() {
    }

    /** Encrypts one block. */
    public static byte[] aes(byte[] key, byte[] block) {
        try {
            Cipher cipher = Cipher.getInstance("AES/ECB/NoPadding");
            cipher.init(Cipher.ENCRYPT_MODE, new SecretKeySpec(key, "AES"));
            return cipher.doFinal(block);
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException(e);
        }
    }

    /** NIST SP 800-38A section 6.3, s = 128, with a short last segment. */
    public static byte[] cfb(byte[] key, byte[] iv, byte[] plain) {
        byte[] cipher = new byte[plain.length];
        byte[] input = iv;
        for (int at = 0; at < plain.length; at += BLOCK) {
            byte[] pad = aes(key, input);
            for (int i = at; i < Math.min(at + BLOCK, plain.length); i++) {
                cipher[i] = (byte) (plain[i] ^ pad[i - at]);
            }
            input = Arrays.copyOfRange(cipher, at, at + BLOCK);
        }
        return cipher;
    }

    /** NIST SP 800-38B section 6.2, on numbers of 128 bits. */
    public static byte[] cmac(byte[] key, byte[] message) {
        BigInteger k1 = twice(number(aes(key, new byte[BLOCK])));
        int blocks = Math.max(1, (message.length + BLOCK - 1) / BLOCK);
        boolean whole = message.length == blocks * BLOCK;
        byte[] padded = Arrays.copyOf(message, blocks * BLOCK);
        if (!whole) {
            padded[message.length] = (byte) 0x80;
        }
        BigInteger chain = BigInteger.ZERO;
        for (int block = 0; block < blocks; block++) {
            BigInteger next = number(Arrays.copyOfRange(padded, block * BLOCK, (block + 1) * BLOCK));
            if (block == blocks - 1) {
                next = next.xor(whole ? k1 : twice(k1));
            }
            chain = number(aes(key, block(chain.xor(next))));
        }
        return block(chain);
    }

    /** SPEC 5.2. */
    public static byte[] kdf(byte[] key, String label) {
        return cmac(key, join(bytes(1), text(label), bytes(0), bytes(0, 0x80)));
    }

    private static BigInteger twice(BigInteger value) {
        BigInteger doubled = value.shiftLeft(1);
        return doubled.testBit(128) ? doubled.clearBit(128).xor(BigInteger.valueOf(0x87)) : doubled;
    }

    private static BigInteger number(byte[] block) {
        return new BigInteger(1, block);
    }

    private static byte[] block(BigInteger value) {
        byte[] bytes = new byte[BLOCK];
        byte[] digits = value.toByteArray();
        int used = Math.min(BLOCK, digits.length);
        System.arraycopy(digits, digits.length - used, bytes, BLOCK - used, used);
        return bytes;
    }
}
