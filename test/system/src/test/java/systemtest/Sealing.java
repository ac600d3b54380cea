package systemtest;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.util.Arrays;
import javax.crypto.Cipher;
import javax.crypto.spec.SecretKeySpec;

/** The part of SPEC section 5 that leads to an IV, from the JDK's AES alone. */
final class Sealing {

    private static final int BLOCK = 16;

    private Sealing() { }

    /** IV of a sealed frame as it was on the air: AES(Kenc, origin ‖ destination ‖ N ‖ 00 00). */
    static byte[] iv(byte[] key, byte[] frame) throws GeneralSecurityException {
        byte[] input = new byte[BLOCK];
        System.arraycopy(frame, 4, input, 0, 4);
        System.arraycopy(frame, 0, input, 4, 4);
        System.arraycopy(frame, 10, input, 8, 6);
        return aes(derive(key, "JavinoEnc"), input);
    }

    /** SP 800-108 with CMAC: one incomplete block, so that the whole CMAC is one AES with the second subkey. */
    private static byte[] derive(byte[] key, String label) throws GeneralSecurityException {
        byte[] block = new byte[BLOCK];
        block[0] = 1;
        System.arraycopy(label.getBytes(StandardCharsets.US_ASCII), 0, block, 1, 9);
        block[12] = (byte) 0x80;
        block[13] = (byte) 0x80;
        byte[] subkey = twice(twice(aes(key, new byte[BLOCK])));
        for (int i = 0; i < BLOCK; i++) {
            block[i] ^= subkey[i];
        }
        return aes(key, block);
    }

    private static byte[] twice(byte[] block) {
        byte[] doubled = Arrays.copyOf(block, BLOCK);
        for (int i = 0; i < BLOCK; i++) {
            int carry = i + 1 < BLOCK ? (block[i + 1] & 0xff) >> 7 : 0;
            doubled[i] = (byte) (block[i] << 1 | carry);
        }
        if (block[0] < 0) {
            doubled[BLOCK - 1] ^= (byte) 0x87;
        }
        return doubled;
    }

    private static byte[] aes(byte[] key, byte[] block) throws GeneralSecurityException {
        Cipher cipher = Cipher.getInstance("AES/ECB/NoPadding");
        cipher.init(Cipher.ENCRYPT_MODE, new SecretKeySpec(key, "AES"));
        return cipher.doFinal(block);
    }
}
