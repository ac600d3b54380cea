package uppaal.replay;

import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import com.google.gson.JsonSyntaxException;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.Locale;
import java.util.Optional;

/**
 * One line of the emulator's trace (emulator/README.md).
 *
 * @param index the number of the line, from 1
 * @param seconds emulated time at which it was written
 * @param board empty where it is of no single board
 */
record Event(int index, double seconds, String board, String name, JsonObject fields) {
    /** @throws JsonParseException where the line is no event */
    static Event parse(int index, String line) {
        try {
            JsonObject fields = JsonParser.parseString(line).getAsJsonObject();
            String board = fields.has("board") ? fields.get("board").getAsString() : "";
            return new Event(index, fields.get("t").getAsDouble(), board, fields.get("event").getAsString(), fields);
        } catch (JsonSyntaxException wrong) {
            throw new JsonParseException("no JSON object", wrong);
        } catch (IllegalStateException | NullPointerException | UnsupportedOperationException
                | NumberFormatException wrong) {
            throw new JsonParseException("no event", wrong);
        }
    }

    /** @throws JsonParseException where it has no such field, or another kind of one */
    String text(String field) {
        if (!fields.has(field) || !fields.get(field).isJsonPrimitive()) {
            throw new JsonParseException("an event '" + name + "' without '" + field + "'");
        }
        return fields.get(field).getAsString();
    }

    /** As {@link #text}, or nothing. */
    String textOrEmpty(String field) {
        return fields.has(field) ? text(field) : "";
    }

    /** As {@link #text}, of a number. */
    double number(String field) {
        try {
            return Double.parseDouble(text(field));
        } catch (NumberFormatException wrong) {
            throw new JsonParseException("an event '" + name + "' whose '" + field + "' is no number", wrong);
        }
    }

    /** Relays behind a packet, modulo 3; a sender's own packet has none. */
    int hops() {
        return fields.has("hops") ? (int) number("hops") : 0;
    }

    /** What one agent says to another; nothing where it does not tell. */
    Optional<byte[]> said() {
        return fields.has("hex") ? Optional.of(HexFormat.of().parseHex(text("hex")))
                : fields.has("content") ? Optional.of(text("content").getBytes(StandardCharsets.UTF_8))
                        : Optional.empty();
    }

    @Override
    public String toString() {
        return "event " + index + " (" + String.format(Locale.ROOT, "%.6f s", seconds)
                + (board.isEmpty() ? "" : ", " + board) + ", " + name + ")";
    }
}
