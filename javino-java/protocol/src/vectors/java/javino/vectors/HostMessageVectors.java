package javino.vectors;

import static javino.vectors.Vectors.vector;
import static javino.vectors.Wire.bytes;
import static javino.vectors.Wire.join;

import java.util.List;
import java.util.Map;

/** SPEC 3.1: each kind of host message, then what is none. */
final class HostMessageVectors {

    private static final List<String> KINDS = List.of("MESSAGE_1", "MESSAGE_2", "MESSAGE_3", "RENEWAL_1", "RENEWAL_2",
            "RENEWAL_3", "WANT", "GROUP", "CONTENT", "SEQUENCES", "REVOCATION_LIST", "GROUP_KEY", "MOVE_OFFER",
            "MOVE_WANT", "MOVE_DATA", "MOVE_READY", "MOVE_GO", "MOVE_AWAKE", "MOVE_CANCELLED", "MOVE_REFUSED",
            "GROUP_KEY_REQUEST");
    private static final int LONGEST = 493;

    private HostMessageVectors() {
    }

    static Map<String, List<Map<String, Object>>> all() {
        var lists = Vectors.lists("valid", List.of(
                broadcast("MESSAGE_1", "SUPO", 0, counting(37)), broadcast("MESSAGE_2", "SUPO", 0, counting(62)),
                broadcast("MESSAGE_2", "SUPO", 1, counting(26)), broadcast("MESSAGE_3", "ROMA", 0, counting(63)),
                broadcast("RENEWAL_1", "ROMA", 0, counting(16)), broadcast("RENEWAL_2", "ROMA", 0, counting(16)),
                broadcast("RENEWAL_3", "ROMA", 0, counting(8)), broadcast("WANT", "ROMA", 0, bytes(0x81, 1)),
                broadcast("GROUP", "//SU", 0, bytes()),
                unicast("CONTENT", join(bytes(0, 1, 2), Wire.text("tell;help"))),
                unicast("CONTENT", join(bytes(0, 1, 2), Wire.text("tell;" + "x".repeat(LONGEST - 8)))),
                unicast("SEQUENCES", bytes(9, 1, 0, 8, 0, 2)),
                unicast("REVOCATION_LIST", join(bytes(9, 0, 3, 0x50, 1, 0x50, 2, 0, 7, 1, 0), counting(64))),
                unicast("GROUP_KEY", counting(16)),
                unicast("MOVE_OFFER", join(bytes(1, 2, 3, 4, 'm', 1), counting(8), bytes(0, 1, 2, 0, 3, 4),
                        counting(8), Wire.text("SUPObus"))),
                unicast("MOVE_WANT", bytes(1, 2, 3, 4, 0, 0, 7, 0, 1, 0)),
                unicast("MOVE_DATA", join(bytes(1, 2, 3, 4, 1, 0, 1, 0), counting(480))),
                unicast("MOVE_READY", bytes(1, 2, 3, 4)), unicast("MOVE_GO", bytes(1, 2, 3, 4)),
                unicast("MOVE_AWAKE", join(bytes(1, 2, 3, 4), Wire.text("bus_1"))),
                unicast("MOVE_CANCELLED", bytes(1, 2, 3, 4)),
                unicast("MOVE_REFUSED", join(bytes(1, 2, 3, 4), Wire.text("lacks .fly"))),
                unicast("GROUP_KEY_REQUEST", bytes())));
        lists.put("invalid", List.of(
                invalid(bytes(0x80, 0, 0), "no addressee"), invalid(plain(0x80, counting(36)), "a byte is missing"),
                invalid(plain(0x80, counting(38)), "a byte too many"),
                invalid(plain(0x81, bytes()), "no fragment"),
                invalid(plain(0x81, join(bytes(1), counting(62))), "another fragment's length"),
                invalid(plain(0x81, join(bytes(2), counting(62))), "a third fragment"),
                invalid(plain(0x82, counting(62)), "a byte is missing"),
                invalid(plain(0x87, counting(1)), "a byte too many"), invalid(bytes(0x87), "no addressee"),
                invalid(join(bytes(0x8B), counting(15)), "a byte is missing"),
                invalid(bytes(0x8F, 1, 2, 3), "no number of a move"),
                invalid(bytes(0x90, 1, 2, 3, 4, 5), "a byte too many"),
                invalid(bytes(0x94, 0), "a byte too many"),
                invalid(bytes(0x80 + KINDS.size()), "no kind"), invalid(bytes(0xBF), "no kind")));
        return lists;
    }

    private static byte[] counting(int length) {
        return Wire.counting(length, length);
    }

    private static byte[] plain(int first, byte[] rest) {
        return join(bytes(first), Wire.address("SUPO"), rest);
    }

    private static Map<String, Object> broadcast(String kind, String to, int fragment, byte[] body) {
        byte[] part = kind.equals("MESSAGE_2") ? bytes(fragment) : bytes();
        return vector("kind", kind, "to", to, "fragment", fragment, "body", Wire.hex(body), "hostMessage",
                Wire.hex(join(bytes(0x80 + KINDS.indexOf(kind)), Wire.address(to), part, body)));
    }

    private static Map<String, Object> unicast(String kind, byte[] body) {
        return vector("kind", kind, "to", null, "fragment", 0, "body", Wire.hex(body), "hostMessage",
                Wire.hex(join(bytes(0x80 + KINDS.indexOf(kind)), body)));
    }

    private static Map<String, Object> invalid(byte[] bytes, String why) {
        return vector("hostMessage", Wire.hex(bytes), "error", "BAD_HOST_MESSAGE", "why", why);
    }
}
