package capture;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import javino.protocol.Bytes;

/**
 * Writes a pcapng file (draft-ietf-opsawg-pcapng): its section header at once, then interfaces and packets as they
 * come. Each is flushed, so that a program that reads along sees it.
 */
final class Pcapng implements AutoCloseable {

    /** LINKTYPE_USER0: packets of the air, each an {@link AirPacket#record}. */
    static final int AIR = 147;

    private static final int SECTION_HEADER = 0x0A0D0D0A;
    private static final int BYTE_ORDER_MAGIC = 0x1A2B3C4D;
    private static final int INTERFACE_DESCRIPTION = 1;
    private static final int ENHANCED_PACKET = 6;

    private static final int APPLICATION = 4;
    private static final int NAME = 2;
    private static final int DESCRIPTION = 3;
    private static final int MOST_BYTES_OF_AN_OPTION = 1000;
    private static final int WORD = 4;
    private static final int BLOCK_OVERHEAD = 12;

    private final OutputStream out;
    private int interfaces;

    /** @param application the program that writes the file. */
    Pcapng(OutputStream out, String application) throws IOException {
        this.out = out;
        Block block = new Block(SECTION_HEADER);
        block.body.putInt(BYTE_ORDER_MAGIC).putShort((short) 1).putShort((short) 0).putLong(-1);
        block.option(APPLICATION, application);
        block.write();
    }

    /**
     * Adds an interface, whose time stamps are in microseconds.
     *
     * @return its number.
     */
    int addInterface(int linkType, String name, String description) throws IOException {
        Block block = new Block(INTERFACE_DESCRIPTION);
        block.body.putShort((short) linkType).putShort((short) 0).putInt(0);
        block.option(NAME, name);
        block.option(DESCRIPTION, description);
        block.write();
        return interfaces++;
    }

    /** @param micros when, in microseconds since 1970-01-01T00:00Z. */
    void packet(int number, long micros, Bytes packet) throws IOException {
        Block block = new Block(ENHANCED_PACKET);
        block.body.putInt(number).putInt((int) (micros >>> Integer.SIZE)).putInt((int) micros)
                .putInt(packet.length()).putInt(packet.length()).put(packet.toArray());
        block.write();
    }

    @Override
    public void close() throws IOException {
        out.close();
    }

    /** A block: type, length, body, filled up to whole words, and the length once more. */
    private final class Block {

        private final int type;
        private final ByteBuffer body = ByteBuffer.allocate(1 << 13).order(ByteOrder.LITTLE_ENDIAN);

        Block(int type) {
            this.type = type;
        }

        void option(int code, String text) {
            byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
            int length = Math.min(bytes.length, MOST_BYTES_OF_AN_OPTION);
            body.putShort((short) code).putShort((short) length).put(bytes, 0, length);
            fill();
        }

        private void fill() {
            while (body.position() % WORD != 0) {
                body.put((byte) 0);
            }
        }

        void write() throws IOException {
            fill();
            int length = body.position() + BLOCK_OVERHEAD;
            ByteBuffer block = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
            block.putInt(type).putInt(length).put(body.flip()).putInt(length);
            out.write(block.array());
            out.flush();
        }
    }
}
