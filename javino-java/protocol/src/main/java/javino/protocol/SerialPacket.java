package javino.protocol;

/**
 * A packet on the serial line: a frame with its sequence byte (SPEC 4.1).
 *
 * @param sequence 0…255; a reply has that of its request.
 * @param frame    a request or a reply.
 */
public record SerialPacket(int sequence, Frame frame) {

    /** The most bytes before COBS. */
    public static final int MAX_LENGTH = 1 + Frame.MAX_LENGTH + 2;
    /** The fewest bytes before COBS. */
    public static final int MIN_LENGTH = 1 + Frame.HEADER_LENGTH + 2;

    /** @throws IllegalArgumentException if the sequence is no byte. */
    public SerialPacket {
        if (sequence < 0 || sequence > 0xFF) {
            throw new IllegalArgumentException("a sequence is 0…255, not " + sequence);
        }
    }

    /** The packet's bytes on the line, with the closing 0x00. */
    public Bytes encode() {
        byte[] body = new byte[1 + frame.length()];
        body[0] = (byte) sequence;
        frame.write(body, 1);
        Bytes plain = Bytes.owning(body);
        return Cobs.encode(Bytes.join(plain, Crc16.bytesOf(plain)));
    }

    /**
     * Reads what COBS held.
     *
     * @throws ProtocolException TOO_LONG, TOO_SHORT, BAD_CRC or the frame's error, checked in this order.
     */
    static SerialPacket decode(Bytes decoded) throws ProtocolException {
        if (decoded.length() > MAX_LENGTH) {
            throw new ProtocolException(ProtocolError.TOO_LONG, "a packet has at most " + MAX_LENGTH + " bytes");
        }
        if (decoded.length() < MIN_LENGTH) {
            throw new ProtocolException(ProtocolError.TOO_SHORT,
                    "a packet has at least " + MIN_LENGTH + " bytes, not " + decoded.length() + ": " + decoded.hex());
        }
        Bytes body = Crc16.strip(decoded);
        return new SerialPacket(body.at(0), Frame.decode(body.from(1)));
    }
}
