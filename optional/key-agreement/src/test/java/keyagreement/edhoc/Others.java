package keyagreement.edhoc;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javino.protocol.Bytes;

/** The cases that others wrote, in test/verdict/vectors. */
final class Others {

    private Others() {
    }

    /** What a file holds. */
    static JsonElement read(String file) {
        try (Reader reader = Files.newBufferedReader(Path.of(System.getProperty("javino.verdict"), file))) {
            return JsonParser.parseReader(reader);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The bytes that a field has in hexadecimal digits. */
    static Bytes bytes(JsonObject object, String field) {
        return Bytes.ofHex(object.get(field).getAsString());
    }
}
