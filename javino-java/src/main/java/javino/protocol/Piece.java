package javino.protocol;

import java.util.ArrayList;
import java.util.List;

/**
 * A part of a frame that is too long for one radio packet (SPEC 7.1).
 *
 * @param origin the device that sends the whole frame.
 * @param id     0…63: the same for all pieces of a frame.
 * @param index  0…7: which part of the frame it is.
 * @param asks   whether the sender wants an answer that tells which pieces arrived.
 * @param part   1…67 bytes of the whole frame; the first piece's begin with its header, and there are 67.
 */
public record Piece(Address origin, int id, int index, boolean asks, Bytes part) {

    /** The most bytes of a part; all but the last of a frame have so many. */
    public static final int MAX_LENGTH = 67;
    /** The most pieces of a frame. */
    public static final int MAX_PIECES = 8;
    /** A frame that is cut is longer than one packet. */
    private static final int MIN_WHOLE = RadioPacket.MAX_PAYLOAD_LENGTH + 1;
    private static final int ID_DIGITS = 64;

    /** @throws IllegalArgumentException if no frame can have such a piece; the message says why. */
    public Piece {
        check(origin.kind() == Address.Kind.DEVICE, "pieces come from a device, not " + origin);
        check(id >= 0 && id < ID_DIGITS, "a piece's id is 0…63, not " + id);
        check(index >= 0 && index < MAX_PIECES, "a piece's index is 0…7, not " + index);
        check(part.length() >= 1 && part.length() <= MAX_LENGTH, "a piece has 1…67 bytes, not " + part.length());
        if (index == 0) {
            checkFirst(origin, part);
        } else {
            int end = MAX_LENGTH * index + part.length();
            check(end >= MIN_WHOLE && end <= Frame.MAX_LENGTH,
                    "a frame that is cut has 78…521 bytes, and this piece would end at " + end);
        }
    }

    private static void checkFirst(Address origin, Bytes part) {
        check(part.length() == MAX_LENGTH, "a first piece has 67 bytes, not " + part.length());
        int total = Frame.lengthIn(part);
        check(total >= MIN_WHOLE, "a frame that is cut has 78…521 bytes and a header that says so: " + part.hex());
        check(part.slice(Address.LENGTH, 2 * Address.LENGTH).equals(origin.toBytes()),
                "a frame comes from whom its pieces come from, not " + origin + ": " + part.hex());
        check(switch (new Address(Digits.parse(part, 0, Address.LENGTH)).kind()) {
            case DEVICE, MULTICAST, BROADCAST -> true;
            default -> false;
        }, "a frame that is cut goes to a device, a group or all: " + part.hex());
    }

    private static void check(boolean condition, String complaint) {
        if (!condition) {
            throw new IllegalArgumentException(complaint);
        }
    }

    /**
     * Cuts a frame, sealed already where it is to be; no piece asks for an answer.
     *
     * @param whole of 78…521 bytes.
     * @param id    0…63, raised by one for each frame that the sender cuts.
     * @return 2…8 pieces.
     * @throws IllegalArgumentException if the frame fits one packet, or no board can receive it.
     */
    public static List<Piece> cut(Frame whole, int id) {
        check(whole.length() >= MIN_WHOLE, "a frame of " + whole.length() + " bytes fits one packet");
        Bytes bytes = whole.encode();
        List<Piece> pieces = new ArrayList<>();
        for (int at = 0; at < bytes.length(); at += MAX_LENGTH) {
            pieces.add(new Piece(whole.origin(), id, pieces.size(), false,
                    bytes.slice(at, Math.min(at + MAX_LENGTH, bytes.length()))));
        }
        return List.copyOf(pieces);
    }

    /**
     * Reads the frame of a piece.
     *
     * @throws ProtocolException BAD_PIECE if it is none, or none that a frame can have.
     */
    public static Piece decode(Frame frame) throws ProtocolException {
        Address address = frame.destination();
        if (address.kind() != Address.Kind.PIECE) {
            throw new ProtocolException(ProtocolError.BAD_PIECE, "a piece goes to +F.., not " + address);
        }
        int index = address.value() & 0x3F;
        if (index >= 2 * MAX_PIECES) {
            throw new ProtocolException(ProtocolError.BAD_PIECE, "a piece's last digit is A…P: " + address);
        }
        try {
            return new Piece(frame.origin(), address.value() >> 6 & 0x3F, index % MAX_PIECES, index >= MAX_PIECES,
                    frame.message());
        } catch (IllegalArgumentException e) {
            throw new ProtocolException(ProtocolError.BAD_PIECE, e.getMessage());
        }
    }

    /** The same piece, for which the sender wants an answer. */
    public Piece asking() {
        return new Piece(origin, id, index, true, part);
    }

    /** The piece as it goes on the air. */
    public Frame frame() {
        int digits = id << 6 | index + (asks ? MAX_PIECES : 0);
        return new Frame(new Address(Address.PIECE_GROUP << 12 | digits), origin, part);
    }

    /** The least bytes that the whole frame can have. */
    int leastTotal() {
        return index == 0 ? Frame.lengthIn(part) : MAX_LENGTH * index + part.length();
    }

    /** The most bytes that the whole frame can have. */
    int mostTotal() {
        return index > 0 && part.length() == MAX_LENGTH ? Frame.MAX_LENGTH : leastTotal();
    }
}
