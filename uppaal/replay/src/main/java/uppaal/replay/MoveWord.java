package uppaal.replay;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * What a host says to another one of a move (SPEC 9.1).
 *
 * @param type its letter
 * @param move the number of the move in hexadecimal digits
 */
record MoveWord(char type, String move, byte[] body) {

    /** The most bytes of a part in one message. */
    static final int MOST_DATA = 480;
    /** In the order of their numbers on the air. */
    private static final String TYPES = "OWDRGACX";
    private static final int FIRST = 0x8C;
    private static final int NUMBER_AT = 1;
    private static final int BODY_AT = NUMBER_AT + 4;
    private static final int OFFSET = 3;
    private static final int HASH = 8;
    private static final int PARTS_AT = 2;
    private static final int PART = HASH + 2 * OFFSET;
    private static final int TOKEN = 8;
    private static final int HOME = 4;
    private static final int MOST_PARTS = 8;
    private static final int BYTE = 0xFF;
    private static final Map<Character, String> NAMES = Map.of('O', "offer", 'W', "want", 'D', "data", 'R', "ready",
            'G', "go", 'A', "awake", 'C', "cancelled", 'X', "refused");

    /**
     * A text of the agent that moves.
     *
     * @param hash in hexadecimal digits
     * @param packed how many bytes travel of it
     */
    record Part(String hash, int packed) {}

    /** What a message says of a move; nothing where it is another one. */
    static Optional<MoveWord> of(byte[] message) {
        int type = message.length < BODY_AT ? -1 : (message[0] & BYTE) - FIRST;
        return type < 0 || type >= TYPES.length() ? Optional.empty() : Optional.of(new MoveWord(TYPES.charAt(type),
                HexFormat.of().formatHex(message, NUMBER_AT, BODY_AT),
                Arrays.copyOfRange(message, BODY_AT, message.length)));
    }

    /** What a type is called. */
    static String name(char type) {
        return NAMES.get(type);
    }

    boolean is(char other) {
        return type == other;
    }

    /** Whether the sender of the agent says it, or else the receiver. */
    boolean isOfSender() {
        return is('O') || is('D') || is('G') || is('C');
    }

    /** Whether it has the form of its type. */
    boolean isRight() {
        return switch (type) {
            case 'O' -> body.length > PARTS_AT && body[1] > 0 && body[1] <= MOST_PARTS
                    && body.length > PARTS_AT + body[1] * PART + TOKEN + HOME;
            case 'W' -> body.length > 0 && body.length % OFFSET == 0;
            case 'D' -> body.length > 1 + OFFSET && length() <= MOST_DATA;
            case 'X' -> text(0).indexOf(' ') > 0;
            case 'A' -> true;
            default -> body.length == 0;
        };
    }

    /** Of an offer: whether the agent stays as well. */
    boolean isCloning() {
        return body[0] == 'c';
    }

    /** Of an offer. */
    List<Part> parts() {
        List<Part> parts = new ArrayList<>();
        for (int at = PARTS_AT; at < PARTS_AT + body[1] * PART; at += PART) {
            parts.add(new Part(HexFormat.of().formatHex(body, at, at + HASH), number(at + HASH)));
        }
        return parts;
    }

    /** Of an offer: home and name, which an agent keeps wherever it goes. */
    String identity() {
        return text(PARTS_AT + body[1] * PART + TOKEN);
    }

    /** Of a want: how many bytes of each part are there. */
    List<Integer> offsets() {
        List<Integer> offsets = new ArrayList<>();
        for (int at = 0; at < body.length; at += OFFSET) {
            offsets.add(number(at));
        }
        return offsets;
    }

    /** Of data: which part. */
    int part() {
        return body[0] & BYTE;
    }

    /** Of data: where its bytes begin. */
    int offset() {
        return number(1);
    }

    /** Of data: how many bytes. */
    int length() {
        return body.length - 1 - OFFSET;
    }

    /** Of data: behind its last byte. */
    int end() {
        return offset() + length();
    }

    /** The same data as those of a part of another move. */
    MoveWord of(String other, int part) {
        byte[] bytes = body.clone();
        bytes[0] = (byte) part;
        return new MoveWord(type, other, bytes);
    }

    /** Of awake: the agent's name there; empty where nothing is known of the move. */
    String agent() {
        return text(0);
    }

    private int number(int at) {
        return (body[at] & BYTE) << 16 | (body[at + 1] & BYTE) << 8 | body[at + 2] & BYTE;
    }

    private String text(int from) {
        return new String(body, from, body.length - from, StandardCharsets.UTF_8);
    }

    @Override
    public String toString() {
        String more = !isRight() ? " of a wrong form" : switch (type) {
            case 'W' -> " from byte " + offsets().stream().map(String::valueOf).collect(Collectors.joining(", "));
            case 'D' -> " (part " + part() + ", bytes " + offset() + " to " + (end() - 1) + ")";
            case 'A' -> " as '" + Bytes.shown(agent()) + "'";
            default -> "";
        };
        return "'" + name(type) + "'" + more;
    }
}
