package javino.protocol;

import com.google.gson.Gson;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** A file of vectors under test/vectors. */
final class VectorFile {

    static final Path FOLDER = Path.of(System.getProperty("javino.vectors"));

    private final JsonObject lists;

    VectorFile(String name) {
        try {
            lists = new Gson().fromJson(Files.readString(FOLDER.resolve(name)), JsonObject.class);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The vectors of a list, which has at least one. */
    Stream<JsonObject> list(String name) {
        List<JsonElement> vectors = lists.getAsJsonArray(name).asList();
        if (vectors.isEmpty()) {
            throw new AssertionError("no vectors in " + name);
        }
        return vectors.stream().map(JsonElement::getAsJsonObject);
    }

    static Bytes bytes(JsonObject vector, String name) {
        return Bytes.ofHex(vector.get(name).getAsString());
    }

    static String text(JsonObject vector, String name) {
        return vector.get(name).getAsString();
    }

    static Address address(JsonObject vector, String name) {
        return Address.parse(text(vector, name));
    }
}
