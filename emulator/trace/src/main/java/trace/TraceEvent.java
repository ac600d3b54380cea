package trace;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonPrimitive;
import com.google.gson.Strictness;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * One line of the emulator's trace (emulator/README.md), or an event of the same form. If a field is missing or is of
 * another type, all methods that need it throw {@link MalformedEventException}.
 */
public final class TraceEvent {
    /** Hops and distances are told modulo this (SPEC 7.5). */
    public static final int HOPS = 4;

    /** A page could not read what is no JSON to it. */
    private static final Gson JSON = new GsonBuilder().setStrictness(Strictness.STRICT).create();

    private final int number;
    private final String line;
    private final JsonObject fields;
    private final double seconds;
    private final String board;
    private final String name;

    private TraceEvent(int number, String line, JsonObject fields) {
        this.number = number;
        this.line = line;
        this.fields = fields;
        if (!(fields.get("t") instanceof JsonPrimitive time && time.isNumber())
                || !(fields.get("event") instanceof JsonPrimitive event && event.isString())) {
            throw wrong("no event");
        }
        seconds = time.getAsDouble();
        name = event.getAsString();
        board = textOrEmpty("board");
    }

    /**
     * Reads a line.
     *
     * @param number the line's, from 1.
     */
    public static TraceEvent parse(int number, String line) {
        try {
            JsonObject fields = JSON.fromJson(line, JsonObject.class);
            if (fields != null) {
                return new TraceEvent(number, line, fields);
            }
        } catch (JsonParseException | ClassCastException wrong) {
            // As where there is nothing.
        }
        throw new MalformedEventException(number, "no JSON object");
    }

    /** It with another value of a field. */
    public TraceEvent with(String field, Object value) {
        JsonObject changed = fields.deepCopy();
        changed.add(field, JSON.toJsonTree(value));
        return new TraceEvent(number, changed.toString(), changed);
    }

    /** An exception for what only the event's user knows to be wrong. */
    public MalformedEventException wrong(String why) {
        return new MalformedEventException(number, why);
    }

    public int number() {
        return number;
    }

    public String line() {
        return line;
    }

    /** Emulated time at which it was written. */
    public double seconds() {
        return seconds;
    }

    /** Empty if it is of no single board. */
    public String board() {
        return board;
    }

    /** The kind of event, such as {@code rf-tx}. */
    public String name() {
        return name;
    }

    public boolean is(String event) {
        return name.equals(event);
    }

    public boolean is(String event, String onBoard) {
        return is(event) && board.equals(onBoard);
    }

    public boolean has(String field) {
        return fields.has(field);
    }

    /** The text, number or truth value of a field, as text. */
    public String text(String field) {
        if (!(fields.get(field) instanceof JsonPrimitive value)) {
            throw wrong("an event '" + name + "' without '" + field + "'");
        }
        return value.getAsString();
    }

    /** The text of a field, as {@link #text}, or empty. */
    public String textOrEmpty(String field) {
        return has(field) ? text(field) : "";
    }

    /** A number that may be broken. */
    public double real(String field) {
        String digits = text(field);
        try {
            return Double.parseDouble(digits);
        } catch (NumberFormatException no) {
            throw wrong("an event '" + name + "' whose '" + field + "' is no number");
        }
    }

    public int number(String field) {
        return (int) real(field);
    }

    public byte[] bytes(String field) {
        String digits = text(field);
        try {
            return HexFormat.of().parseHex(digits);
        } catch (IllegalArgumentException no) {
            throw wrong("a " + field + " that is not in hexadecimal digits");
        }
    }

    /** The relays behind a packet, modulo 4; a sender's own packet has none. */
    public int hops() {
        return has("hops") ? number("hops") : 0;
    }

    /** The distance that a packet tells, modulo 4 (SPEC 7.5). */
    public OptionalInt distance() {
        return has("distance") ? OptionalInt.of(number("distance")) : OptionalInt.empty();
    }

    /** The hops and the distance of a packet in one number (SPEC 6). */
    public int path() {
        return hops() + HOPS * (1 + distance().orElse(-1));
    }

    public List<String> texts(String field) {
        try {
            return json(field).getAsJsonArray().asList().stream().map(JsonElement::getAsString).toList();
        } catch (IllegalStateException | UnsupportedOperationException no) {
            throw wrong("an event '" + name + "' whose '" + field + "' are no texts");
        }
    }

    /** Any value, as JSON of the caller's own. */
    public JsonElement json(String field) {
        return has(field) ? fields.get(field).deepCopy() : JsonNull.INSTANCE;
    }

    /** The message of one host to another, text or bytes; nothing if the event does not tell it. */
    public Optional<byte[]> said() {
        return has("hex") ? Optional.of(bytes("hex"))
                : has("content") ? Optional.of(text("content").getBytes(StandardCharsets.UTF_8)) : Optional.empty();
    }

    @Override
    public String toString() {
        return "event " + number + " (" + String.format(Locale.ROOT, "%.6f s", seconds)
                + (board.isEmpty() ? "" : ", " + board) + ", " + name + ")";
    }
}
