package javino.vectors;

import static javino.vectors.Vectors.vector;

import java.util.List;
import java.util.Map;

/** The examples of the standards, typed in. */
final class NistVectors {

    private static final String KEY = "2b7e151628aed2a6abf7158809cf4f3c";
    private static final String MESSAGE = "6bc1bee22e409f96e93d7e117393172aae2d8a571e03ac9c9eb76fac45af8e51"
            + "30c81c46a35ce411e5fbc1191a0a52eff69f2445df4f9b17ad2b417be66c3710";

    private NistVectors() {
    }

    static Map<String, List<Map<String, Object>>> all() {
        var lists = Vectors.lists("aes", List.of(
                aes("2b7e151628aed2a6abf7158809cf4f3c", "3243f6a8885a308d313198a2e0370734",
                        "3925841d02dc09fbdc118597196a0b32", "FIPS-197 B"),
                aes("000102030405060708090a0b0c0d0e0f", "00112233445566778899aabbccddeeff",
                        "69c4e0d86a7b0430d8cdb78070b4c55a", "FIPS-197 C.1"),
                aes(KEY, MESSAGE.substring(0, 32), "3ad77bb40d7a3660a89ecaf32466ef97", "SP 800-38A F.1.1"),
                aes(KEY, MESSAGE.substring(32, 64), "f5d3d58503b9699de785895a96fdbaaf", "SP 800-38A F.1.1"),
                aes(KEY, MESSAGE.substring(64, 96), "43b1cd7f598ece23881b00e3ed030688", "SP 800-38A F.1.1"),
                aes(KEY, MESSAGE.substring(96), "7b0c785e27e8ad3f8223207104725dd4", "SP 800-38A F.1.1")));
        lists.put("cfb128", List.of(
                vector("key", KEY, "iv", "000102030405060708090a0b0c0d0e0f", "plaintext", MESSAGE,
                        "ciphertext", "3b3fd92eb72dad20333449f8e83cfb4ac8a64537a0b3a93fcde3cdad9f1ce58b"
                                + "26751f67a3cbb140b1808cf187a4f4dfc04b05357c5d1c0eeac4c66f9ff7f2e6",
                        "source", "SP 800-38A F.3.13 and F.3.14")));
        lists.put("cmac", List.of(
                cmac(0, "bb1d6929e95937287fa37d129b756746", "SP 800-38B D.1 example 1"),
                cmac(16, "070a16b46b4d4144f79bdd9dd04a287c", "SP 800-38B D.1 example 2"),
                cmac(40, "dfa66747de9ae63030ca32611497c827", "SP 800-38B D.1 example 3"),
                cmac(64, "51f0bebf7e3b9d92fc49741779363cfe", "SP 800-38B D.1 example 4")));
        return lists;
    }

    private static Map<String, Object> aes(String key, String plaintext, String ciphertext, String source) {
        return vector("key", key, "plaintext", plaintext, "ciphertext", ciphertext, "source", source);
    }

    private static Map<String, Object> cmac(int length, String tag, String source) {
        return vector("key", KEY, "message", MESSAGE.substring(0, 2 * length), "tag", tag, "source", source);
    }
}
