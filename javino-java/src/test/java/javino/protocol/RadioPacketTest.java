package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.google.gson.JsonObject;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class RadioPacketTest {

    private static final VectorFile FILE = new VectorFile("radio.json");

    static Stream<JsonObject> packets() {
        return FILE.list("packets");
    }

    static Stream<JsonObject> invalid() {
        return FILE.list("invalid");
    }

    @ParameterizedTest
    @MethodSource("packets")
    void encode_vector_givesItsBits(JsonObject vector) {
        Bytes payload = VectorFile.bytes(vector, "payload");
        String bits = RadioPacket.encode(payload);
        assertEquals(VectorFile.text(vector, "bits"), bits);
        assertEquals(84 + 12 * payload.length(), bits.length());
    }

    @ParameterizedTest
    @MethodSource("packets")
    void decode_vector_givesItsPayload(JsonObject vector) throws ProtocolException {
        assertEquals(VectorFile.bytes(vector, "payload"), RadioPacket.decode(VectorFile.text(vector, "bits") + "0101"));
    }

    @ParameterizedTest
    @MethodSource("invalid")
    void decode_invalidVector_throws(JsonObject vector) {
        assertThrows(ProtocolException.class, () -> RadioPacket.decode(VectorFile.text(vector, "bits")));
    }

    @Test
    void decode_anyBitChangedOrCutOff_throws() {
        String bits = RadioPacket.encode(Bytes.ofText("////ROMABItell;help"));
        for (int i = 0; i < bits.length(); i++) {
            String cut = bits.substring(0, i);
            String changed = cut + (bits.charAt(i) == '0' ? '1' : '0') + bits.substring(i + 1);
            assertThrows(ProtocolException.class, () -> RadioPacket.decode(changed), "bit " + i);
            assertThrows(ProtocolException.class, () -> RadioPacket.decode(cut), "cut at bit " + i);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 78})
    void encode_wrongLength_throws(int length) {
        assertThrows(IllegalArgumentException.class, () -> RadioPacket.encode(Bytes.copyOf(new byte[length])));
    }
}
