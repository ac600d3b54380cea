package javino.protocol;

/** CRC-16/X-25: polynomial 0x1021, reflected, initial value 0xFFFF, complemented (SPEC 4.1). */
public final class Crc16 {

    private static final int REFLECTED_POLYNOMIAL = 0x8408;

    private Crc16() {
    }

    /** The checksum, 0…0xFFFF. */
    public static int of(Bytes bytes) {
        int crc = 0xFFFF;
        for (int i = 0; i < bytes.length(); i++) {
            crc ^= bytes.at(i);
            for (int bit = 0; bit < 8; bit++) {
                crc = (crc & 1) == 0 ? crc >> 1 : crc >> 1 ^ REFLECTED_POLYNOMIAL;
            }
        }
        return crc ^ 0xFFFF;
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
        Bytes found = closed.from(closed.length() - 2);
        Bytes expected = bytesOf(body);
        if (!found.equals(expected)) {
            throw new ProtocolException(ProtocolError.BAD_CRC,
                    "checksum " + found.hex() + ", but the bytes make " + expected.hex() + ": " + closed.hex());
        }
        return body;
    }
}
