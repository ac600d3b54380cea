package javino.protocol;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;

/**
 * Finds packets in the bytes of a serial line, however they are split (SPEC 4.1).
 * What is damaged is refused as one result, and the next packet is found after its 0x00. Not for several threads.
 */
public final class PacketDecoder {

    private final ByteArrayOutputStream decoded = new ByteArrayOutputStream();
    private State state = new Between();

    /** What became of the bytes up to one 0x00. */
    public sealed interface Result {
    }

    /** @param packet found undamaged. */
    public record Found(Packet packet) implements Result {
    }

    /** @param cause why what came before the 0x00 is no packet. */
    public record Refused(ProtocolException cause) implements Result {
    }

    private sealed interface State {
    }

    /** After a 0x00: the next byte is the first code of a packet, or another 0x00. */
    private record Between() implements State {
    }

    /**
     * Within a block of COBS.
     *
     * @param missing  bytes still to come; with none missing, the next byte is a code or the end.
     * @param withZero whether a zero follows the block, if another block does.
     */
    private record Block(int missing, boolean withZero) implements State {
    }

    /**
     * Takes bytes from the line.
     *
     * @param bytes  read from.
     * @param length the first so many bytes of it count.
     * @return a result for each 0x00 that closed something, in order.
     */
    public List<Result> feed(byte[] bytes, int length) {
        List<Result> results = new ArrayList<>();
        for (int i = 0; i < length; i++) {
            accept(bytes[i] & 0xFF, results);
        }
        return results;
    }

    /**
     * Forgets a packet that has begun and is not expected to end.
     *
     * @return whether there was one.
     */
    public boolean abandon() {
        boolean begun = state instanceof Block;
        restart();
        return begun;
    }

    private void accept(int value, List<Result> results) {
        if (value == 0) {
            if (state instanceof Block block) {
                results.add(close(block));
            }
            restart();
        } else if (state instanceof Block block && block.missing > 0) {
            keep(value);
            state = new Block(block.missing - 1, block.withZero);
        } else {
            if (state instanceof Block block && block.withZero) {
                keep(0);
            }
            state = new Block(value - 1, value != Cobs.FULL_BLOCK);
        }
    }

    /** Keeps one byte more than a packet can have, so that memory is bounded and a long one is still seen. */
    private void keep(int value) {
        if (decoded.size() <= Packet.MAX_LENGTH) {
            decoded.write(value);
        }
    }

    private Result close(Block block) {
        try {
            if (block.missing > 0) {
                throw new ProtocolException(ProtocolError.BAD_COBS,
                        "the packet ends " + block.missing + " bytes before its block does");
            }
            return new Found(Packet.decode(Bytes.copyOf(decoded.toByteArray())));
        } catch (ProtocolException e) {
            return new Refused(e);
        }
    }

    private void restart() {
        decoded.reset();
        state = new Between();
    }
}
