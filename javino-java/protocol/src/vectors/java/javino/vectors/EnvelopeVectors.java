package javino.vectors;

import static javino.vectors.Vectors.vector;
import static javino.vectors.Wire.bytes;
import static javino.vectors.Wire.counting;
import static javino.vectors.Wire.join;
import static javino.vectors.Wire.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/** SPEC 5: sealed frames of all lengths about a block, and frames that must not open. */
final class EnvelopeVectors {

    private static final String KEY = "000102030405060708090a0b0c0d0e0f";
    private static final String OTHER_KEY = "2b7e151628aed2a6abf7158809cf4f3c";
    private static final int HEADER_LENGTH = 10;

    private EnvelopeVectors() {
    }

    static Map<String, List<Map<String, Object>>> all() {
        List<Map<String, Object>> valid = new ArrayList<>(List.of(
                valid(KEY, "SUPO", "//SU", "000001000000", text("tell;someoneNeedHelp")),
                valid(KEY, "SUPP", "SUHO", "000001000001", text("tell;someoneNeedHelp")),
                valid(OTHER_KEY, "SUPP", "SUHO", "fffffeffffff", text("achieve;goTo(12,\"km\")")),
                valid(KEY, "ROMA", "SUPO", "000000000000", text("tell;\u00e9\u20ac\ud83d\ude00")),
                valid(KEY, "AAAA", "9///", "123456abcdef", counting(0, 494))));
        for (int length : new int[] {0, 1, 15, 16, 17, 31, 32, 33, 47, 48, 49, 53}) {
            valid.add(valid(KEY, "ROMA", "SUPO", "000002" + String.format("%06x", length), counting(0x61, length)));
        }
        var lists = Vectors.lists("valid", valid);
        lists.put("invalid", invalid());
        return lists;
    }

    private static List<Map<String, Object>> invalid() {
        byte[] good = seal(KEY, "SUPO", "//SU", Wire.unhex("000001000000"), text("tell;help"));
        List<Map<String, Object>> invalid = new ArrayList<>();
        // One changed bit in destination, origin, nonce, content and tag; the header keeps its form.
        for (int at : new int[] {3, 7, 10, 15, 16, good.length - 9, good.length - 8, good.length - 1}) {
            byte[] changed = good.clone();
            changed[at] ^= 1;
            invalid.add(invalid(KEY, changed, "byte " + at + " was changed"));
        }
        invalid.add(invalid(OTHER_KEY, good, "sealed with another key"));
        invalid.add(invalid(KEY, shortened(good, 1), "the tag's last byte is missing"));
        invalid.add(invalid(KEY, Wire.frame("//SU", "SUPO", counting(0, 13)), "13 bytes are too short"));
        invalid.add(invalid(KEY, Wire.frame("//SU", "SUPO", new byte[0]), "no message"));
        invalid.add(invalid(KEY, Wire.frame("//SU", "SUPO", text("tell;not sealed")), "plain"));
        return invalid;
    }

    private static byte[] shortened(byte[] frame, int bytes) {
        return Wire.frame("//SU", "SUPO", Arrays.copyOfRange(frame, HEADER_LENGTH, frame.length - bytes));
    }

    private static byte[] iv(String key, String origin, String destination, byte[] nonce) {
        return Crypto.aes(encryptionKey(key), join(text(origin), text(destination), nonce, bytes(0, 0)));
    }

    private static byte[] encryptionKey(String key) {
        return Crypto.kdf(Wire.unhex(key), "JavinoEnc");
    }

    static byte[] authenticationKey(String key) {
        return Crypto.kdf(Wire.unhex(key), "JavinoMac");
    }

    static byte[] seal(String key, String origin, String destination, byte[] nonce, byte[] content) {
        byte[] cipher = Crypto.cfb(encryptionKey(key), iv(key, origin, destination, nonce), content);
        String size = Wire.digits(8 * (6 + content.length + 8));
        byte[] signed = join(text(destination + origin + size), nonce, cipher);
        return join(signed, Arrays.copyOf(Crypto.cmac(authenticationKey(key), signed), 8));
    }

    private static Map<String, Object> valid(String key, String origin, String destination, String nonceHex,
            byte[] content) {
        byte[] nonce = Wire.unhex(nonceHex);
        return vector("key", key, "kenc", Wire.hex(encryptionKey(key)), "kmac", Wire.hex(authenticationKey(key)),
                "origin", origin, "destination", destination, "nonce", nonceHex,
                "iv", Wire.hex(iv(key, origin, destination, nonce)), "content", Wire.hex(content),
                "frame", Wire.hex(seal(key, origin, destination, nonce, content)));
    }

    private static Map<String, Object> invalid(String key, byte[] frame, String why) {
        return vector("key", key, "frame", Wire.hex(frame), "why", why);
    }
}
