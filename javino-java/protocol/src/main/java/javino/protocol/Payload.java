package javino.protocol;

import java.nio.charset.StandardCharsets;

/**
 * The bytes of one packet on the air, as far as they can be read without keys (SPEC 2, 5 and 7): any bytes.
 *
 * @param kind  by its bytes; if these are only the beginning of a frame, by its header.
 * @param bytes all of it.
 */
public record Payload(Kind kind, Bytes bytes) {

    /** The longest part of a frame in a fragment. */
    public static final int PART_LENGTH = 67;
    /** The same over an E32 (SPEC 6.2). */
    public static final int E32_PART_LENGTH = 42;
    /** The length of the nonce before the content of a sealed message. */
    public static final int NONCE_LENGTH = 6;
    /** The tag behind a sealed content; also the proof at the end of an acknowledgement. */
    public static final int TAG_LENGTH = 8;

    private static final int SIZE_OFFSET = 2 * Address.LENGTH;
    private static final int ASKS = 8;

    /** The kind of a payload, named as in a trace of the emulator. */
    public enum Kind {
        UNICAST("unicast"), MULTICAST("multicast"), BROADCAST("broadcast"), FRAGMENT("fragment"),
        ACKNOWLEDGEMENT("acknowledgement"), RESERVED("reserved"), NO_FRAME("no frame");

        private final String text;

        Kind(String text) {
            this.text = text;
        }

        @Override
        public String toString() {
            return text;
        }
    }

    /** Reads a packet's payload. */
    public static Payload of(Bytes bytes) {
        return new Payload(lengthIn(bytes) == bytes.length() ? kind(text(bytes, 0)) : Kind.NO_FRAME, bytes);
    }

    private static Kind kind(String to) {
        Kind ofFrame = kindOfFrame(to);
        if (ofFrame != Kind.UNICAST || Digits.value(to.charAt(0)) < Digits.value('+')) {
            return ofFrame;
        }
        boolean isFragment = to.startsWith("+F") && Digits.value(to.charAt(3)) < 2 * ASKS;
        return isFragment ? Kind.FRAGMENT : to.startsWith("+K") ? Kind.ACKNOWLEDGEMENT : Kind.RESERVED;
    }

    private static Kind kindOfFrame(String to) {
        return to.equals("////") ? Kind.BROADCAST : to.startsWith("//") ? Kind.MULTICAST : Kind.UNICAST;
    }

    private static String text(Bytes bytes, int at) {
        return new String(bytes.slice(at, at + Address.LENGTH).toArray(), StandardCharsets.US_ASCII);
    }

    /** How long the frame is whose header begins these bytes; 0 if none does. */
    public static int lengthIn(Bytes bytes) {
        int bits = bytes.length() < Frame.HEADER_LENGTH || Digits.parse(bytes, 0, Address.LENGTH) < 0
                || Digits.parse(bytes, Address.LENGTH, SIZE_OFFSET) < 0 ? -1
                        : Digits.parse(bytes, SIZE_OFFSET, Frame.HEADER_LENGTH);
        return bits >= 0 && bits % 8 == 0 ? Frame.HEADER_LENGTH + bits / 8 : 0;
    }

    private boolean isFrame() {
        return kind != Kind.NO_FRAME;
    }

    /** All of it in hexadecimal digits. */
    public String hex() {
        return bytes.hex();
    }

    /** The address that it goes to; empty if it is no frame. */
    public String destination() {
        return isFrame() ? text(bytes, 0) : "";
    }

    /** The address of its sender; empty if it is no frame. */
    public String origin() {
        return isFrame() ? text(bytes, Address.LENGTH) : "";
    }

    /** The bytes behind the header of a frame; else all. */
    public Bytes message() {
        return isFrame() ? bytes.from(Frame.HEADER_LENGTH) : bytes;
    }

    public boolean isFragment() {
        return kind == Kind.FRAGMENT;
    }

    public boolean isAcknowledgement() {
        return kind == Kind.ACKNOWLEDGEMENT;
    }

    /** Whether it is a message, or a fragment of one. */
    public boolean isData() {
        return kind.compareTo(Kind.FRAGMENT) <= 0;
    }

    private int digit(int at) {
        return Digits.value(bytes.at(at));
    }

    /** The number of a fragment's frame, 0…63. */
    public int fragmentId() {
        return digit(2);
    }

    /** The number of a fragment, 0…7; else 0. */
    public int index() {
        return isFragment() ? digit(3) % ASKS : 0;
    }

    /** Whether it wants an answer, if the message is a unicast. */
    public boolean asks() {
        return !isFragment() || digit(3) >= ASKS;
    }

    /** The last 12 bits of the nonce that an acknowledgement answers. */
    public int answered() {
        return digit(2) << 6 | digit(3);
    }

    /** The frame whose header a first fragment holds, as far as it is there; of other payloads these themselves. */
    public Payload whole() {
        boolean begins = isFragment() && index() == 0 && message().length() >= Frame.HEADER_LENGTH;
        return begins ? new Payload(kindOfFrame(text(message(), 0)), message()) : this;
    }

    /** Whether it is a message to a device or a group, in one packet and with room for a nonce. */
    public boolean hasNonce() {
        return (kind == Kind.UNICAST || kind == Kind.MULTICAST) && message().length() >= NONCE_LENGTH;
    }

    /** The nonce of a message with room for nonce and tag, in hexadecimal digits; else empty. */
    public String nonce() {
        return message().length() < NONCE_LENGTH + TAG_LENGTH ? "" : message().slice(0, NONCE_LENGTH).hex();
    }

    /** The last 12 bits of the nonce. */
    public int lastBits() {
        return (int) message().number(NONCE_LENGTH - 2, NONCE_LENGTH) & 0xFFF;
    }

    /** The same for every time that the same fragment, or frame, is sent. */
    public String identity() {
        return isFragment() ? "fragment " + origin() + fragmentId() + "/" + index() + message().hex() : hex();
    }
}
