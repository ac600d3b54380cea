package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.google.gson.JsonObject;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class CryptoTest {

    private static final VectorFile NIST = new VectorFile("nist.json");
    private static final VectorFile KEYS = new VectorFile("keys.json");
    private static final VectorFile ENVELOPES = new VectorFile("envelopes.json");

    static Stream<JsonObject> aes() {
        return NIST.list("aes");
    }

    static Stream<JsonObject> cfb() {
        return NIST.list("cfb128");
    }

    static Stream<JsonObject> cmac() {
        return NIST.list("cmac");
    }

    static Stream<JsonObject> derivations() {
        return KEYS.list("derivations");
    }

    static Stream<JsonObject> sealed() {
        return ENVELOPES.list("valid");
    }

    static Stream<JsonObject> notSealed() {
        return ENVELOPES.list("invalid");
    }

    private static Key keyOf(JsonObject vector) {
        return Key.ofHex(VectorFile.text(vector, "key"));
    }

    @ParameterizedTest
    @MethodSource("aes")
    void encrypt_nistVector_givesItsCiphertext(JsonObject vector) {
        assertEquals(VectorFile.bytes(vector, "ciphertext"),
                Aes.encrypt(VectorFile.bytes(vector, "key"), VectorFile.bytes(vector, "plaintext")));
    }

    @ParameterizedTest
    @MethodSource("cfb")
    void cfb_nistVectorCutAnywhere_givesItsCiphertextAndBack(JsonObject vector) {
        Bytes key = VectorFile.bytes(vector, "key");
        Bytes iv = VectorFile.bytes(vector, "iv");
        Bytes plain = VectorFile.bytes(vector, "plaintext");
        Bytes cipher = VectorFile.bytes(vector, "ciphertext");
        for (int length = 0; length <= plain.length(); length++) {
            assertEquals(cipher.slice(0, length), Aes.cfbEncrypt(key, iv, plain.slice(0, length)));
            assertEquals(plain.slice(0, length), Aes.cfbDecrypt(key, iv, cipher.slice(0, length)));
        }
    }

    @ParameterizedTest
    @MethodSource("cmac")
    void cmac_nistVector_givesItsTag(JsonObject vector) {
        assertEquals(VectorFile.bytes(vector, "tag"),
                Aes.cmac(VectorFile.bytes(vector, "key"), VectorFile.bytes(vector, "message")));
    }

    @ParameterizedTest
    @MethodSource("derivations")
    void derive_vector_givesItsKeys(JsonObject vector) {
        assertEquals(VectorFile.bytes(vector, "kenc"), keyOf(vector).encryption());
        assertEquals(VectorFile.bytes(vector, "kmac"), keyOf(vector).authentication());
        assertEquals(VectorFile.bytes(vector, "check"), keyOf(vector).check());
    }

    @ParameterizedTest
    @MethodSource("sealed")
    void seal_vector_givesItsFrame(JsonObject vector) {
        Bytes nonce = VectorFile.bytes(vector, "nonce");
        Frame frame = Envelope.seal(keyOf(vector), VectorFile.address(vector, "origin"),
                VectorFile.address(vector, "destination"),
                new Nonce((int) nonce.number(0, 3), (int) nonce.number(3, 6)), VectorFile.bytes(vector, "content"));
        assertEquals(VectorFile.bytes(vector, "frame"), frame.encode());
    }

    @ParameterizedTest
    @MethodSource("sealed")
    void open_vector_givesItsContent(JsonObject vector) throws ProtocolException {
        Envelope.Opened opened = Envelope.open(keyOf(vector), Frame.decode(VectorFile.bytes(vector, "frame")));
        assertEquals(VectorFile.bytes(vector, "content"), opened.content());
        assertEquals(VectorFile.bytes(vector, "nonce"), opened.nonce());
    }

    @ParameterizedTest
    @MethodSource("notSealed")
    void open_invalidVector_throwsBadTag(JsonObject vector) throws ProtocolException {
        Frame frame = Frame.decode(VectorFile.bytes(vector, "frame"));
        assertEquals(ProtocolError.BAD_TAG,
                assertThrows(ProtocolException.class, () -> Envelope.open(keyOf(vector), frame)).error());
    }

    @Test
    void open_anyBitChanged_throws() {
        Key key = Key.ofHex("000102030405060708090a0b0c0d0e0f");
        byte[] good = Envelope.seal(key, Address.parse("ROMA"), Address.parse("SUPO"), new Nonce(1, 2),
                Bytes.ofText("tell;helpComing")).encode().toArray();
        for (int bit = 0; bit < 8 * good.length; bit++) {
            byte[] changed = good.clone();
            changed[bit / 8] ^= (byte) (1 << bit % 8);
            Bytes bytes = Bytes.copyOf(changed);
            assertThrows(ProtocolException.class, () -> Envelope.open(key, Frame.decode(bytes)), "bit " + bit);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "00", "zz0102030405060708090a0b0c0d0e0f", "000102030405060708090a0b0c0d0e0f10"})
    void ofHex_noKey_throwsWithoutRepeatingIt(String hex) {
        Exception e = assertThrows(IllegalArgumentException.class, () -> Key.ofHex(hex));
        assertEquals("a key is written as 32 hexadecimal digits", e.getMessage());
    }

    @Test
    void nonce_outOfRange_throws() {
        assertThrows(IllegalArgumentException.class, () -> new Nonce(0xFFFFFF, 0));
        assertThrows(IllegalArgumentException.class, () -> new Nonce(0, 0x1000000));
        assertThrows(IllegalArgumentException.class, () -> new Nonce(-1, 0));
    }
}
