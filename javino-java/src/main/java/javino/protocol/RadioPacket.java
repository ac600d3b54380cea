package javino.protocol;

/** The line code of the air, VirtualWire's (SPEC 6). Bits are text of {@code 0} and {@code 1}, the first sent first. */
public final class RadioPacket {

    /** The most bytes of payload. */
    public static final int MAX_PAYLOAD_LENGTH = 77;

    private static final int[] SYMBOLS = {
        0x0D, 0x0E, 0x13, 0x15, 0x16, 0x19, 0x1A, 0x1C, 0x23, 0x25, 0x26, 0x29, 0x2A, 0x2C, 0x32, 0x34
    };
    private static final int SYMBOL_BITS = 6;
    private static final int BYTE_BITS = 2 * SYMBOL_BITS;
    /** Count and checksum. */
    private static final int OVERHEAD = 3;
    /** Six symbols 2A of training and the start symbols 38 2C. */
    private static final String START = symbol(0x2A).repeat(6) + symbol(0x38) + symbol(0x2C);

    private RadioPacket() {
    }

    /**
     * The bits of a packet.
     *
     * @param payload 1…77 bytes.
     * @return 84 + 12 n bits.
     */
    public static String encode(Bytes payload) {
        if (payload.length() < 1 || payload.length() > MAX_PAYLOAD_LENGTH) {
            throw new IllegalArgumentException("a radio packet has 1…77 bytes of payload, not " + payload.length());
        }
        Bytes counted = Bytes.join(Bytes.of(payload.length() + OVERHEAD), payload);
        Bytes bytes = Bytes.join(counted, Crc16.bytesOf(counted));
        StringBuilder bits = new StringBuilder(START);
        for (int i = 0; i < bytes.length(); i++) {
            bits.append(symbol(SYMBOLS[bytes.at(i) >> 4])).append(symbol(SYMBOLS[bytes.at(i) & 0xF]));
        }
        return bits.toString();
    }

    /**
     * Reads the bits of a whole packet, training included; bits after its end are ignored.
     *
     * @return the payload.
     * @throws ProtocolException BAD_START, BAD_SYMBOL, BAD_COUNT or BAD_CRC.
     */
    public static Bytes decode(String bits) throws ProtocolException {
        if (!bits.startsWith(START)) {
            throw new ProtocolException(ProtocolError.BAD_START, "no training and start symbols");
        }
        String coded = bits.substring(START.length());
        int count = coded.length() < BYTE_BITS ? 0 : decodeByte(coded, 0);
        if (count <= OVERHEAD || count > MAX_PAYLOAD_LENGTH + OVERHEAD || coded.length() < count * BYTE_BITS) {
            throw new ProtocolException(ProtocolError.BAD_COUNT,
                    "count " + count + " with " + coded.length() / BYTE_BITS + " bytes");
        }
        int[] bytes = new int[count];
        for (int i = 0; i < count; i++) {
            bytes[i] = decodeByte(coded, i);
        }
        return Crc16.strip(Bytes.of(bytes)).from(1);
    }

    private static int decodeByte(String coded, int index) throws ProtocolException {
        int at = index * BYTE_BITS;
        return decodeNibble(coded, at) << 4 | decodeNibble(coded, at + SYMBOL_BITS);
    }

    private static int decodeNibble(String coded, int at) throws ProtocolException {
        String found = coded.substring(at, at + SYMBOL_BITS);
        for (int nibble = 0; nibble < SYMBOLS.length; nibble++) {
            if (symbol(SYMBOLS[nibble]).equals(found)) {
                return nibble;
            }
        }
        throw new ProtocolException(ProtocolError.BAD_SYMBOL, "no symbol: " + found);
    }

    /** Six bits, least significant first. */
    private static String symbol(int value) {
        StringBuilder bits = new StringBuilder(SYMBOL_BITS);
        for (int i = 0; i < SYMBOL_BITS; i++) {
            bits.append((value >> i & 1) == 0 ? '0' : '1');
        }
        return bits.toString();
    }
}
