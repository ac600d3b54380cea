package uppaal.conformance;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/** A genuine trace that a test spoils. Lines count from 1, as refusals name them. */
final class TraceLines {
    final List<JsonObject> all = new ArrayList<>();

    /** One of src/test/resources/traces. */
    static TraceLines of(String name) {
        TraceLines lines = new TraceLines();
        try (BufferedReader reader = new BufferedReader(new InputStreamReader(
                TraceLines.class.getResourceAsStream("/traces/" + name + ".jsonl"), StandardCharsets.UTF_8))) {
            reader.lines().forEach(line -> lines.all.add(JsonParser.parseString(line).getAsJsonObject()));
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
        return lines;
    }

    JsonObject get(int line) {
        return all.get(line - 1);
    }

    String text(int line, String field) {
        return get(line).has(field) ? get(line).get(field).getAsString() : "";
    }

    /** The lines that are so. */
    List<Integer> where(IntPredicate wanted) {
        return IntStream.rangeClosed(1, all.size()).filter(wanted).boxed().toList();
    }

    boolean is(int line, String board, String event) {
        return text(line, "board").equals(board) && is(line, event);
    }

    boolean is(int line, String event) {
        return text(line, "event").equals(event);
    }

    TraceLines without(IntPredicate unwanted) {
        TraceLines rest = new TraceLines();
        where(unwanted.negate()).forEach(line -> rest.all.add(get(line)));
        return rest;
    }

    /** A copy of a line, to be changed and put in. */
    JsonObject copy(int line) {
        return get(line).deepCopy();
    }
}
