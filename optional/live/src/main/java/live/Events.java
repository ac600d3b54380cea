package live;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.Strictness;
import java.util.LinkedHashMap;
import java.util.Map;
import javino.JavinoException;

/** The one shape that events have: a JSON object with a time {@code t} and a name {@code event}. */
final class Events {

    /** Without it, a page could not read what is no JSON to it, and with it a whole batch. */
    private static final Gson STRICT = new GsonBuilder().setStrictness(Strictness.STRICT).create();

    /** A line with so many, escaped too, reaches a pipe in one piece, even where another writes there (4096 bytes). */
    private static final int MOST_CHARACTERS = 600;

    private Events() {
    }

    /**
     * Reads a JSON object.
     *
     * @throws JavinoException if it is none.
     */
    static JsonObject object(String text) throws JavinoException {
        try {
            JsonObject object = STRICT.fromJson(text, JsonObject.class);
            if (object != null) {
                return object;
            }
        } catch (JsonParseException | ClassCastException e) {
            throw new JavinoException("expected a JSON object such as {\"do\":\"reset\",\"board\":\"bus\"}", e);
        }
        throw new JavinoException("expected a JSON object, not an empty text");
    }

    /**
     * The text of a command's field.
     *
     * @throws IllegalArgumentException if it has none.
     */
    static String text(JsonObject command, String field) {
        if (!command.has(field) || !command.get(field).isJsonPrimitive()
                || command.get(field).getAsString().isBlank()) {
            throw new IllegalArgumentException("the command needs a text " + field);
        }
        return command.get(field).getAsString();
    }

    /** A text of whatever length, for one line. */
    static String shortened(String text) {
        return text.length() <= MOST_CHARACTERS ? text : text.substring(0, MOST_CHARACTERS - 1) + "…";
    }

    /** JSON in one line: names, each before its value. */
    static String json(Object... namesAndValues) {
        Map<Object, Object> fields = new LinkedHashMap<>();
        for (int i = 0; i < namesAndValues.length; i += 2) {
            fields.put(namesAndValues[i], namesAndValues[i + 1]);
        }
        return STRICT.toJson(fields);
    }
}
