package javino.protocol;

/**
 * The unit of serial line and air: {@code destination(4) origin(4) size(2) message(n)} (SPEC 2).
 *
 * @param destination its receiver or receivers.
 * @param origin      a device, or {@link Address#SERIAL}.
 * @param message     0…511 bytes.
 */
public record Frame(Address destination, Address origin, Bytes message) {

    /** Bytes of destination, origin and size. */
    public static final int HEADER_LENGTH = 10;
    /** The most bytes of a message. */
    public static final int MAX_MESSAGE_LENGTH = 511;
    /** The most bytes of a frame. */
    public static final int MAX_LENGTH = HEADER_LENGTH + MAX_MESSAGE_LENGTH;

    private static final int SIZE_OFFSET = 8;

    /** @throws IllegalArgumentException if the origin can send nothing or the message is too long. */
    public Frame {
        if (!canBeOrigin(origin)) {
            throw new IllegalArgumentException("an origin is a device or ++++, not " + origin);
        }
        if (message.length() > MAX_MESSAGE_LENGTH) {
            throw new IllegalArgumentException(
                    "a message has at most " + MAX_MESSAGE_LENGTH + " bytes, not " + message.length());
        }
    }

    /**
     * Reads a frame that fills the bytes exactly.
     *
     * @throws ProtocolException TOO_SHORT, BAD_DIGIT, PARTIAL_BYTE, SIZE_MISMATCH or BAD_ORIGIN, checked in this order.
     */
    public static Frame decode(Bytes bytes) throws ProtocolException {
        if (bytes.length() < HEADER_LENGTH) {
            throw new ProtocolException(ProtocolError.TOO_SHORT,
                    "a frame has at least 10 bytes, not " + bytes.length() + ": " + bytes.hex());
        }
        Address destination = Address.decode(bytes, 0);
        Address origin = Address.decode(bytes, Address.LENGTH);
        checkSize(Digits.parse(bytes, SIZE_OFFSET, HEADER_LENGTH), bytes);
        if (!canBeOrigin(origin)) {
            throw new ProtocolException(ProtocolError.BAD_ORIGIN, "an origin is a device or ++++, not " + origin);
        }
        return new Frame(destination, origin, bytes.from(HEADER_LENGTH));
    }

    private static void checkSize(int bits, Bytes frame) throws ProtocolException {
        int arrived = 8 * (frame.length() - HEADER_LENGTH);
        if (bits < 0) {
            throw new ProtocolException(ProtocolError.BAD_DIGIT,
                    "no size: " + frame.slice(SIZE_OFFSET, HEADER_LENGTH).hex());
        }
        if (bits % 8 != 0) {
            throw new ProtocolException(ProtocolError.PARTIAL_BYTE, "size " + bits + " is no multiple of 8 bits");
        }
        if (bits != arrived) {
            throw new ProtocolException(ProtocolError.SIZE_MISMATCH,
                    "size says " + bits + " bits, " + arrived + " follow");
        }
    }

    private static boolean canBeOrigin(Address address) {
        return address.kind() == Address.Kind.DEVICE || address.equals(Address.SERIAL);
    }

    /** Destination, origin and size: the ten bytes before the message. */
    public Bytes header() {
        return header(destination, origin, message.length());
    }

    /** The header of a frame whose message has so many bytes. */
    public static Bytes header(Address destination, Address origin, int length) {
        return Bytes.join(destination.toBytes(), origin.toBytes(),
                Bytes.ofText(Digits.format(8 * length, HEADER_LENGTH - SIZE_OFFSET)));
    }

    /** The frame's bytes. */
    public Bytes encode() {
        byte[] frame = new byte[length()];
        write(frame, 0);
        return Bytes.owning(frame);
    }

    /** The number of the frame's bytes. */
    int length() {
        return HEADER_LENGTH + message.length();
    }

    /** Writes the frame's bytes into an array from an index on. */
    void write(byte[] into, int at) {
        Digits.write(into, at, destination.value(), Address.LENGTH);
        Digits.write(into, at + Address.LENGTH, origin.value(), Address.LENGTH);
        Digits.write(into, at + SIZE_OFFSET, 8 * message.length(), HEADER_LENGTH - SIZE_OFFSET);
        message.copyTo(into, at + HEADER_LENGTH);
    }
}
