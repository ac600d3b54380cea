package javino.protocol;

import java.security.GeneralSecurityException;
import javax.crypto.Cipher;
import javax.crypto.spec.IvParameterSpec;
import javax.crypto.spec.SecretKeySpec;

/** The uses of AES-128 that SPEC 5 makes, on the JDK's cipher. */
final class Aes {

    private static final int BLOCK = 16;
    /** What a doubling reduces by: NIST SP 800-38B section 5.3, R128. */
    private static final int R128 = 0x87;

    private Aes() {
    }

    /** One block enciphered. */
    static Bytes encrypt(Bytes key, Bytes block) {
        return Bytes.copyOf(run("AES/ECB/NoPadding", Cipher.ENCRYPT_MODE, key, null, block));
    }

    /** CFB128, NIST SP 800-38A section 6.3; the last block may be short. */
    static Bytes cfbEncrypt(Bytes key, Bytes iv, Bytes plain) {
        return cfb(Cipher.ENCRYPT_MODE, key, iv, plain);
    }

    /** The reverse of {@link #cfbEncrypt}. */
    static Bytes cfbDecrypt(Bytes key, Bytes iv, Bytes cipher) {
        return cfb(Cipher.DECRYPT_MODE, key, iv, cipher);
    }

    /** AES-CMAC, NIST SP 800-38B section 6.2: all 16 bytes of the tag. */
    static Bytes cmac(Bytes key, Bytes message) {
        Bytes subkey = twice(encrypt(key, Bytes.copyOf(new byte[BLOCK])));
        int lastStart = Math.max(0, (message.length() - 1) / BLOCK * BLOCK);
        byte[] last = new byte[BLOCK];
        Bytes rest = message.from(lastStart);
        System.arraycopy(rest.toArray(), 0, last, 0, rest.length());
        if (rest.length() < BLOCK) {
            last[rest.length()] = (byte) 0x80;
            subkey = twice(subkey);
        }
        byte[] chain = new byte[BLOCK];
        for (int at = 0; at < lastStart; at += BLOCK) {
            chain = encrypt(key, xor(chain, message.slice(at, at + BLOCK).toArray())).toArray();
        }
        return encrypt(key, xor(chain, xor(last, subkey.toArray()).toArray()));
    }

    private static Bytes cfb(int mode, Bytes key, Bytes iv, Bytes input) {
        return Bytes.copyOf(run("AES/CFB/NoPadding", mode, key, new IvParameterSpec(iv.toArray()), input));
    }

    private static Bytes twice(Bytes block) {
        byte[] doubled = new byte[BLOCK];
        for (int i = 0; i < BLOCK; i++) {
            int carry = i + 1 < BLOCK ? block.at(i + 1) >> 7 : 0;
            doubled[i] = (byte) (block.at(i) << 1 | carry);
        }
        doubled[BLOCK - 1] ^= (byte) (block.at(0) >> 7 == 0 ? 0 : R128);
        return Bytes.copyOf(doubled);
    }

    private static Bytes xor(byte[] a, byte[] b) {
        byte[] both = new byte[BLOCK];
        for (int i = 0; i < BLOCK; i++) {
            both[i] = (byte) (a[i] ^ b[i]);
        }
        return Bytes.copyOf(both);
    }

    private static byte[] run(String transformation, int mode, Bytes key, IvParameterSpec iv, Bytes input) {
        try {
            Cipher cipher = Cipher.getInstance(transformation);
            cipher.init(mode, new SecretKeySpec(key.toArray(), "AES"), iv);
            return cipher.doFinal(input.toArray());
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every JDK has " + transformation, e);
        }
    }
}
