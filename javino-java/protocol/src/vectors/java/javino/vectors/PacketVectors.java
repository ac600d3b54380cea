package javino.vectors;

import static javino.vectors.Vectors.vector;
import static javino.vectors.Wire.bytes;
import static javino.vectors.Wire.close;
import static javino.vectors.Wire.counting;
import static javino.vectors.Wire.crc;
import static javino.vectors.Wire.frame;
import static javino.vectors.Wire.join;
import static javino.vectors.Wire.packet;
import static javino.vectors.Wire.repeated;
import static javino.vectors.Wire.text;

import java.util.List;
import java.util.Map;

/** SPEC 4.1: zeros everywhere, blocks of COBS at their edges, and each error. */
final class PacketVectors {

    private static final byte[] HELLO = frame("++++", "++++", bytes('H', 1));

    private PacketVectors() {
    }

    static Map<String, List<Map<String, Object>>> all() {
        var lists = Vectors.lists("valid", List.of(
                valid(0, HELLO),
                valid(5, frame("////", "CAFE", text("Hello!"))),
                valid(255, frame("AAAA", "AAAA", new byte[0])),
                valid(1, frame("++++", "++++", bytes(0))),
                valid(2, frame("CAFE", "ROMA", repeated(0, 20))),
                valid(3, frame("CAFE", "ROMA", repeated(0, 511))),
                // Sequence, header and checksum are 13 bytes; 241 more make one full block without a zero.
                valid(4, frame("CAFE", "ROMA", repeated(0x11, 240))),
                valid(4, frame("CAFE", "ROMA", repeated(0x11, 241))),
                valid(4, frame("CAFE", "ROMA", repeated(0x11, 242))),
                valid(4, frame("CAFE", "ROMA", repeated(0x11, 243))),
                valid(6, frame("CAFE", "ROMA", join(repeated(0x22, 243), bytes(0)))),
                valid(7, frame("CAFE", "ROMA", join(repeated(0x22, 243), bytes(0, 0, 1)))),
                valid(8, frame("CAFE", "ROMA", repeated(0xFF, 495))),
                valid(9, frame("CAFE", "ROMA", repeated(0xFF, 511))),
                valid(10, frame("CAFE", "ROMA", counting(0, 511)))));
        byte[] good = join(bytes(7), HELLO);
        lists.put("invalid", List.of(
                invalid(bytes(2, 0), "BAD_COBS"),
                invalid(bytes(255, 1, 2, 3, 0), "BAD_COBS"),
                invalid(join(bytes(20), text("++++++++AQ"), bytes(0)), "BAD_COBS"),
                invalid(bytes(1, 1, 1, 0), "TOO_SHORT"),
                invalid(packet(5, text("////CAFEA")), "TOO_SHORT"),
                invalid(packet(5, frame("CAFE", "ROMA", repeated(1, 512))), "TOO_LONG"),
                invalid(close(repeated(1, 525)), "TOO_LONG"),
                invalid(close(join(good, crc(HELLO))), "BAD_CRC"),
                invalid(close(join(bytes(8), HELLO, crc(good))), "BAD_CRC"),
                invalid(close(join(good, swapped(crc(good)))), "BAD_CRC"),
                invalid(close(repeated(0, 13)), "BAD_CRC"),
                invalid(packet(0, text("*///CAFEAA")), "BAD_DIGIT"),
                invalid(packet(0, text("////CAFEAB")), "PARTIAL_BYTE"),
                invalid(packet(0, text("////CAFEAwHello")), "SIZE_MISMATCH"),
                invalid(packet(0, text("++++////AIx")), "BAD_ORIGIN")));
        return lists;
    }

    private static byte[] swapped(byte[] two) {
        return bytes(two[1], two[0]);
    }

    private static Map<String, Object> valid(int sequence, byte[] frame) {
        return vector("sequence", sequence, "frame", Wire.hex(frame), "packet", Wire.hex(packet(sequence, frame)));
    }

    private static Map<String, Object> invalid(byte[] packet, String error) {
        return vector("packet", Wire.hex(packet), "error", error);
    }
}
