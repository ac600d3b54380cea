package javino.protocol;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Finds packets in the bytes of a serial line, however they are split (SPEC 4.1).
 * Damage is refused as one result, and the next packet is found after its 0x00. Not for several threads.
 */
public final class PacketDecoder {

    private static final byte[] ZERO = {0};
    private static final byte DELETE = 0x7F;
    /** The bytes of a line of one character: fewer may be damage that looks like text. */
    private static final int SHORTEST_TEXT = 3;
    /** The bytes of the longest packet on the line. */
    private static final int LONGEST_TEXT = SerialPacket.MAX_LENGTH + 4;

    /** One byte more than a packet can have, so that memory is bounded and a long one is still seen. */
    private final byte[] decoded = new byte[SerialPacket.MAX_LENGTH + 1];
    private int length;
    /** Whether a packet has begun; the two below are of its block of COBS, and hold only then. */
    private boolean begun;
    /** Bytes still to come; with none missing, the next byte is a code or the end. */
    private int missing;
    /** Whether a zero follows the block, if another block does. */
    private boolean withZero;
    /** The bytes since the last zero or text, as far as they can be a text and a packet. */
    private final byte[] raw = new byte[2 * LONGEST_TEXT + Cobs.FULL_BLOCK];
    private int rawLength;
    /** How many of these bytes can be text, up to the first that cannot. */
    private int textLength;
    /** Whether the beginning of the text was told already. */
    private boolean textTold;

    /** The result for a part of the bytes. */
    public sealed interface Result {
    }

    /** @param packet found undamaged. */
    public record Found(SerialPacket packet) implements Result {
    }

    /** @param cause why what came before the 0x00 is no packet. */
    public record Refused(ProtocolException cause) implements Result {
    }

    /**
     * Text between two packets, or before one, which only the sketch can have written.
     *
     * @param text without blanks around it; some of a long one.
     */
    public record Printed(String text) implements Result {
    }

    /** @param asksAgain whether it is an empty packet, by which a board asks again, or only a 0x00. */
    public record Empty(boolean asksAgain) implements Result {
    }

    /**
     * Takes bytes from the line.
     *
     * @param bytes read from.
     * @param count the first so many of them count.
     * @return a result for each 0x00 and each text, in order.
     */
    public List<Result> feed(byte[] bytes, int count) {
        List<Result> results = new ArrayList<>(1);
        int at = 0;
        while (at < count) {
            if (begun && missing > 0 && bytes[at] != 0) {
                int end = endOfData(bytes, at, Math.min(count, at + missing));
                keepRaw(bytes, at, end, results);
                keep(bytes, at, end - at);
                missing -= end - at;
                at = end;
            } else {
                keepRaw(bytes, at, bytes[at] == 0 ? at : at + 1, results);
                accept(bytes[at] & 0xFF, results);
                at++;
            }
        }
        return results;
    }

    /** The first bytes of a packet that has begun, as far as they are here; they may be damaged. */
    public Bytes begun(int most) {
        return begun ? Bytes.owning(Arrays.copyOf(decoded, Math.min(length, most))) : Bytes.EMPTY;
    }

    /** Whether what has begun can be a packet: it is not too long, and no text so far. */
    public boolean packetComes() {
        return begun && textLength < rawLength && rawLength < raw.length;
    }

    /**
     * Forgets a packet that has begun and is not expected to end.
     *
     * @return whether there was one.
     */
    public boolean abandon() {
        boolean abandoned = begun;
        restart();
        return abandoned;
    }

    /** The end of a block's data, if nothing is damaged: at the limit, or else before a zero. */
    private static int endOfData(byte[] bytes, int from, int limit) {
        int end = from;
        while (end < limit && bytes[end] != 0) {
            end++;
        }
        return end;
    }

    /** Takes a byte that is no data: the end of a packet, or the code of a block. */
    private void accept(int value, List<Result> results) {
        if (value == 0) {
            close(results);
            restart();
        } else {
            if (begun && withZero) {
                keep(ZERO, 0, 1);
            }
            begun = true;
            missing = value - 1;
            withZero = value != Cobs.FULL_BLOCK;
        }
    }

    private void keep(byte[] bytes, int from, int count) {
        int kept = Math.min(count, decoded.length - length);
        System.arraycopy(bytes, from, decoded, length, kept);
        length += kept;
    }

    private void keepRaw(byte[] bytes, int from, int end, List<Result> results) {
        if (textLength == rawLength && textLength >= LONGEST_TEXT) {
            textTold = print(text(), results) || textTold;
            rawLength = 0;
            textLength = 0;
        }
        int kept = Math.min(end - from, raw.length - rawLength);
        System.arraycopy(bytes, from, raw, rawLength, kept);
        boolean wasText = textLength == rawLength;
        rawLength += kept;
        while (wasText && textLength < rawLength && isText(raw[textLength])) {
            textLength++;
        }
    }

    private static boolean isText(byte next) {
        return next < 0 || next >= ' ' && next != DELETE || next == '\t' || next == '\r' || next == '\n';
    }

    private Optional<String> text() {
        try {
            return textLength < SHORTEST_TEXT && !textTold ? Optional.empty()
                    : Optional.of(Bytes.copyOf(raw).slice(0, textLength).text().strip());
        } catch (ProtocolException e) {
            return Optional.empty();
        }
    }

    private static boolean print(Optional<String> text, List<Result> results) {
        text.filter(some -> !some.isEmpty()).ifPresent(some -> results.add(new Printed(some)));
        return text.isPresent();
    }

    private void close(List<Result> results) {
        if (length == 0 && missing == 0) {
            results.add(new Empty(begun));
            return;
        }
        try {
            if (missing > 0) {
                throw new ProtocolException(ProtocolError.BAD_COBS,
                        "the packet ends " + missing + " bytes before its block does");
            }
            results.add(new Found(SerialPacket.decode(Bytes.owning(Arrays.copyOf(decoded, length)))));
        } catch (ProtocolException e) {
            Optional<String> text = text();
            Result rest = text.isEmpty() ? new Refused(e) : behindText();
            if (rest instanceof Refused) {
                results.add(new Refused(e));
            } else {
                print(text, results);
                results.add(rest);
            }
        }
    }

    /** A packet follows a text without a zero between if a sketch prints before a reply. */
    private Result behindText() {
        byte[] rest = Arrays.copyOfRange(raw, textLength, rawLength + 1);
        rest[rest.length - 1] = 0;
        return new PacketDecoder().feed(rest, rest.length).get(0);
    }

    private void restart() {
        length = 0;
        begun = false;
        missing = 0;
        rawLength = 0;
        textLength = 0;
        textTold = false;
    }
}
