package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.google.gson.JsonObject;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.protocol.HostMessage.Kind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class HostMessageTest {

    private static final VectorFile FILE = new VectorFile("host-messages.json");
    private static final Address SUPO = Address.parse("SUPO");

    static Stream<JsonObject> valid() {
        return FILE.list("valid");
    }

    static Stream<JsonObject> invalid() {
        return FILE.list("invalid");
    }

    private static HostMessage message(JsonObject vector) {
        Optional<Address> to = vector.get("to").isJsonNull() ? Optional.empty()
                : Optional.of(Address.parse(VectorFile.text(vector, "to")));
        return new HostMessage(Kind.valueOf(VectorFile.text(vector, "kind")), to, vector.get("fragment").getAsInt(),
                VectorFile.bytes(vector, "body"));
    }

    @ParameterizedTest
    @MethodSource("valid")
    void decode_validVector_hasItsPartsAndRoundTrips(JsonObject vector) throws ProtocolException {
        Bytes bytes = VectorFile.bytes(vector, "hostMessage");
        assertEquals(message(vector), HostMessage.decode(bytes));
        assertEquals(bytes, message(vector).encode());
    }

    @ParameterizedTest
    @MethodSource("invalid")
    void decode_invalidVector_throwsItsError(JsonObject vector) {
        assertEquals(VectorFile.text(vector, "error"), assertThrows(ProtocolException.class,
                () -> HostMessage.decode(VectorFile.bytes(vector, "hostMessage"))).error().name(),
                VectorFile.text(vector, "why"));
    }

    @Test
    void decode_vectors_haveEachKind() {
        assertEquals(EnumSet.allOf(Kind.class),
                valid().map(vector -> message(vector).kind()).collect(Collectors.toSet()));
    }

    @Test
    void decode_anyBytes_isRefusedOrRoundTrips() {
        Random random = new Random(1);
        for (int i = 0; i < 100_000; i++) {
            byte[] bytes = new byte[random.nextInt(i % 2 == 0 ? 80 : Content.MAX_LENGTH + 2)];
            random.nextBytes(bytes);
            if (bytes.length > 0) {
                bytes[0] = (byte) (0x80 | bytes[0] & 0x1F);
            }
            try {
                assertEquals(Bytes.copyOf(bytes), HostMessage.decode(Bytes.copyOf(bytes)).encode());
            } catch (ProtocolException e) {
                assertEquals(ProtocolError.BAD_HOST_MESSAGE, e.error());
            }
        }
    }

    @Test
    void fragments_eachKindOfBroadcast_fitsOnePacketEach() {
        for (Kind kind : EnumSet.range(Kind.MESSAGE_1, Kind.GROUP)) {
            Bytes message = Bytes.copyOf(new byte[kind.length()]);
            List<HostMessage> fragments = HostMessage.fragments(kind, SUPO, message);
            assertEquals(kind.fragments(), fragments.size());
            assertEquals(message, fragments.stream().map(HostMessage::body).reduce(Bytes.EMPTY, Bytes::join));
            fragments.forEach(fragment -> assertFalse(fragment.encode().length() > 67, kind::toString));
        }
    }

    @Test
    void isHostMessage_anotherFirstByteOrTooLong_isNone() {
        for (Bytes bytes : List.of(Bytes.EMPTY, Bytes.of(0x7F), Bytes.of(0xC0),
                Bytes.join(Bytes.of(0x80), Bytes.copyOf(new byte[Content.MAX_LENGTH])))) {
            assertFalse(HostMessage.isHostMessage(bytes), bytes::hex);
        }
    }

    @Test
    void constructor_ofAnotherForm_throws() {
        assertThrows(IllegalArgumentException.class, () -> new HostMessage(Kind.MESSAGE_3, Bytes.of(new int[63])));
        assertThrows(IllegalArgumentException.class, () -> new HostMessage(Kind.MOVE_GO, SUPO, Bytes.of(1, 2, 3, 4)));
        assertThrows(IllegalArgumentException.class,
                () -> new HostMessage(Kind.CONTENT, Bytes.copyOf(new byte[Content.MAX_LENGTH])));
    }
}
