package javino.protocol;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Finds packets in the bytes of a serial line, however they are split (SPEC 4.1).
 * What is damaged is refused as one result, and the next packet is found after its 0x00. Not for several threads.
 */
public final class PacketDecoder {

    private static final byte[] ZERO = {0};

    /** One byte more than a packet can have, so that memory is bounded and a long one is still seen. */
    private final byte[] decoded = new byte[SerialPacket.MAX_LENGTH + 1];
    private int length;
    /** Whether a packet has begun; the two below are of its block of COBS, and hold only then. */
    private boolean begun;
    /** Bytes still to come; with none missing, the next byte is a code or the end. */
    private int missing;
    /** Whether a zero follows the block, if another block does. */
    private boolean withZero;

    /** What became of the bytes up to one 0x00. */
    public sealed interface Result {
    }

    /** @param packet found undamaged. */
    public record Found(SerialPacket packet) implements Result {
    }

    /** @param cause why what came before the 0x00 is no packet. */
    public record Refused(ProtocolException cause) implements Result {
    }

    /**
     * Takes bytes from the line.
     *
     * @param bytes read from.
     * @param count the first so many of them count.
     * @return a result for each 0x00 that closed something, in order.
     */
    public List<Result> feed(byte[] bytes, int count) {
        List<Result> results = new ArrayList<>(1);
        int at = 0;
        while (at < count) {
            if (begun && missing > 0 && bytes[at] != 0) {
                int end = endOfData(bytes, at, Math.min(count, at + missing));
                keep(bytes, at, end - at);
                missing -= end - at;
                at = end;
            } else {
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

    /** Where a block's data ends, if nothing is damaged: at the limit, or else before a zero. */
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
            if (begun) {
                results.add(close());
            }
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

    private Result close() {
        try {
            if (missing > 0) {
                throw new ProtocolException(ProtocolError.BAD_COBS,
                        "the packet ends " + missing + " bytes before its block does");
            }
            return new Found(SerialPacket.decode(Bytes.owning(Arrays.copyOf(decoded, length))));
        } catch (ProtocolException e) {
            return new Refused(e);
        }
    }

    private void restart() {
        length = 0;
        begun = false;
    }
}
