package javino.vectors;

import static javino.vectors.Vectors.vector;

import java.util.Arrays;
import java.util.List;
import java.util.Map;

/** SPEC 5.2: what is derived of a key. */
final class KeyVectors {

    private KeyVectors() {
    }

    static Map<String, List<Map<String, Object>>> all() {
        return Vectors.lists("derivations", List.of(
                derivation("00000000000000000000000000000000"),
                derivation("ffffffffffffffffffffffffffffffff"),
                derivation("000102030405060708090a0b0c0d0e0f"),
                derivation("2b7e151628aed2a6abf7158809cf4f3c"),
                derivation("8f3d5c7ae1b20946d7c85bf01a2e6934")));
    }

    private static Map<String, Object> derivation(String hex) {
        byte[] key = Wire.unhex(hex);
        return vector("key", hex, "kenc", Wire.hex(Crypto.kdf(key, "JavinoEnc")),
                "kmac", Wire.hex(Crypto.kdf(key, "JavinoMac")),
                "check", Wire.hex(Arrays.copyOf(Crypto.kdf(key, "JavinoChk"), 3)));
    }
}
