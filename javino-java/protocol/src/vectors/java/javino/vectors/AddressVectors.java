package javino.vectors;

import static javino.vectors.Vectors.vector;

import java.util.Base64;
import java.util.List;
import java.util.Map;

/** SPEC 1: every class and its edges. */
final class AddressVectors {

    private AddressVectors() {
    }

    static Map<String, List<Map<String, Object>>> all() {
        var lists = Vectors.lists("valid", List.of(
                valid("AAAA", "device"), valid("AAAB", "device"), valid("CAFE", "device"), valid("ROMA", "device"),
                valid("SUPO", "device"), valid("SU//", "device"), valid("Zaz0", "device"), valid("a+/9", "device"),
                valid("self", "reserved"), valid("true", "reserved"), valid("else", "reserved"),
                valid("elif", "reserved"), valid("Self", "device"), valid("selF", "device"), valid("sele", "device"),
                valid("9///", "device"), valid("++++", "serial"), valid("+++/", "reserved"),
                valid("+++A", "reserved"), valid("+AAA", "reserved"), valid("+E//", "reserved"),
                valid("+FAA", "fragment"), valid("+F//", "fragment"), valid("+GAA", "reserved"),
                valid("+J//", "reserved"),
                valid("+KAA", "acknowledgement"), valid("+K09", "acknowledgement"),
                valid("+K//", "acknowledgement"), valid("+LAA", "reserved"), valid("+fAA", "reserved"),
                valid("AF++", "device"), valid("/FAA", "reserved"), valid("/KAA", "reserved"),
                valid("+///", "reserved"), valid("/AAA", "reserved"),
                valid("/A//", "reserved"), valid("/+//", "reserved"), valid("/9++", "reserved"),
                valid("//AA", "multicast"), valid("//SU", "multicast"), valid("//++", "multicast"),
                valid("///A", "multicast"), valid("//A/", "multicast"), valid("///+", "multicast"),
                valid("////", "broadcast")));
        lists.put("invalid", List.of(
                invalid("", "no digits"), invalid("A", "one digit"), invalid("CAF", "three digits"),
                invalid("CAFEA", "five digits"), invalid("CAF=", "padding is no digit"),
                invalid("CA-E", "- is of the URL alphabet"), invalid("CA_E", "_ is of the URL alphabet"),
                invalid("CA E", "a space is no digit"), invalid("SU\\\\", "a backslash is no digit"),
                invalid("CAF\u00c9", "\u00c9 is no digit"), invalid("CAF\u0000", "NUL is no digit"),
                invalid("CAF@", "@ comes just before A"), invalid("CAF[", "[ comes just after Z"),
                invalid("CAF`", "` comes just before a"), invalid("CAF{", "{ comes just after z"),
                invalid("CAF:", ": comes just after 9"), invalid("CAF.", ". comes just before /"),
                invalid("CAF,", ", comes just after +"), invalid("CAF*", "* comes just before +")));
        return lists;
    }

    private static Map<String, Object> valid(String text, String kind) {
        return vector("text", text, "value", Wire.hex(Base64.getDecoder().decode(text)), "class", kind,
                "group", text.substring(0, 2), "member", text.substring(2));
    }

    private static Map<String, Object> invalid(String text, String why) {
        return vector("text", text, "why", why);
    }
}
