package keyagreement.edhoc;

import javino.protocol.Bytes;

/** Writes the few items of CBOR (RFC 8949) that EDHOC needs, in their only deterministic form (its section 4.2.1). */
public final class Cbor {

    static final int UNSIGNED = 0;
    static final int NEGATIVE = 1;
    static final int BYTES = 2;
    static final int TEXT = 3;
    static final int ARRAY = 4;
    static final int MAP = 5;

    private static final int ONE_BYTE = 24;

    private Cbor() {
    }

    /** A number. */
    public static Bytes integer(int number) {
        return number < 0 ? head(NEGATIVE, -1 - number) : head(UNSIGNED, number);
    }

    /** A byte string. */
    public static Bytes bytes(Bytes content) {
        return Bytes.join(head(BYTES, content.length()), content);
    }

    /** A text string. */
    public static Bytes text(String content) {
        Bytes encoded = Bytes.ofText(content);
        return Bytes.join(head(TEXT, encoded.length()), encoded);
    }

    /** @param items encoded. */
    public static Bytes array(Bytes... items) {
        return Bytes.join(head(ARRAY, items.length), Bytes.join(items));
    }

    /** @param items encoded: a key, its value, and so on, in the order of their encoded keys. */
    public static Bytes map(Bytes... items) {
        return Bytes.join(head(MAP, items.length / 2), Bytes.join(items));
    }

    /**
     * An identifier as the messages carry it (RFC 9528 section 3.3.2): as a number, if it is the one byte that encodes
     * the number -24…23, else as a byte string.
     */
    static Bytes identifier(Bytes identifier) {
        return isNumber(identifier) ? identifier : bytes(identifier);
    }

    static boolean isNumber(Bytes identifier) {
        return identifier.length() == 1 && identifier.at(0) >> 5 <= NEGATIVE && (identifier.at(0) & 0x1F) < ONE_BYTE;
    }

    private static Bytes head(int major, int argument) {
        if (argument < ONE_BYTE) {
            return Bytes.of(major << 5 | argument);
        }
        int length = argument <= 0xFF ? 1 : argument <= 0xFFFF ? 2 : 4;
        return Bytes.join(Bytes.of(major << 5 | ONE_BYTE + Integer.numberOfTrailingZeros(length)),
                Bytes.ofNumber(argument, length));
    }
}
