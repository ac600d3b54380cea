package javino.vectors;

import static javino.vectors.Vectors.vector;
import static javino.vectors.Wire.counting;
import static javino.vectors.Wire.join;
import static javino.vectors.Wire.text;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/** SPEC 7.1: frames of each number of fragments and at each edge, and fragments that no frame has. */
final class FragmentVectors {

    private static final String KEY = "000102030405060708090a0b0c0d0e0f";
    private static final int PART = 67;
    private static final int HEADER = 10;

    private FragmentVectors() {
    }

    static Map<String, List<Map<String, Object>>> all() {
        List<Map<String, Object>> valid = new ArrayList<>(List.of(
                valid(EnvelopeVectors.seal(KEY, "ROMA", "SUPO", Wire.unhex("000001000000"),
                        text("tell;" + "x".repeat(489))), "A"),
                valid(EnvelopeVectors.seal(KEY, "SUPO", "//SU", Wire.unhex("000001000001"),
                        text("tell;" + "y".repeat(195))), "z"),
                valid(Wire.frame("////", "ROMA", text("tell;" + "x".repeat(489))), "/")));
        // The shortest, and each number of fragments with a full, a nearly full and a one-byte last one.
        valid.add(valid(Wire.frame("////", "CAFE", counting(0, 78 - HEADER)), "B"));
        for (int fragments = 2; fragments <= 8; fragments++) {
            for (int total : new int[] {PART * fragments - 1, PART * fragments, PART * fragments + 1}) {
                if (total <= 521) {
                    valid.add(valid(Wire.frame("CAFE", "ROMA", counting(fragments, total - HEADER)), "+"));
                }
            }
        }
        valid.add(valid(Wire.frame("9///", "AAAA", counting(0, 511)), "9"));
        var lists = Vectors.lists("valid", valid);
        lists.put("asking", List.of(asking("A", 0), asking("z", 1), asking("/", 7)));
        lists.put("invalid", invalid());
        return lists;
    }

    /** No fragment asks for an answer. */
    private static Map<String, Object> valid(byte[] frame, String id) {
        List<String> fragments = new ArrayList<>();
        for (int at = 0; at < frame.length; at += PART) {
            byte[] part = Arrays.copyOfRange(frame, at, Math.min(at + PART, frame.length));
            fragments.add(Wire.hex(fragment(id, (char) ('A' + fragments.size()), new String(frame, 4, 4,
                    StandardCharsets.US_ASCII), part)));
        }
        return vector("frame", Wire.hex(frame), "id", id, "fragments", fragments);
    }

    private static byte[] fragment(String id, char index, String origin, byte[] part) {
        return Wire.frame("+F" + id + index, origin, part);
    }

    /** A fragment that wants an answer: its index digit is raised by 8. */
    private static Map<String, Object> asking(String id, int index) {
        byte[] part = index == 0 ? first("SUPO", "ROMA") : counting(index, 20);
        return vector("fragment", Wire.hex(fragment(id, (char) ('A' + index + 8), "ROMA", part)), "origin", "ROMA",
                "id", id, "index", index, "part", Wire.hex(part));
    }

    /** The first 67 bytes of a frame of 100. */
    private static byte[] first(String destination, String origin) {
        return Arrays.copyOf(Wire.frame(destination, origin, counting(0, 90)), PART);
    }

    private static List<Map<String, Object>> invalid() {
        byte[] first = first("SUPO", "ROMA");
        List<Map<String, Object>> invalid = new ArrayList<>(List.of(
                invalid('A', new byte[0], "no bytes"),
                invalid('B', new byte[0], "no bytes"),
                invalid('B', counting(0, 68), "68 bytes"),
                invalid('H', counting(0, 53), "the whole would have 522 bytes"),
                invalid('P', counting(0, 67), "the whole would have 536 bytes"),
                invalid('Q', counting(0, 20), "index digit 16"),
                invalid('/', counting(0, 20), "index digit 63"),
                invalid('A', Arrays.copyOf(first, 66), "first fragment of 66 bytes"),
                invalid('A', Arrays.copyOf(first, 9), "first fragment shorter than a header"),
                invalid('A', Arrays.copyOf(Wire.frame("SUPO", "ROMA", counting(0, 67)), PART),
                        "the whole has 77 bytes and fits a packet"),
                invalid('A', join(text("SUPOROMAAA"), counting(0, 57)), "the whole has no message"),
                invalid('A', join(text("SUPOROMALR"), counting(0, 57)), "the whole's size is no multiple of 8"),
                invalid('A', join(text("SUPOROMAL="), counting(0, 57)), "the whole's size has a bad digit"),
                invalid('A', join(text("SU=OROMALQ"), counting(0, 57)), "the whole's destination has a bad digit"),
                invalid('A', first("SUPO", "ROMB"), "the whole comes from another device"),
                invalid('A', first("+FAA", "ROMA"), "the whole is itself a fragment"),
                invalid('A', first("+KAA", "ROMA"), "the whole goes to where acknowledgements go"),
                invalid('A', first("++++", "ROMA"), "the whole goes to the serial line"),
                invalid('A', first("/AAA", "ROMA"), "the whole goes to a reserved address")));
        invalid.add(vector("fragment", Wire.hex(fragment("A", 'A', "++++", first("SUPO", "++++"))),
                "why", "from the serial line"));
        return invalid;
    }

    private static Map<String, Object> invalid(char index, byte[] part, String why) {
        return vector("fragment", Wire.hex(fragment("A", index, "ROMA", part)), "why", why);
    }
}
