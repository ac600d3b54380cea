package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.StreamSupport;
import javino.protocol.Bytes;
import javino.protocol.Payload;
import org.junit.jupiter.api.Test;

/** The shared vectors, of which the firmware's tests take the other side. */
class SharedKeyTest {
    private static final Map<String, Integer> TYPES = Map.of("delivered", 6, "fragments", 7, "stale", 8);
    /** The proof's type by the length of the message; others have none. */
    private static final Map<Integer, Integer> TYPE_OF_LENGTH = Map.of(8, 6, 9, 7, 16, 8);

    private static List<JsonObject> vectors(String file, String list) throws IOException {
        String text = Files.readString(Path.of(System.getProperty("javino.vectors"), file + ".json"));
        return StreamSupport.stream(JsonParser.parseString(text).getAsJsonObject().getAsJsonArray(list).spliterator(),
                false).map(JsonElement::getAsJsonObject).toList();
    }

    private static Bytes hex(JsonObject vector, String field) {
        return Bytes.ofHex(vector.get(field).getAsString());
    }

    private static SharedKey key(JsonObject vector) {
        return SharedKey.of(hex(vector, "key"));
    }

    private static boolean isProof(JsonObject vector, int type) {
        Bytes frame = hex(vector, "frame");
        int end = frame.length() - Payload.TAG_LENGTH;
        String addresses = vector.get("sender").getAsString() + vector.get("acknowledger").getAsString();
        return IntStream.of(type, type | SharedKey.ASKS_PARITY).anyMatch(each -> frame.from(end)
                .equals(key(vector).proof(each, hex(vector, "nonce"), addresses, frame.slice(Frame.HEADER, end))));
    }

    @Test
    void seal_givesTheVectors() throws IOException {
        for (JsonObject vector : vectors("envelopes", "valid")) {
            Bytes content = hex(vector, "content");
            Bytes header = TestTrace.header(vector.get("destination").getAsString(),
                    vector.get("origin").getAsString(), content.length() + TestTrace.SEALED_BYTES);
            Bytes sealed = key(vector).seal(Bytes.join(header, hex(vector, "nonce")), content);
            assertEquals(hex(vector, "frame"), sealed, vector::toString);
        }
    }

    @Test
    void isProof_ofTheVectors() throws IOException {
        for (JsonObject vector : vectors("acknowledgements", "valid")) {
            TYPES.forEach((kind, type) -> assertEquals(kind.equals(vector.get("kind").getAsString()),
                    isProof(vector, type), () -> vector + " as " + kind));
        }
        for (JsonObject vector : vectors("acknowledgements", "invalid")) {
            Integer type = TYPE_OF_LENGTH.get(hex(vector, "frame").length() - Frame.HEADER);
            boolean isOfAnother = vector.get("why").getAsString().equals("the address is of another nonce");
            assertFalse(type != null && !isOfAnother && isProof(vector, type), vector::toString);
        }
    }
}
