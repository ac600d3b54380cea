package harness;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;

/**
 * One line of the emulator's trace.
 *
 * @param seconds emulated time
 */
public record TraceEvent(double seconds, String board, String name, JsonObject fields, String line) {

    public static TraceEvent parse(String line) {
        JsonObject fields = JsonParser.parseString(line).getAsJsonObject();
        String board = fields.has("board") ? fields.get("board").getAsString() : "";
        return new TraceEvent(fields.get("t").getAsDouble(), board, fields.get("event").getAsString(), fields, line);
    }

    public boolean is(String event, String onBoard) {
        return name.equals(event) && board.equals(onBoard);
    }

    public String text(String field) {
        return fields.get(field).getAsString();
    }

    public int number(String field) {
        return fields.get(field).getAsInt();
    }

    public double real(String field) {
        return fields.get(field).getAsDouble();
    }
}
