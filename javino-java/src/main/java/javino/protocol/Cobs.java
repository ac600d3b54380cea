package javino.protocol;

import java.io.ByteArrayOutputStream;

/** Consistent overhead byte stuffing (Cheshire and Baker, 1999): bytes without any zero; without the closing one. */
final class Cobs {

    /** A code byte of a full block: 254 bytes of data and no zero after them. */
    static final int FULL_BLOCK = 0xFF;

    private Cobs() {
    }

    /** The shortest encoding: bytes that end in a full block get no empty one after it. */
    static Bytes encode(Bytes plain) {
        ByteArrayOutputStream encoded = new ByteArrayOutputStream(plain.length() + 4);
        int from = 0;
        boolean open = true;
        while (open) {
            int to = endOfBlock(plain, from);
            encoded.write(to - from + 1);
            encoded.writeBytes(plain.slice(from, to).toArray());
            boolean full = to - from == FULL_BLOCK - 1;
            // A zero after the block is swallowed by its code byte; without one the bytes are at their end.
            open = to < plain.length();
            from = full ? to : to + 1;
        }
        return Bytes.copyOf(encoded.toByteArray());
    }

    private static int endOfBlock(Bytes plain, int from) {
        int to = from;
        while (to < plain.length() && to - from < FULL_BLOCK - 1 && plain.at(to) != 0) {
            to++;
        }
        return to;
    }
}
