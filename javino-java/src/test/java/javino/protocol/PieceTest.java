package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class PieceTest {

    private static final VectorFile FILE = new VectorFile("pieces.json");
    private static final Address ROMA = Address.parse("ROMA");
    private static final Address SUPO = Address.parse("SUPO");

    static Stream<JsonObject> valid() {
        return FILE.list("valid");
    }

    static Stream<JsonObject> asking() {
        return FILE.list("asking");
    }

    static Stream<JsonObject> invalid() {
        return FILE.list("invalid");
    }

    private static Frame frameOf(JsonObject vector) throws ProtocolException {
        return Frame.decode(VectorFile.bytes(vector, "frame"));
    }

    private static int idOf(JsonObject vector) {
        return Digits.value(VectorFile.text(vector, "id").charAt(0));
    }

    private static List<Frame> piecesOf(JsonObject vector) throws ProtocolException {
        List<Frame> pieces = new ArrayList<>();
        for (JsonElement piece : vector.getAsJsonArray("pieces")) {
            pieces.add(Frame.decode(Bytes.ofHex(piece.getAsString())));
        }
        return pieces;
    }

    private static Frame frameOfLength(int length, int fill) {
        return new Frame(SUPO, ROMA, Bytes.ofText(Character.toString(fill).repeat(length - Frame.HEADER_LENGTH)));
    }

    private static Optional<Frame> addAll(Assembly assembly, List<Piece> pieces) throws ProtocolException {
        Optional<Frame> whole = Optional.empty();
        for (Piece piece : pieces) {
            assertEquals(Optional.empty(), whole, "whole too early");
            whole = assembly.add(piece);
        }
        return whole;
    }

    @ParameterizedTest
    @MethodSource("valid")
    void cut_validVector_givesItsPieces(JsonObject vector) throws ProtocolException {
        assertEquals(piecesOf(vector),
                Piece.cut(frameOf(vector), idOf(vector)).stream().map(Piece::frame).toList());
    }

    @ParameterizedTest
    @MethodSource("valid")
    void add_validVectorInAnyOrderWithRepeats_givesItsFrame(JsonObject vector) throws ProtocolException {
        List<Piece> pieces = new ArrayList<>();
        for (Frame frame : piecesOf(vector)) {
            pieces.add(Piece.decode(frame));
        }
        Random random = new Random(1);
        for (int round = 0; round < 20; round++) {
            Collections.shuffle(pieces, random);
            Assembly assembly = new Assembly();
            for (Piece piece : pieces.subList(0, pieces.size() - 1)) {
                assertEquals(Optional.empty(), assembly.add(piece));
                assertEquals(Optional.empty(), assembly.add(piece.asking()));
            }
            assertEquals(Optional.of(frameOf(vector)), assembly.add(pieces.get(pieces.size() - 1)));
            assertEquals((1 << pieces.size()) - 1, assembly.received());
        }
    }

    @ParameterizedTest
    @MethodSource("asking")
    void decode_pieceThatAsks_givesItsFieldsAndBack(JsonObject vector) throws ProtocolException {
        Frame frame = Frame.decode(VectorFile.bytes(vector, "piece"));
        Piece plain = new Piece(VectorFile.address(vector, "origin"), idOf(vector), vector.get("index").getAsInt(),
                false, VectorFile.bytes(vector, "part"));
        assertEquals(plain.asking(), Piece.decode(frame));
        assertEquals(frame, plain.asking().frame());
    }

    @ParameterizedTest
    @MethodSource("invalid")
    void decode_invalidVector_throwsBadPiece(JsonObject vector) throws ProtocolException {
        Frame frame = Frame.decode(VectorFile.bytes(vector, "piece"));
        assertEquals(ProtocolError.BAD_PIECE,
                assertThrows(ProtocolException.class, () -> Piece.decode(frame)).error());
    }

    @Test
    void decode_frameToADevice_throwsBadPiece() {
        assertEquals(ProtocolError.BAD_PIECE, assertThrows(ProtocolException.class,
                () -> Piece.decode(new Frame(SUPO, ROMA, Bytes.ofText("tell;help")))).error());
    }

    @Test
    void cut_eachLength_fitsPacketsAndComesTogether() throws ProtocolException {
        for (int length = 78; length <= Frame.MAX_LENGTH; length++) {
            Frame whole = frameOfLength(length, 'x');
            List<Piece> pieces = Piece.cut(whole, length % 64);
            assertEquals((length + 66) / 67, pieces.size());
            for (Piece piece : pieces) {
                assertTrue(piece.frame().encode().length() <= RadioPacket.MAX_PAYLOAD_LENGTH);
                assertEquals(piece, Piece.decode(piece.frame()));
            }
            assertEquals(Optional.of(whole), addAll(new Assembly(), pieces));
        }
    }

    @Test
    void cut_frameThatFitsAPacketOrHasNoReceiver_throws() {
        assertThrows(IllegalArgumentException.class, () -> Piece.cut(frameOfLength(77, 'x'), 0));
        Frame toSerial = new Frame(Address.SERIAL, Address.SERIAL, Bytes.copyOf(new byte[100]));
        assertThrows(IllegalArgumentException.class, () -> Piece.cut(toSerial, 0));
        assertThrows(IllegalArgumentException.class, () -> Piece.cut(frameOfLength(78, 'x'), 64));
    }

    @Test
    void add_pieceOfAnotherFrame_isRefusedAndTheRestComesTogether() throws ProtocolException {
        List<Piece> good = Piece.cut(frameOfLength(300, 'x'), 5);
        Frame fromAnother = new Frame(SUPO, Address.parse("ROMB"), frameOfLength(300, 'x').message());
        List<Piece> bad = new ArrayList<>(Piece.cut(fromAnother, 5));
        bad.addAll(Piece.cut(frameOfLength(300, 'x'), 6));
        bad.add(Piece.cut(frameOfLength(301, 'x'), 5).get(0));
        bad.add(Piece.cut(frameOfLength(299, 'x'), 5).get(4));
        bad.add(Piece.cut(frameOfLength(500, 'x'), 5).get(4));
        bad.add(Piece.cut(frameOfLength(500, 'x'), 5).get(6));
        Assembly assembly = new Assembly();
        for (Piece piece : good.subList(0, 4)) {
            assertEquals(Optional.empty(), assembly.add(piece));
            assertAllRefused(assembly, bad);
        }
        assertEquals(Optional.of(frameOfLength(300, 'x')), assembly.add(good.get(4)));
    }

    private static void assertAllRefused(Assembly assembly, List<Piece> pieces) {
        int before = assembly.received();
        for (Piece piece : pieces) {
            assertEquals(ProtocolError.BAD_PIECE,
                    assertThrows(ProtocolException.class, () -> assembly.add(piece)).error());
        }
        assertEquals(before, assembly.received());
    }

    @Test
    void add_otherBytesForAPieceThatIsHere_areRefused() throws ProtocolException {
        Assembly assembly = new Assembly();
        assembly.add(Piece.cut(frameOfLength(300, 'x'), 5).get(1));
        assertAllRefused(assembly, List.of(Piece.cut(frameOfLength(300, 'y'), 5).get(1)));
    }

    @Test
    void add_lastPieceBeforeTheFirst_fixesTheLength() throws ProtocolException {
        Assembly assembly = new Assembly();
        assembly.add(Piece.cut(frameOfLength(300, 'x'), 0).get(4));
        Piece otherFirst = Piece.cut(frameOfLength(301, 'x'), 0).get(0);
        assertThrows(ProtocolException.class, () -> assembly.add(otherFirst));
        assertEquals(0b10000, assembly.received());
    }

    @Test
    void decode_randomFrames_throwsBadPieceOrReencodesToTheSame() {
        Random random = new Random(2);
        int read = 0;
        for (int i = 0; i < 20_000; i++) {
            byte[] message = new byte[random.nextInt(70)];
            random.nextBytes(message);
            Frame frame = new Frame(new Address(0xF85000 | random.nextInt(0x1000)), ROMA, Bytes.copyOf(message));
            try {
                assertEquals(frame, Piece.decode(frame).frame());
                read++;
            } catch (ProtocolException e) {
                assertEquals(ProtocolError.BAD_PIECE, e.error());
            }
        }
        assertTrue(read > 0);
    }

    @Test
    void add_piecesMixedAtRandom_giveOnlyFramesThatTheirBytesMake() {
        Random random = new Random(3);
        List<Piece> pool = new ArrayList<>();
        for (int length = 150; length < 521; length += 37) {
            pool.addAll(Piece.cut(frameOfLength(length, 'a' + length % 26), 0));
        }
        int whole = 0;
        for (int round = 0; round < 2_000; round++) {
            Assembly assembly = new Assembly();
            Piece[] held = new Piece[8];
            for (int i = 0; i < 40; i++) {
                Piece piece = pool.get(random.nextInt(pool.size()));
                Optional<Frame> made;
                try {
                    made = assembly.add(piece);
                } catch (ProtocolException e) {
                    continue;
                }
                assertTrue(held[piece.index()] == null || held[piece.index()].equals(piece));
                held[piece.index()] = piece;
                if (made.isPresent()) {
                    assertFalse(made.get().encode().length() < 78);
                    assertEquals(held[0].part(), made.get().encode().slice(0, 67));
                    whole++;
                }
            }
        }
        assertTrue(whole > 0);
    }
}
