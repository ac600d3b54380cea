package uppaal.replay;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import javino.protocol.Airtime;

/** A trace that a test spoils. Lines count from 1, as refusals name them. */
final class Lines {
    /** So that all that tests make up is on the air for less than 0.3 s. */
    private static final int RATE = 4000;

    /** Whether its times are a test's, which does not keep to those of boards. */
    boolean madeUp;
    final List<JsonObject> all = new ArrayList<>();

    /** One of src/test/resources/traces. */
    static Lines of(String name) {
        Lines lines = new Lines();
        try (BufferedReader reader = new BufferedReader(new InputStreamReader(
                Lines.class.getResourceAsStream("/traces/" + name + ".jsonl"), StandardCharsets.UTF_8))) {
            reader.lines().forEach(line -> lines.all.add(JsonParser.parseString(line).getAsJsonObject()));
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
        return lines;
    }

    /** Adds an event; of its fields those that are whole or broken numbers are numbers. */
    Lines add(double seconds, String board, String event, Map<String, Object> fields) {
        JsonObject line = new JsonObject();
        line.addProperty("t", seconds);
        line.addProperty("board", board);
        line.addProperty("event", event);
        fields.forEach((key, value) -> {
            if (value instanceof Number number) {
                line.addProperty(key, number);
            } else {
                line.addProperty(key, (String) value);
            }
        });
        if (event.equals("rf-tx") || event.equals("rf-rx")) {
            int bits = Airtime.bits(line.get("payload").getAsString().length() / 2);
            line.addProperty("bits", bits);
            line.addProperty("end", line.get("start").getAsDouble() + (bits - 1.0) / RATE);
        }
        all.add(line);
        return this;
    }

    JsonObject get(int line) {
        return all.get(line - 1);
    }

    String text(int line, String field) {
        return get(line).has(field) ? get(line).get(field).getAsString() : "";
    }

    /** The lines that are so. */
    List<Integer> where(Predicate<Integer> wanted) {
        List<Integer> found = new ArrayList<>();
        for (int line = 1; line <= all.size(); line++) {
            if (wanted.test(line)) {
                found.add(line);
            }
        }
        return found;
    }

    /** The first line of a board with this event after a line. */
    int next(int after, String board, String event) {
        return where(line -> line > after && is(line, board, event)).get(0);
    }

    boolean is(int line, String board, String event) {
        return text(line, "board").equals(board) && text(line, "event").equals(event);
    }

    boolean is(int line, String event) {
        return text(line, "event").equals(event);
    }

    /** Takes lines away. */
    Lines without(Predicate<Integer> unwanted) {
        Lines rest = new Lines();
        rest.madeUp = madeUp;
        where(unwanted.negate()).forEach(line -> rest.all.add(get(line)));
        return rest;
    }

    /** A copy of a line, to be changed and put in. */
    JsonObject copy(int line) {
        return get(line).deepCopy();
    }

    Replay replay() {
        return replay(new Replay());
    }

    /** With the keys of {@code src/test/resources/traces/NAME.keys}. */
    Replay replayWithKeys(String name) {
        return replay(new Replay(keys(name)));
    }

    static Path keys(String name) {
        return Path.of("src", "test", "resources", "traces", name + ".keys");
    }

    private Replay replay(Replay replay) {
        if (madeUp) {
            replay.doubtReception();
        }
        all.forEach(line -> replay.line(line.toString()));
        replay.finish();
        return replay;
    }
}
