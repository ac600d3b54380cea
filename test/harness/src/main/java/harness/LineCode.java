package harness;

import java.io.ByteArrayOutputStream;
import java.util.List;

/**
 * VirtualWire's line code as its definition has it, written for the tests alone: it shares nothing with the
 * library, the firmware or the emulator, so that all of them are checked against it.
 */
public final class LineCode {

    private static final int[] SYMBOLS = {
        0b001101, 0b001110, 0b010011, 0b010101, 0b010110, 0b011001, 0b011010, 0b011100,
        0b100011, 0b100101, 0b100110, 0b101001, 0b101010, 0b101100, 0b110010, 0b110100};
    private static final String PREAMBLE = "010101".repeat(6) + "000111" + "001101";

    private LineCode() { }

    /** Count, payload and CRC of a packet, as they go to the air. */
    public static byte[] packet(byte[] payload) {
        byte[] packet = new byte[payload.length + 3];
        packet[0] = (byte) packet.length;
        System.arraycopy(payload, 0, packet, 1, payload.length);
        int crc = crc(packet, payload.length + 1);
        packet[payload.length + 1] = (byte) crc;
        packet[payload.length + 2] = (byte) (crc >> 8);
        return packet;
    }

    /** CRC-16/X-25, bit by bit. */
    public static int crc(byte[] bytes, int length) {
        int crc = 0xffff;
        for (int i = 0; i < length; i++) {
            for (int bit = 0; bit < 8; bit++) {
                boolean low = ((crc ^ bytes[i] >> bit) & 1) != 0;
                crc >>>= 1;
                if (low) {
                    crc ^= 0x8408;
                }
            }
        }
        return ~crc & 0xffff;
    }

    /** The bits that a transmit pin showed between its first rise and its last fall, {@code bitSeconds} each. */
    public static String bits(List<TraceEvent> pinEvents, double bitSeconds) {
        StringBuilder bits = new StringBuilder();
        for (int i = 0; i + 1 < pinEvents.size(); i++) {
            long count = Math.round((pinEvents.get(i + 1).seconds() - pinEvents.get(i).seconds()) / bitSeconds);
            bits.append(String.valueOf(pinEvents.get(i).number("level")).repeat((int) count));
        }
        return bits.toString();
    }

    /** The payload that a packet's bits hold; fails where a bit is not as the definition says. */
    public static byte[] payload(String bits) {
        // The carrier is off before and after: leading and trailing zeros do not show at the pin.
        String sent = "0" + bits + "0".repeat(12);
        if (!sent.startsWith(PREAMBLE)) {
            throw new AssertionError("no preamble: " + bits);
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        int count = byteAt(sent, 0);
        for (int i = 0; i < count; i++) {
            bytes.write(byteAt(sent, i));
        }
        byte[] packet = bytes.toByteArray();
        int crc = crc(packet, count - 2);
        if ((packet[count - 2] & 0xff) != (crc & 0xff) || (packet[count - 1] & 0xff) != crc >> 8) {
            throw new AssertionError("bad CRC");
        }
        return java.util.Arrays.copyOfRange(packet, 1, count - 2);
    }

    private static int byteAt(String sent, int index) {
        int start = PREAMBLE.length() + 12 * index;
        return nibble(sent.substring(start, start + 6)) << 4 | nibble(sent.substring(start + 6, start + 12));
    }

    private static int nibble(String sixBits) {
        int symbol = Integer.parseInt(new StringBuilder(sixBits).reverse().toString(), 2);
        for (int nibble = 0; nibble < 16; nibble++) {
            if (SYMBOLS[nibble] == symbol) {
                return nibble;
            }
        }
        throw new AssertionError("no symbol: " + sixBits);
    }
}
