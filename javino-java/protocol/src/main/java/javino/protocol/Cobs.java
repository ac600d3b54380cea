package javino.protocol;

import java.util.Arrays;

/** Consistent overhead byte stuffing (Cheshire and Baker, 1999): no zero but the one that closes a packet. */
final class Cobs {

    /** A code byte of a full block: 254 bytes of data and no zero after them. */
    static final int FULL_BLOCK = 0xFF;

    private Cobs() {
    }

    /** The shortest encoding, with the closing zero: bytes that end in a full block get no empty one after it. */
    static Bytes encode(Bytes plain) {
        byte[] encoded = new byte[plain.length() + plain.length() / (FULL_BLOCK - 1) + 2];
        int code = 0;
        int end = 1;
        for (int i = 0; i < plain.length(); i++) {
            int value = plain.at(i);
            if (end - code == FULL_BLOCK) {
                encoded[code] = (byte) FULL_BLOCK;
                code = end++;
            }
            if (value == 0) {
                encoded[code] = (byte) (end - code);
                code = end++;
            } else {
                encoded[end++] = (byte) value;
            }
        }
        encoded[code] = (byte) (end - code);
        return Bytes.owning(end + 1 == encoded.length ? encoded : Arrays.copyOf(encoded, end + 1));
    }
}
