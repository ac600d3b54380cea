package javino.vectors;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Base64;
import java.util.HexFormat;

/** Frames and packets, written straight from SPEC 1, 2 and 4.1. */
final class Wire {

    private Wire() {
    }

    static String hex(byte[] bytes) {
        return HexFormat.of().formatHex(bytes);
    }

    static byte[] unhex(String hex) {
        return HexFormat.of().parseHex(hex);
    }

    static byte[] text(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    /** The values as bytes. */
    static byte[] bytes(int... values) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        for (int value : values) {
            bytes.write(value);
        }
        return bytes.toByteArray();
    }

    static byte[] join(byte[]... parts) {
        ByteArrayOutputStream joined = new ByteArrayOutputStream();
        for (byte[] part : parts) {
            joined.writeBytes(part);
        }
        return joined.toByteArray();
    }

    /** SPEC 1: the 24 bits of an address's four digits, which are those of Base64. */
    static byte[] address(String text) {
        return Base64.getDecoder().decode(text);
    }

    /** Bytes that count up from a first one, so many. */
    static byte[] counting(int first, int length) {
        byte[] bytes = new byte[length];
        for (int i = 0; i < length; i++) {
            bytes[i] = (byte) (first + i);
        }
        return bytes;
    }

    /** The same byte, so many times. */
    static byte[] repeated(int value, int length) {
        byte[] bytes = new byte[length];
        Arrays.fill(bytes, (byte) value);
        return bytes;
    }

    /** A number of 12 bits, such as a size, as two digits: the first two of its Base64 form. */
    static String digits(int number) {
        byte[] twelve = bytes(number >> 4, number << 4, 0);
        return Base64.getEncoder().encodeToString(twelve).substring(0, 2);
    }

    static byte[] frame(String destination, String origin, byte[] message) {
        return join(text(destination + origin + digits(8 * message.length)), message);
    }

    /** CRC-16/X-25 by the textbook: reflect, divide by the unreflected polynomial, reflect back, complement. */
    static byte[] crc(byte[] bytes) {
        int rest = 0xFFFF;
        for (byte value : bytes) {
            rest ^= Integer.reverse(value & 0xFF) >>> 24 << 8;
            for (int i = 0; i < 8; i++) {
                rest = (rest & 0x8000) != 0 ? (rest << 1 ^ 0x1021) & 0xFFFF : rest << 1;
            }
        }
        int crc = Integer.reverse(rest) >>> 16 ^ 0xFFFF;
        return bytes(crc & 0xFF, crc >> 8);
    }

    /** COBS as its paper describes it, without the empty block after a full one at the end. */
    static byte[] cobs(byte[] plain) {
        ByteArrayOutputStream coded = new ByteArrayOutputStream();
        ByteArrayOutputStream block = new ByteArrayOutputStream();
        boolean pending = true;
        for (byte value : plain) {
            pending = true;
            if (value != 0) {
                block.write(value);
            }
            if (value == 0 || block.size() == 254) {
                // A full block stands for no zero, so that nothing need follow it.
                pending = value == 0;
                flush(block, coded);
            }
        }
        if (pending) {
            flush(block, coded);
        }
        return coded.toByteArray();
    }

    private static void flush(ByteArrayOutputStream block, ByteArrayOutputStream coded) {
        coded.write(block.size() + 1);
        coded.writeBytes(block.toByteArray());
        block.reset();
    }

    /** A packet with the closing 0x00; the frame may be a bad one. */
    static byte[] packet(int sequence, byte[] frame) {
        byte[] body = join(bytes(sequence), frame);
        return close(join(body, crc(body)));
    }

    /** COBS and the closing 0x00. */
    static byte[] close(byte[] plain) {
        return join(cobs(plain), bytes(0));
    }
}
