package javino.protocol;

/**
 * An RF address: four Base64 digits, the first two its group, the last two its member (SPEC 1).
 *
 * @param value the 24 bits, 0x000000…0xFFFFFF.
 */
public record Address(int value) {

    /** The number of digits, and of bytes where an address is written in a frame. */
    public static final int LENGTH = 4;
    /** {@code ++++}: the line between a host and its board. */
    public static final Address SERIAL = parse("++++");
    /** {@code ////}: every device in range. */
    public static final Address BROADCAST = parse("////");

    /** The value of {@code ++++}; a number, as {@link #SERIAL} itself may be under construction where it is needed. */
    private static final int SERIAL_VALUE = 0xFBEFBE;

    /** The first 12 bits of a fragment's address, {@code +F}, and of an acknowledgement's, {@code +K}. */
    private static final int FRAGMENT_GROUP = 0xF85;
    private static final int ACKNOWLEDGEMENT_GROUP = 0xF8A;

    /** The values of {@code self}, {@code true}, {@code else} and {@code elif}: words of AgentSpeak, no senders. */
    private static final int SELF = 0xB1E95F;
    private static final int TRUE = 0xB6BB9E;
    private static final int ELSE = 0x7A5B1E;
    private static final int ELIF = 0x7A589F;

    /** The kind of thing that an address stands for. */
    public enum Kind {
        /** One device: {@code AAAA}…{@code 9///}. */
        DEVICE,
        /** The line between a host and its board: {@code ++++}. */
        SERIAL,
        /** Every device in range: {@code ////}. */
        BROADCAST,
        /** Every device of a group: {@code //AA}…{@code ///+}. */
        MULTICAST,
        /** A part of a longer frame (SPEC 7.1): {@code +F} and two digits. */
        FRAGMENT,
        /** The answer to a frame (SPEC 7.3): {@code +K} and two digits. */
        ACKNOWLEDGEMENT,
        /**
         * None of the others, or a name to which AgentSpeak gives a meaning, such as {@code self}; nothing is sent to
         * it.
         */
        RESERVED
    }

    /** @throws IllegalArgumentException if the value has more than 24 bits. */
    public Address {
        if (value < 0 || value > 0xFFFFFF) {
            throw new IllegalArgumentException("an address has 24 bits, not the value " + value);
        }
    }

    /**
     * Reads four digits such as {@code ROMA}.
     *
     * @throws IllegalArgumentException if the text is anything else; the message says what is wrong.
     */
    public static Address parse(String text) {
        if (text.length() != LENGTH) {
            throw new IllegalArgumentException(
                    "an address has 4 characters of A-Z a-z 0-9 + /, but \"" + text + "\" has " + text.length());
        }
        int value = 0;
        for (int i = 0; i < LENGTH; i++) {
            int digit = Digits.value(text.charAt(i));
            if (digit < 0) {
                throw new IllegalArgumentException("an address has 4 characters of A-Z a-z 0-9 + /, but '"
                        + text.charAt(i) + "' in \"" + text + "\" is none");
            }
            value = value << 6 | digit;
        }
        return new Address(value);
    }

    /**
     * The multicast address of a group.
     *
     * @param group two digits other than {@code //}.
     * @throws IllegalArgumentException if the group is anything else.
     */
    public static Address multicast(String group) {
        Address address = group.length() == 2 ? parse("//" + group) : null;
        if (address == null || address.kind() != Kind.MULTICAST) {
            throw new IllegalArgumentException("a group is two characters other than //, not \"" + group + "\"");
        }
        return address;
    }

    /**
     * The address of a fragment of a frame (SPEC 7.1).
     *
     * @param id    the number of the frame, 0…63.
     * @param index the number of the fragment, 0…7, and 8 more if it asks for an answer.
     */
    public static Address fragment(int id, int index) {
        return new Address(FRAGMENT_GROUP << 12 | id << 6 | index);
    }

    /** The address of the answer to a frame (SPEC 7.3). @param lastBits the last 12 bits of its nonce. */
    public static Address acknowledgement(int lastBits) {
        return new Address(ACKNOWLEDGEMENT_GROUP << 12 | lastBits);
    }

    /**
     * Reads the four bytes at an offset.
     *
     * @throws ProtocolException TOO_SHORT or BAD_DIGIT.
     */
    public static Address decode(Bytes bytes, int offset) throws ProtocolException {
        if (bytes.length() < offset + LENGTH) {
            throw new ProtocolException(ProtocolError.TOO_SHORT, "no address at byte " + offset + " of " + bytes.hex());
        }
        int value = Digits.parse(bytes, offset, offset + LENGTH);
        if (value < 0) {
            throw new ProtocolException(ProtocolError.BAD_DIGIT,
                    "no address: " + bytes.slice(offset, offset + LENGTH).hex());
        }
        return new Address(value);
    }

    /** The kind of thing that the address stands for. */
    public Kind kind() {
        int plus = Digits.value('+');
        int slash = Digits.value('/');
        int first = value >> 18;
        int second = value >> 12 & 0x3F;
        if (first < plus) {
            return isWord() ? Kind.RESERVED : Kind.DEVICE;
        }
        if (first == slash && second == slash) {
            return (value & 0xFFF) == 0xFFF ? Kind.BROADCAST : Kind.MULTICAST;
        }
        return switch (value >> 12) {
            case FRAGMENT_GROUP -> Kind.FRAGMENT;
            case ACKNOWLEDGEMENT_GROUP -> Kind.ACKNOWLEDGEMENT;
            default -> value == SERIAL_VALUE ? Kind.SERIAL : Kind.RESERVED;
        };
    }

    private boolean isWord() {
        return switch (value) {
            case SELF, TRUE, ELSE, ELIF -> true;
            default -> false;
        };
    }

    /** Whether a frame to this address is for a device: for it alone, its group or all (SPEC 1). */
    public boolean reaches(Address device) {
        return switch (kind()) {
            case BROADCAST -> true;
            case MULTICAST -> member().equals(device.group());
            default -> equals(device);
        };
    }

    /** The first two digits. */
    public String group() {
        return toString().substring(0, 2);
    }

    /** The last two digits. */
    public String member() {
        return toString().substring(2);
    }

    /** The four digits as bytes. */
    public Bytes toBytes() {
        byte[] digits = new byte[LENGTH];
        Digits.write(digits, 0, value, LENGTH);
        return Bytes.owning(digits);
    }

    /** The four digits. */
    @Override
    public String toString() {
        return Digits.format(value, LENGTH);
    }
}
