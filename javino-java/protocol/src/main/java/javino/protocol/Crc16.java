package javino.protocol;

/** CRC-16/X-25: polynomial 0x1021, reflected, initial value 0xFFFF, complemented (SPEC 4.1). */
public final class Crc16 {

    private static final int REFLECTED_POLYNOMIAL = 0x8408;
    /** The change by each value of the low byte: bit by bit it would be most of the time that a packet takes. */
    private static final char[] TABLE = table();

    private Crc16() {
    }

    /** The checksum, 0…0xFFFF. */
    public static int of(Bytes bytes) {
        int crc = 0xFFFF;
        for (int i = 0; i < bytes.length(); i++) {
            crc = crc >> 8 ^ TABLE[(crc ^ bytes.at(i)) & 0xFF];
        }
        return crc ^ 0xFFFF;
    }

    private static char[] table() {
        char[] table = new char[0x100];
        for (int value = 0; value < table.length; value++) {
            int crc = value;
            for (int bit = 0; bit < 8; bit++) {
                crc = (crc & 1) == 0 ? crc >> 1 : crc >> 1 ^ REFLECTED_POLYNOMIAL;
            }
            table[value] = (char) crc;
        }
        return table;
    }

    /** The checksum as it travels: two bytes, the low one first. */
    static Bytes bytesOf(Bytes bytes) {
        int crc = of(bytes);
        return Bytes.of(crc, crc >> 8);
    }

    /**
     * The bytes before the two of a checksum that closes them.
     *
     * @throws ProtocolException BAD_CRC if it is not theirs.
     */
    static Bytes strip(Bytes closed) throws ProtocolException {
        Bytes body = closed.slice(0, closed.length() - 2);
        int found = closed.at(body.length()) | closed.at(body.length() + 1) << 8;
        if (found != of(body)) {
            throw new ProtocolException(ProtocolError.BAD_CRC, "checksum " + closed.from(body.length()).hex()
                    + ", but the bytes make " + bytesOf(body).hex() + ": " + closed.hex());
        }
        return body;
    }
}
