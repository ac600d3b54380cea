package javino.vectors;

import static javino.vectors.Vectors.vector;
import static javino.vectors.Wire.bytes;
import static javino.vectors.Wire.join;
import static javino.vectors.Wire.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/** SPEC 7.3: each kind of answer, and answers that prove nothing. */
final class AcknowledgementVectors {

    private static final String KEY = "000102030405060708090a0b0c0d0e0f";
    private static final String OTHER_KEY = "2b7e151628aed2a6abf7158809cf4f3c";
    private static final String NONCE = "000102030405";
    private static final int DELIVERED = 6;
    private static final int FRAGMENTS = 7;
    private static final int STALE = 8;

    private AcknowledgementVectors() {
    }

    static Map<String, List<Map<String, Object>>> all() {
        var lists = Vectors.lists("valid", List.of(
                delivered(KEY, "SUPO", "ROMA", "000001000000"),
                delivered(OTHER_KEY, "SUPP", "SUHO", "fffffeffffff"),
                delivered(KEY, "AAAA", "9///", "123456abcdef"),
                fragments("SUPO", "ROMA", NONCE, 1),
                fragments("SUPO", "ROMA", NONCE, 3),
                fragments("ROMA", "SUPO", "000001000fff", 0x7F),
                fragments("ROMA", "SUPO", "000001001000", 0xFD),
                stale("SUPO", "ROMA", NONCE, "000102030424", 1234),
                stale("SUPO", "ROMA", "000001000000", "00000100001f", 0),
                stale("SUAM", "SUHO", "fffffe00003f", "ffffffffffff", 0xFFFF)));
        lists.put("invalid", invalid());
        return lists;
    }

    private static byte[] proof(String key, int type, String nonce, String sender, String acknowledger, byte[] body) {
        return Arrays.copyOf(Crypto.cmac(EnvelopeVectors.authenticationKey(key),
                join(bytes(type), Wire.unhex(nonce), text(sender), text(acknowledger), body)), 8);
    }

    /** {@code +K} and the last 12 bits of the nonce. */
    private static String address(String nonce) {
        return "+K" + Wire.digits(Integer.parseInt(nonce.substring(9), 16));
    }

    private static byte[] frame(String key, int type, String nonce, String sender, String acknowledger, byte[] body) {
        return Wire.frame(address(nonce), acknowledger,
                join(body, proof(key, type, nonce, sender, acknowledger, body)));
    }

    private static Map<String, Object> begin(String key, String sender, String acknowledger, String nonce,
            String kind) {
        return vector("key", key, "kmac", Wire.hex(EnvelopeVectors.authenticationKey(key)), "sender", sender,
                "acknowledger", acknowledger, "nonce", nonce, "kind", kind);
    }

    private static Map<String, Object> delivered(String key, String sender, String acknowledger, String nonce) {
        Map<String, Object> vector = begin(key, sender, acknowledger, nonce, "delivered");
        vector.put("frame", Wire.hex(frame(key, DELIVERED, nonce, sender, acknowledger, new byte[0])));
        return vector;
    }

    private static Map<String, Object> fragments(String sender, String acknowledger, String nonce, int bits) {
        Map<String, Object> vector = begin(KEY, sender, acknowledger, nonce, "fragments");
        vector.put("fragments", bits);
        vector.put("frame", Wire.hex(frame(KEY, FRAGMENTS, nonce, sender, acknowledger, bytes(bits))));
        return vector;
    }

    private static Map<String, Object> stale(String sender, String acknowledger, String nonce, String floor,
            int uptime) {
        Map<String, Object> vector = begin(KEY, sender, acknowledger, nonce, "stale");
        vector.put("floor", floor);
        vector.put("uptime", uptime);
        vector.put("frame", Wire.hex(frame(KEY, STALE, nonce, sender, acknowledger, staleBody(floor, uptime))));
        return vector;
    }

    private static byte[] staleBody(String floor, int uptime) {
        return join(Wire.unhex(floor), bytes(uptime >> 8, uptime));
    }

    private static List<Map<String, Object>> invalid() {
        byte[] none = new byte[0];
        byte[] stale = staleBody("000102030424", 1234);
        List<Map<String, Object>> invalid = new ArrayList<>(List.of(
                invalid(frame(OTHER_KEY, DELIVERED, NONCE, "SUPO", "ROMA", none), "another key"),
                invalid(frame(KEY, DELIVERED, NONCE, "SUPP", "ROMA", none), "to another sender"),
                invalid(readdressed(frame(KEY, DELIVERED, NONCE, "SUPO", "SUHO", none), address(NONCE), "ROMA"),
                        "from another acknowledger"),
                invalid(readdressed(frame(KEY, DELIVERED, "100102030405", "SUPO", "ROMA", none), address(NONCE),
                        "ROMA"), "for another nonce with the same last bits"),
                invalid(readdressed(frame(KEY, DELIVERED, NONCE, "SUPO", "ROMA", none), "+KQE", "ROMA"),
                        "the address is of another nonce"),
                invalid(frame(KEY, FRAGMENTS, NONCE, "SUPO", "ROMA", none), "delivered with the type of fragments"),
                invalid(frame(KEY, DELIVERED, NONCE, "SUPO", "ROMA", bytes(3)), "fragments with the type of delivered"),
                invalid(frame(KEY, STALE, NONCE, "SUPO", "ROMA", bytes(3)), "fragments with the type of stale"),
                invalid(frame(KEY, DELIVERED, NONCE, "SUPO", "ROMA", stale), "stale with the type of delivered"),
                invalid(frame(KEY, FRAGMENTS, NONCE, "SUPO", "ROMA", bytes(3, 3)), "10 bytes"),
                invalid(frame(KEY, STALE, NONCE, "SUPO", "ROMA", Arrays.copyOf(stale, 7)), "15 bytes"),
                invalid(frame(KEY, STALE, NONCE, "SUPO", "ROMA", Arrays.copyOf(stale, 9)), "17 bytes"),
                invalid(Wire.frame(address(NONCE), "ROMA", none), "no message"),
                invalid(Wire.frame(address(NONCE), "ROMA",
                        Arrays.copyOf(proof(KEY, DELIVERED, NONCE, "SUPO", "ROMA", none), 7)), "7 bytes"),
                invalid(Wire.frame(address(NONCE), "ROMA", new byte[8]), "a proof of zeros")));
        for (byte[] good : List.of(frame(KEY, DELIVERED, NONCE, "SUPO", "ROMA", none),
                frame(KEY, FRAGMENTS, NONCE, "SUPO", "ROMA", bytes(3)),
                frame(KEY, STALE, NONCE, "SUPO", "ROMA", stale))) {
            for (int at : new int[] {10, good.length - 8, good.length - 1}) {
                byte[] changed = good.clone();
                changed[at] ^= 1;
                invalid.add(invalid(changed, "byte " + at + " of " + good.length + " was changed"));
            }
        }
        return invalid;
    }

    private static byte[] readdressed(byte[] frame, String destination, String origin) {
        return join(text(destination + origin), Arrays.copyOfRange(frame, 8, frame.length));
    }

    private static Map<String, Object> invalid(byte[] frame, String why) {
        return vector("key", KEY, "sender", "SUPO", "acknowledger", "ROMA", "nonce", NONCE, "frame", Wire.hex(frame),
                "why", why);
    }
}
