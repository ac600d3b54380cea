package javino.vectors;

import static javino.vectors.Vectors.vector;
import static javino.vectors.Wire.counting;
import static javino.vectors.Wire.frame;
import static javino.vectors.Wire.join;
import static javino.vectors.Wire.repeated;
import static javino.vectors.Wire.text;

import java.util.List;
import java.util.Map;

/** SPEC 2: the paper's example first, then each length at an edge and each error, with ties in the order of checks. */
final class FrameVectors {

    private FrameVectors() {
    }

    static Map<String, List<Map<String, Object>>> all() {
        var lists = Vectors.lists("valid", List.of(
                valid("////", "CAFE", text("Hello!")),
                valid("////", "ROMA", text("tell;help")),
                valid("//SU", "SUPO", text("tell;someoneNeedHelp")),
                valid("SUHO", "SUPP", text("achieve;goTo(12,\"km\")")),
                valid("++++", "++++", text("P\u0001")),
                valid("AAAA", "9///", new byte[0]),
                valid("+FAA", "CAFE", counting(0, 67)),
                valid("CAFE", "ROMA", text("\u00e9\u20ac\ud83d\ude00")),
                valid("CAFE", "ROMA", repeated(0, 1)),
                valid("CAFE", "ROMA", counting(0, 7)),
                valid("CAFE", "ROMA", counting(0, 8)),
                valid("CAFE", "ROMA", repeated(0xFF, 254)),
                valid("CAFE", "ROMA", counting(1, 255)),
                valid("CAFE", "ROMA", counting(0, 256)),
                valid("CAFE", "ROMA", counting(0, 511))));
        lists.put("invalid", List.of(
                invalid(new byte[0], "TOO_SHORT"),
                invalid(text("////CAFEA"), "TOO_SHORT"),
                invalid(text("*///CAFEA"), "TOO_SHORT"),
                invalid(text("///-CAFEAA"), "BAD_DIGIT"),
                invalid(text("////CA=EAA"), "BAD_DIGIT"),
                invalid(text("////CAFE A"), "BAD_DIGIT"),
                invalid(text("////CAFEA*"), "BAD_DIGIT"),
                invalid(join(repeated(0, 1), text("///CAFEAA")), "BAD_DIGIT"),
                invalid(join(text("////CAFEA"), repeated(0xC1, 1)), "BAD_DIGIT"),
                invalid(join(text("////CAFE"), repeated(0xFF, 2)), "BAD_DIGIT"),
                invalid(text("*///CAFEABx"), "BAD_DIGIT"),
                invalid(text("////CAFEAB"), "PARTIAL_BYTE"),
                invalid(text("////CAFEAvHello!"), "PARTIAL_BYTE"),
                invalid(text("////CAFE//"), "PARTIAL_BYTE"),
                invalid(text("////++++AH"), "PARTIAL_BYTE"),
                invalid(text("////CAFEAwHello"), "SIZE_MISMATCH"),
                invalid(text("////CAFEAwHello!!"), "SIZE_MISMATCH"),
                invalid(text("////CAFEAA!"), "SIZE_MISMATCH"),
                invalid(text("////CAFEAI"), "SIZE_MISMATCH"),
                invalid(join(text("CAFEROMA/4"), counting(0, 512)), "SIZE_MISMATCH"),
                invalid(join(text("CAFEROMAAA"), counting(0, 512)), "SIZE_MISMATCH"),
                invalid(text("CAFE////AAx"), "SIZE_MISMATCH"),
                invalid(text("CAFE////AA"), "BAD_ORIGIN"),
                invalid(text("CAFE//SUAwHello!"), "BAD_ORIGIN"),
                invalid(text("CAFE+FAAAA"), "BAD_ORIGIN"),
                invalid(text("CAFE+++/AA"), "BAD_ORIGIN"),
                invalid(text("CAFE/AAAAA"), "BAD_ORIGIN")));
        return lists;
    }

    private static Map<String, Object> valid(String destination, String origin, byte[] message) {
        return vector("destination", destination, "origin", origin, "message", Wire.hex(message),
                "frame", Wire.hex(frame(destination, origin, message)));
    }

    private static Map<String, Object> invalid(byte[] bytes, String error) {
        return vector("bytes", Wire.hex(bytes), "error", error);
    }
}
