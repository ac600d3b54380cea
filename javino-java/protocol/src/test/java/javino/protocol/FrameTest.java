package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.fail;

import com.google.gson.JsonObject;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class FrameTest {

    private static final VectorFile FILE = new VectorFile("frames.json");
    private static final Address ROMA = Address.parse("ROMA");

    static Stream<JsonObject> valid() {
        return FILE.list("valid");
    }

    static Stream<JsonObject> invalid() {
        return FILE.list("invalid");
    }

    private static Frame frameOf(JsonObject vector) {
        return new Frame(VectorFile.address(vector, "destination"), VectorFile.address(vector, "origin"),
                VectorFile.bytes(vector, "message"));
    }

    @ParameterizedTest
    @MethodSource("valid")
    void encode_validVector_givesItsBytes(JsonObject vector) {
        assertEquals(VectorFile.bytes(vector, "frame"), frameOf(vector).encode());
    }

    @ParameterizedTest
    @MethodSource("valid")
    void decode_validVector_givesItsFrame(JsonObject vector) throws ProtocolException {
        assertEquals(frameOf(vector), Frame.decode(VectorFile.bytes(vector, "frame")));
    }

    @ParameterizedTest
    @MethodSource("invalid")
    void decode_invalidVector_throwsItsError(JsonObject vector) {
        ProtocolException e = assertThrows(ProtocolException.class,
                () -> Frame.decode(VectorFile.bytes(vector, "bytes")));
        assertEquals(VectorFile.text(vector, "error"), e.error().name());
    }

    @Test
    void decode_eachLength_roundTrips() throws ProtocolException {
        for (int length = 0; length <= Frame.MAX_MESSAGE_LENGTH; length++) {
            Frame frame = new Frame(Address.BROADCAST, ROMA, Bytes.copyOf(new byte[length]));
            assertEquals(frame, Frame.decode(frame.encode()));
        }
    }

    @Test
    void decode_randomBytes_throwsOrReencodesToTheSame() {
        Random random = new Random(1);
        for (int i = 0; i < 20_000; i++) {
            byte[] bytes = new byte[random.nextInt(30)];
            for (int at = 0; at < bytes.length; at++) {
                bytes[at] = (byte) "AB+/9z*\0".charAt(random.nextInt(8));
            }
            Bytes input = Bytes.copyOf(bytes);
            try {
                assertEquals(input, Frame.decode(input).encode());
            } catch (ProtocolException expected) {
                if (expected.getMessage().isBlank()) {
                    fail("an error without evidence");
                }
            }
        }
    }

    @Test
    void constructor_badOriginOrLongMessage_throws() {
        Bytes tooLong = Bytes.copyOf(new byte[512]);
        assertThrows(IllegalArgumentException.class, () -> new Frame(ROMA, Address.BROADCAST, Bytes.EMPTY));
        assertThrows(IllegalArgumentException.class, () -> new Frame(ROMA, ROMA, tooLong));
    }
}
