package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.google.gson.JsonObject;
import java.security.NoSuchAlgorithmException;
import java.security.SecureRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class KeyTest {

    static Stream<JsonObject> derivations() {
        return new VectorFile("keys.json").list("derivations");
    }

    @ParameterizedTest
    @MethodSource("derivations")
    void check_vector_isItsCheckValue(JsonObject vector) {
        assertEquals(VectorFile.bytes(vector, "check"), Key.ofHex(VectorFile.text(vector, "key")).check());
    }

    @Test
    void random_drawnTwice_isTheSourcesAndDiffers() throws NoSuchAlgorithmException {
        SecureRandom source = SecureRandom.getInstance("SHA1PRNG");
        source.setSeed(1);
        SecureRandom same = SecureRandom.getInstance("SHA1PRNG");
        same.setSeed(1);
        Key first = Key.random(source);
        assertEquals(first, Key.random(same));
        assertEquals(first.hashCode(), Key.ofHex(first.bytes().hex()).hashCode());
        assertNotEquals(first, Key.random(source));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "00", "zz0102030405060708090a0b0c0d0e0f", "000102030405060708090a0b0c0d0e0f10"})
    void ofHex_noKey_throwsWithoutRepeatingIt(String hex) {
        Exception e = assertThrows(IllegalArgumentException.class, () -> Key.ofHex(hex));
        assertEquals("a key is written as 32 hexadecimal digits", e.getMessage());
    }
}
