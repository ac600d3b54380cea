package keyagreement.edhoc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import javino.protocol.Bytes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class CborTest {

    private static CborReader reader(String hex) {
        return new CborReader(Bytes.ofHex(hex));
    }

    /** Numbers of RFC 8949 appendix A, and at the borders between lengths. */
    @ParameterizedTest
    @CsvSource({"0, 00", "23, 17", "24, 1818", "255, 18ff", "256, 190100", "65535, 19ffff", "65536, 1a00010000",
            "1000000, 1a000f4240", "2147483647, 1a7fffffff", "-1, 20", "-24, 37", "-25, 3818", "-100, 3863",
            "-1000, 3903e7"})
    void number_isWrittenAndReadInItsShortestForm(int number, String hex) throws HandshakeException {
        assertEquals(Bytes.ofHex(hex), Cbor.integer(number));
        CborReader reader = reader(hex);
        assertEquals(number, reader.integer());
        reader.end();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "1800", "1817", "190000", "1900ff", "1a00000000", "1a0000ffff", "1b0000000000000001",
            "1a80000000", "1affffffff", "18", "19", "1901", "1a0000", "1c", "1d", "1e", "1f", "3817", "390017", "40",
            "60", "80", "a0", "c000", "f4", "f6", "f97c00", "ff"})
    void number_ofAnotherForm_isRefused(String hex) {
        assertThrows(HandshakeException.class, () -> reader(hex).integer());
    }

    @Test
    void bytes_ofAnyLength_areWrittenAndRead() throws HandshakeException {
        for (int length : new int[] {0, 1, 23, 24, 42, 255, 256, 1000}) {
            Bytes content = Bytes.copyOf(new byte[length]);
            CborReader reader = new CborReader(Cbor.bytes(content));
            assertEquals(content, reader.bytes());
            reader.end();
        }
        assertEquals("8344010203046449455446a10140", Cbor.array(Cbor.bytes(Bytes.of(1, 2, 3, 4)), Cbor.text("IETF"),
                Cbor.map(Cbor.integer(1), Cbor.bytes(Bytes.EMPTY))).hex());
    }

    @ParameterizedTest
    @ValueSource(strings = {"41", "4201", "5801ff", "5817", "590018", "5a00000001ff", "5affffffff", "5a7fffffff00",
            "5f4101ff", "6161", "8101", "01"})
    void bytes_ofAnotherForm_areRefused(String hex) {
        assertThrows(HandshakeException.class, () -> reader(hex).bytes());
    }

    /** RFC 9528 section 3.3.2. */
    @ParameterizedTest
    @CsvSource({"21, 21", "0e, 0e", "17, 17", "37, 37", "18, 4118", "38, 4138", "ff, 41ff", "'', 40", "0e0e, 420e0e"})
    void identifier_isANumberIfOneEncodesIt(String identifier, String hex) throws HandshakeException {
        assertEquals(Bytes.ofHex(hex), Cbor.identifier(Bytes.ofHex(identifier)));
        assertEquals(Bytes.ofHex(identifier), reader(hex).identifier());
    }

    @ParameterizedTest
    @ValueSource(strings = {"4121", "410e", "4137", "1818", "3818", "6121", "f6", ""})
    void identifier_ofAnotherForm_isRefused(String hex) {
        assertThrows(HandshakeException.class, () -> reader(hex).identifier());
    }

    /** Whatever three bytes are, they are read or refused. */
    @Test
    void reader_ofAnyBytes_endsInNothingElse() {
        for (int i = 0; i < 1 << 24; i += 251) {
            Bytes bytes = Bytes.of(i >> 16, i >> 8, i);
            try {
                CborReader reader = new CborReader(bytes);
                reader.identifier();
                reader.externalData();
            } catch (HandshakeException e) {
                assertEquals(HandshakeException.Reason.NOT_CERTIFIED, e.reason());
            }
        }
    }
}
