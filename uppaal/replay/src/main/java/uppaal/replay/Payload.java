package uppaal.replay;

import com.google.gson.JsonParseException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HexFormat;

/**
 * What crossed the air in one packet, as far as it can be read without keys (SPEC 2, 5 and 7).
 *
 * @param kind as in the trace: {@code unicast}, {@code piece}, {@code acknowledgement}, …
 * @param message what follows the header, of a frame; else all
 */
record Payload(String hex, String kind, String destination, String origin, byte[] message) {

    private static final String DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    private static final int SIZE_AT = 8;
    /** The longest piece. */
    static final int PART = 67;
    private static final int ASKS = 8;
    /** The destination of broadcasts. */
    static final String ALL = "////";
    private static final int BITS = 8;

    /** @throws JsonParseException where the event has no packet */
    static Payload of(Event event) {
        byte[] bytes;
        try {
            bytes = HexFormat.of().parseHex(event.text("payload"));
        } catch (IllegalArgumentException wrong) {
            throw new JsonParseException("a payload that is not in hexadecimal digits", wrong);
        }
        return of(event.text("payload"), event.text("kind"), bytes);
    }

    private static Payload of(String hex, String kind, byte[] bytes) {
        boolean frame = !kind.equals("no frame") && bytes.length >= Frame.HEADER;
        return new Payload(hex, frame ? kind : "no frame", frame ? text(bytes, 0) : "", frame ? text(bytes, 4) : "",
                frame ? Arrays.copyOfRange(bytes, Frame.HEADER, bytes.length) : bytes);
    }

    private static String text(byte[] bytes, int at) {
        return new String(bytes, at, 4, StandardCharsets.US_ASCII);
    }

    /** The value of a digit of an address. */
    static int digit(String address, int at) {
        return DIGITS.indexOf(address.charAt(at));
    }

    /** How many bytes cross the air. */
    int length() {
        return hex.length() / 2;
    }

    boolean isPiece() {
        return kind.equals("fragment");
    }

    boolean isAcknowledgement() {
        return kind.equals("acknowledgement");
    }

    /** Whether it is a message, or a piece of one. */
    boolean isData() {
        return isPiece() || kind.equals("unicast") || kind.equals("multicast") || kind.equals("broadcast");
    }

    /** Of a piece: the number of its message, 0…63. */
    int pieceId() {
        return digit(destination, 2);
    }

    /** Of a piece: which it is, 0…7; of a frame in one packet 0. */
    int index() {
        return isPiece() ? digit(destination, 3) % ASKS : 0;
    }

    /** Whether it wants an answer, if the message is a unicast. */
    boolean asks() {
        return !isPiece() || digit(destination, 3) >= ASKS;
    }

    /** What it is a part of: itself, or of a first piece the frame whose header it holds, as far as it is there. */
    Payload whole() {
        if (!isPiece() || message.length < Frame.HEADER) {
            return this;
        }
        String to = text(message, 0);
        String kind = to.equals(ALL) ? "broadcast" : to.startsWith("//") ? "multicast" : "unicast";
        return of(HexFormat.of().formatHex(message), kind, message);
    }

    /** How many pieces the frame has whose header this first piece holds. */
    int pieces() {
        return isPiece() ? Math.max(1, (lengthIn(message) + PART - 1) / PART) : 1;
    }

    /** The frame, or of a first piece as much of the frame as it holds. */
    byte[] frame() {
        return isPiece() ? message : HexFormat.of().parseHex(hex);
    }

    /** How long the frame is whose header stands here; 0 where none does. */
    static int lengthIn(byte[] frame) {
        for (int at = 0; at < Frame.HEADER; at++) {
            if (frame.length < Frame.HEADER || DIGITS.indexOf(frame[at]) < 0) {
                return 0;
            }
        }
        int bits = DIGITS.indexOf(frame[SIZE_AT]) * DIGITS.length() + DIGITS.indexOf(frame[SIZE_AT + 1]);
        return bits % BITS == 0 ? Frame.HEADER + bits / BITS : 0;
    }

    /** The header of a frame whose message has so many bytes. */
    static byte[] header(String destination, String origin, int length) {
        int bits = BITS * length;
        return (destination + origin + DIGITS.charAt(bits / DIGITS.length()) + DIGITS.charAt(bits % DIGITS.length()))
                .getBytes(StandardCharsets.US_ASCII);
    }

    /** Of a unicast or multicast: its nonce in hexadecimal digits; empty where there is no room for nonce and tag. */
    String nonce() {
        return message.length < SharedKey.NONCE + SharedKey.TAG ? ""
                : HexFormat.of().formatHex(message, 0, SharedKey.NONCE);
    }

    /** Of an acknowledgement: the last 12 bits of the nonce that it answers. */
    int answered() {
        return digit(destination, 2) * DIGITS.length() + digit(destination, 3);
    }

    /** What a host is told of a nonce: the last byte of the epoch, and the last two of the counter. */
    static String id(String nonce) {
        return nonce.substring(4, 6) + nonce.substring(8);
    }

    /** The last 12 bits of a nonce. */
    static int lastBits(String nonce) {
        return Integer.parseInt(nonce.substring(9), 16);
    }

    /** Of a frame with room for a nonce: the last 12 bits of that. */
    int lastBits() {
        return lastBits(HexFormat.of().formatHex(message, 0, SharedKey.NONCE));
    }

    /** The same for every time that the same piece, or frame, is sent. */
    String identity() {
        return isPiece() ? "fragment " + origin + pieceId() + "/" + index() + HexFormat.of().formatHex(message) : hex;
    }

    /** Whether it goes to a device, in one packet, and is long enough for a nonce. */
    boolean isForDevice() {
        return kind.equals("unicast") && message.length >= SharedKey.NONCE;
    }

    /** Whether devices with this address are meant. */
    static boolean concerns(String destination, String id) {
        return destination.equals(ALL) || destination.equals(id)
                || destination.startsWith("//") && id.startsWith(destination.substring(2));
    }
}
