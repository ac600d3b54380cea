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

/** SPEC 6.2: what is given to a serial module, and what a receiver refuses. */
final class ModuleVectors {

    private static final byte[] HELLO = frame("////", "CAFE", text("Hello!"));

    private ModuleVectors() {
    }

    static Map<String, List<Map<String, Object>>> all() {
        var lists = Vectors.lists("valid", List.of(
                valid(0, HELLO),
                valid(1, frame("CAFE", "ROMA", new byte[0])),
                valid(3, frame("CAFE", "ROMA", repeated(0, 20))),
                valid(4, frame("CAFE", "ROMA", counting(0, 42))),
                valid(11, frame("CAFE", "ROMA", counting(0, 67))),
                valid(19, frame("CAFE", "ROMA", repeated(0xFF, 67)))));
        byte[] good = join(bytes(0), HELLO);
        lists.put("invalid", List.of(
                invalid(packet(20, HELLO), "BAD_PATH"),
                invalid(packet(255, HELLO), "BAD_PATH"),
                invalid(packet(0, text("////CAFEA")), "TOO_SHORT"),
                invalid(packet(0, frame("CAFE", "ROMA", repeated(1, 68))), "TOO_LONG"),
                invalid(bytes(2, 0), "BAD_COBS"),
                invalid(join(bytes(20), text("//CAFE"), bytes(0)), "BAD_COBS"),
                invalid(close(join(bytes(1), HELLO, crc(good))), "BAD_CRC"),
                invalid(close(repeated(0, 13)), "BAD_CRC")));
        return lists;
    }

    private static Map<String, Object> valid(int path, byte[] payload) {
        return vector("path", path, "payload", Wire.hex(payload), "sent",
                Wire.hex(join(bytes(0), packet(path, payload))));
    }

    private static Map<String, Object> invalid(byte[] sent, String error) {
        return vector("sent", Wire.hex(join(bytes(0), sent)), "error", error);
    }
}
