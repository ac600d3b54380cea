package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.StreamSupport;
import javino.protocol.Bytes;
import org.junit.jupiter.api.Test;

/** The shared vectors, of which the firmware's tests take the other side. */
class SharedKeyTest {
    private static final int HEADER = 10;
    private static final Map<String, Integer> TYPES = Map.of("delivered", 6, "fragments", 7, "stale", 8);
    /** The proof's type by the length of the message; others have none. */
    private static final Map<Integer, Integer> TYPE_OF_LENGTH = Map.of(8, 6, 9, 7, 16, 8);

    private static List<JsonObject> vectors(String file, String list) throws IOException {
        String text = Files.readString(Path.of(System.getProperty("javino.vectors"), file + ".json"));
        return StreamSupport.stream(JsonParser.parseString(text).getAsJsonObject().getAsJsonArray(list).spliterator(),
                false).map(JsonElement::getAsJsonObject).toList();
    }

    private static byte[] hex(JsonObject vector, String field) {
        return HexFormat.of().parseHex(vector.get(field).getAsString());
    }

    private static SharedKey key(JsonObject vector) {
        return new SharedKey(hex(vector, "key"));
    }

    private static boolean isProof(JsonObject vector, int type) {
        Bytes message = Bytes.copyOf(hex(vector, "frame")).from(HEADER);
        String addresses = vector.get("sender").getAsString() + vector.get("acknowledger").getAsString();
        return IntStream.of(type, type | SharedKey.ASKS_PARITY).anyMatch(each -> key(vector).isProof(each,
                vector.get("nonce").getAsString(), addresses, message));
    }

    @Test
    void seal_andOpen_giveTheVectors() throws IOException {
        for (JsonObject vector : vectors("envelopes", "valid")) {
            byte[] sealed = key(vector).seal(vector.get("destination").getAsString(),
                    vector.get("origin").getAsString(), hex(vector, "nonce"), hex(vector, "content"));
            assertArrayEquals(hex(vector, "frame"), sealed, vector::toString);
            assertArrayEquals(hex(vector, "content"), key(vector).open(Bytes.copyOf(sealed)).orElseThrow().toArray(),
                    vector::toString);
        }
    }

    @Test
    void open_changedOrAnothers_isNothing() throws IOException {
        for (JsonObject vector : vectors("envelopes", "invalid")) {
            assertTrue(key(vector).open(Bytes.copyOf(hex(vector, "frame"))).isEmpty(), vector::toString);
        }
    }

    @Test
    void isProof_ofTheVectors() throws IOException {
        for (JsonObject vector : vectors("acknowledgements", "valid")) {
            TYPES.forEach((kind, type) -> assertEquals(kind.equals(vector.get("kind").getAsString()),
                    isProof(vector, type), () -> vector + " as " + kind));
        }
        for (JsonObject vector : vectors("acknowledgements", "invalid")) {
            Integer type = TYPE_OF_LENGTH.get(hex(vector, "frame").length - HEADER);
            boolean isOfAnother = vector.get("why").getAsString().equals("the address is of another nonce");
            assertFalse(type != null && !isOfAnother && isProof(vector, type), vector::toString);
        }
    }
}
