package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.google.gson.JsonObject;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class AcknowledgementTest {

    private static final VectorFile FILE = new VectorFile("acknowledgements.json");
    private static final Address ROMA = Address.parse("ROMA");
    private static final Acknowledgement.Answered ANSWERED = new Acknowledgement.Answered(
            Key.ofHex("000102030405060708090a0b0c0d0e0f"), Address.parse("SUPO"), Bytes.ofHex("000102030405"));
    private static final List<Acknowledgement> EACH = List.of(new Acknowledgement.Delivered(),
            new Acknowledgement.Pieces(3), new Acknowledgement.Stale(Bytes.ofHex("000102030424"), 1234));

    static Stream<JsonObject> valid() {
        return FILE.list("valid");
    }

    static Stream<JsonObject> invalid() {
        return FILE.list("invalid");
    }

    private static Acknowledgement.Answered answeredBy(JsonObject vector) {
        return new Acknowledgement.Answered(Key.ofHex(VectorFile.text(vector, "key")),
                VectorFile.address(vector, "sender"), VectorFile.bytes(vector, "nonce"));
    }

    private static Acknowledgement of(JsonObject vector) {
        return switch (VectorFile.text(vector, "kind")) {
            case "delivered" -> new Acknowledgement.Delivered();
            case "pieces" -> new Acknowledgement.Pieces(vector.get("pieces").getAsInt());
            case "stale" -> new Acknowledgement.Stale(VectorFile.bytes(vector, "floor"),
                    vector.get("uptime").getAsInt());
            default -> throw new AssertionError(vector);
        };
    }

    private static void assertRefused(Acknowledgement.Answered answered, Frame frame, String what) {
        assertEquals(ProtocolError.BAD_PROOF, assertThrows(ProtocolException.class,
                () -> Acknowledgement.open(answered, frame), what).error());
    }

    @ParameterizedTest
    @MethodSource("valid")
    void frame_validVector_givesItsBytes(JsonObject vector) {
        assertEquals(VectorFile.bytes(vector, "frame"),
                of(vector).frame(answeredBy(vector), VectorFile.address(vector, "acknowledger")).encode());
    }

    @ParameterizedTest
    @MethodSource("valid")
    void open_validVector_givesItsFields(JsonObject vector) throws ProtocolException {
        Frame frame = Frame.decode(VectorFile.bytes(vector, "frame"));
        assertEquals(of(vector), Acknowledgement.open(answeredBy(vector), frame));
    }

    @ParameterizedTest
    @MethodSource("invalid")
    void open_invalidVector_throwsBadProof(JsonObject vector) throws ProtocolException {
        Frame frame = Frame.decode(VectorFile.bytes(vector, "frame"));
        assertRefused(answeredBy(vector), frame, VectorFile.text(vector, "why"));
    }

    @Test
    void open_anyBitChangedOrBytesMissing_throws() {
        for (Acknowledgement acknowledgement : EACH) {
            byte[] good = acknowledgement.frame(ANSWERED, ROMA).encode().toArray();
            for (int bit = 0; bit < 8 * good.length; bit++) {
                byte[] changed = good.clone();
                changed[bit / 8] ^= (byte) (1 << bit % 8);
                assertThrows(ProtocolException.class,
                        () -> Acknowledgement.open(ANSWERED, Frame.decode(Bytes.copyOf(changed))), "bit " + bit);
            }
            Frame frame = acknowledgement.frame(ANSWERED, ROMA);
            for (int length = 0; length < frame.message().length(); length++) {
                Frame cut = new Frame(frame.destination(), ROMA, frame.message().slice(0, length));
                assertRefused(ANSWERED, cut, "cut to " + length);
            }
        }
    }

    @Test
    void open_tagOfTheFrameItself_isNoProof() {
        Frame sealed = Envelope.seal(ANSWERED.key(), ANSWERED.sender(), ROMA, new Nonce(0x000102, 0x030405),
                Bytes.ofText("tell;help"));
        Bytes tag = sealed.message().from(sealed.message().length() - Envelope.TAG_LENGTH);
        assertRefused(ANSWERED, new Frame(ANSWERED.address(), ROMA, tag), "reflected tag");
    }

    @Test
    void open_randomMessages_throwsBadProof() {
        Random random = new Random(4);
        for (int i = 0; i < 5_000; i++) {
            byte[] message = new byte[random.nextInt(20)];
            random.nextBytes(message);
            assertRefused(ANSWERED, new Frame(ANSWERED.address(), ROMA, Bytes.copyOf(message)), "round " + i);
        }
    }

    @Test
    void constructors_valuesOutOfRange_throw() {
        Bytes floor = Bytes.ofHex("000102030424");
        assertThrows(IllegalArgumentException.class, () -> new Acknowledgement.Pieces(0x100));
        assertThrows(IllegalArgumentException.class, () -> new Acknowledgement.Pieces(-1));
        assertThrows(IllegalArgumentException.class, () -> new Acknowledgement.Stale(floor, 0x10000));
        assertThrows(IllegalArgumentException.class, () -> new Acknowledgement.Stale(floor.from(1), 0));
        assertThrows(IllegalArgumentException.class,
                () -> new Acknowledgement.Answered(ANSWERED.key(), ROMA, floor.from(1)));
    }
}
