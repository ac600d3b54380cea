package javino.vectors;

import static javino.vectors.Vectors.vector;
import static javino.vectors.Wire.bytes;
import static javino.vectors.Wire.counting;
import static javino.vectors.Wire.crc;
import static javino.vectors.Wire.frame;
import static javino.vectors.Wire.join;
import static javino.vectors.Wire.repeated;
import static javino.vectors.Wire.text;

import java.util.List;
import java.util.Map;

/** SPEC 6: packets to the bit. */
public final class RadioVectors {

    /** Each nibble's symbol as its six bits in the order they are sent. */
    private static final String[] SYMBOLS = {
            "101100", "011100", "110010", "101010", "011010", "100110", "010110", "001110",
            "110001", "101001", "011001", "100101", "010101", "001101", "010011", "001011"
    };
    /** Six times 2A, then 38 and 2C. */
    private static final String START = "010101".repeat(6) + "000111" + "001101";

    /** The trailer's: the symbol 16 is 07. */
    private static final String[] TRAILER_SYMBOLS = {
            "101100", "011100", "110010", "101010", "111000", "100110", "010110", "001110",
            "110001", "101001", "011001", "100101", "010101", "001101", "010011", "001011"
    };
    private static final int MARK = 0x78;
    private static final int PARITY = 0x87;

    private RadioVectors() {
    }

    static Map<String, List<Map<String, Object>>> all() {
        byte[] frame = frame("////", "ROMA", text("tell;help"));
        byte[] packet = packet(frame);
        var lists = Vectors.lists("packets", List.of(
                valid(frame), valid(frame("////", "CAFE", text("Hello!"))), valid(bytes(0)), valid(bytes(0xFF)),
                valid(bytes(0x01, 0x23, 0x45, 0x67, 0x89, 0xAB, 0xCD, 0xEF)), valid(repeated(0, 77)),
                valid(counting(0xB0, 77))));
        lists.put("invalid", List.of(
                invalid(START + code(change(packet, 5)), "a byte was changed: wrong checksum"),
                invalid(START + code(change(packet, packet.length - 1)), "the checksum was changed"),
                invalid(START + code(copied(packet, 20)), "a checksum of path 20, which is none"),
                invalid(START + code(change(packet, 0)), "the count was changed"),
                invalid(START + code(counted(3, new byte[0])), "count 3: no payload"),
                invalid(START + code(counted(0, new byte[0])), "count 0"),
                invalid(START + code(counted(81, repeated(1, 78))), "count 81: 78 bytes of payload"),
                invalid(START + code(counted(255, repeated(1, 252))), "count 255"),
                invalid(START + code(packet).substring(0, 60) + "000000" + code(packet).substring(66),
                        "symbol 00 is not in the table"),
                invalid(START + "111111" + code(packet).substring(6), "symbol 3F is not in the table"),
                invalid(START + code(packet).substring(0, code(packet).length() - 12), "cut off a byte before its end"),
                invalid("010101".repeat(6) + "111001" + "101101" + code(packet), "no start symbol")));
        byte[] unicast = frame("SUPO", "ROMA", counting(0, 20));
        byte[] acknowledgement = frame("+KAB", "SUPO", counting(9, 8));
        lists.put("copies", List.of(copy(unicast, 1), copy(unicast, 2), copy(unicast, 3), copy(unicast, 4),
                copy(acknowledgement, 1), copy(acknowledgement, 19), copy(repeated(0, 77), 12),
                copy(counting(0xB0, 77), 14)));
        lists.put("trailers", List.of(
                trailed(frame, bytes(MARK)), trailed(frame, parity(packet)),
                trailed(repeated(0, 77), parity(packet(repeated(0, 77)))),
                trailed(counting(0xB0, 77), parity(packet(counting(0xB0, 77)))),
                // All bytes there are.
                trailed(bytes(0), bytes(MARK)), trailed(bytes(0), counting(0, 128)),
                trailed(bytes(0), counting(128, 128))));
        return lists;
    }

    private static byte[] parity(byte[] packet) {
        return join(bytes(PARITY), ParityVectors.of(packet));
    }

    private static Map<String, Object> valid(byte[] payload) {
        return vector("payload", Wire.hex(payload), "bits", bits(payload));
    }

    private static Map<String, Object> copy(byte[] payload, int path) {
        return vector("payload", Wire.hex(payload), "path", path, "bits", START + code(copied(packet(payload), path)));
    }

    /** A packet with another checksum: that of a copy with this path. */
    private static byte[] copied(byte[] packet, int path) {
        byte[] copied = packet.clone();
        int change = path ^ path << 4 ^ path << 11;
        copied[packet.length - 2] ^= (byte) change;
        copied[packet.length - 1] ^= (byte) (change >> 8);
        return copied;
    }

    private static Map<String, Object> trailed(byte[] payload, byte[] trailer) {
        return vector("payload", Wire.hex(payload), "trailer", Wire.hex(trailer), "bits",
                bits(payload) + code(trailer, TRAILER_SYMBOLS));
    }

    private static Map<String, Object> invalid(String bits, String why) {
        return vector("bits", bits, "why", why);
    }

    /** All that the carrier shows of a payload, as text of {@code 0} and {@code 1}, the first sent first. */
    public static String bits(byte[] payload) {
        return START + code(packet(payload));
    }

    /** Count, payload and checksum. */
    public static byte[] packet(byte[] payload) {
        return counted(payload.length + 3, payload);
    }

    private static byte[] counted(int count, byte[] payload) {
        byte[] counted = join(bytes(count), payload);
        return join(counted, crc(counted));
    }

    private static byte[] change(byte[] packet, int index) {
        byte[] changed = packet.clone();
        changed[index] ^= 0x04;
        return changed;
    }

    private static String code(byte[] packet) {
        return code(packet, SYMBOLS);
    }

    private static String code(byte[] bytes, String[] symbols) {
        StringBuilder bits = new StringBuilder();
        for (byte value : bytes) {
            bits.append(symbols[value >> 4 & 0xF]).append(symbols[value & 0xF]);
        }
        return bits.toString();
    }
}
