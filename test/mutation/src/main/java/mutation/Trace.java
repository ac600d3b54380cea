package mutation;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** The events of a trace of the emulator, in which some can be changed. */
final class Trace {

    /** How exactly the start of a packet is told by those that hear it. */
    private static final double SAME_START = 0.001;
    private static final int MICROSECONDS = 6;

    private final List<JsonObject> events;

    /**
     * A transmission.
     *
     * @param sent  its {@code rf-tx}
     * @param heard what other boards had of it
     */
    record Packet(JsonObject sent, List<JsonObject> heard) {
        List<JsonObject> all() {
            List<JsonObject> all = new ArrayList<>(List.of(sent));
            all.addAll(heard);
            return all;
        }

        double start() {
            return number(sent, "start");
        }

        double end() {
            return number(sent, "end");
        }

        double middle() {
            return (start() + end()) / 2;
        }

        String board() {
            return text(sent, "board");
        }

        String payload() {
            return text(sent, "payload");
        }

        boolean isHeardBy(String board) {
            return heard.stream().anyMatch(event -> text(event, "board").equals(board));
        }
    }

    Trace(List<String> lines) {
        events = new ArrayList<>(lines.stream().map(line -> JsonParser.parseString(line).getAsJsonObject()).toList());
    }

    List<JsonObject> events() {
        return events;
    }

    List<String> lines() {
        return events.stream().map(JsonObject::toString).toList();
    }

    /** All transmissions, in the order of the trace. */
    List<Packet> packets() {
        return events.stream().filter(event -> is(event, "rf-tx")).map(sent -> new Packet(sent, events.stream()
                .filter(event -> event.has("from") && text(event, "from").equals(text(sent, "board"))
                        && Math.abs(number(event, "start") - number(sent, "start")) < SAME_START)
                .toList())).toList();
    }

    /** Has an event, with all its times, happen so many seconds later; where that is puts it among the others. */
    void move(JsonObject event, double seconds) {
        for (String time : List.of("t", "start", "end", "asked")) {
            if (event.has(time)) {
                set(event, time, number(event, time) + seconds);
            }
        }
        place(event);
    }

    /** Puts an event where its time says; those of its time stay before it. */
    void place(JsonObject event) {
        events.removeIf(other -> other == event);
        int at = IntStream.range(0, events.size())
                .filter(i -> number(events.get(i), "t") > number(event, "t")).findFirst().orElse(events.size());
        events.add(at, event);
    }

    static boolean is(JsonObject event, String name) {
        return text(event, "event").equals(name);
    }

    static String text(JsonObject event, String field) {
        return event.has(field) ? event.get(field).getAsString() : "";
    }

    static double number(JsonObject event, String field) {
        return event.get(field).getAsDouble();
    }

    /** In seconds, with microseconds as the emulator writes them. */
    static void set(JsonObject event, String field, double seconds) {
        event.add(field, new JsonPrimitive(BigDecimal.valueOf(seconds).setScale(MICROSECONDS, RoundingMode.HALF_UP)));
    }
}
