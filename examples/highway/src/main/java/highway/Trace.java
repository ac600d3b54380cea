package highway;

import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import highway.Observation.Acknowledged;
import highway.Observation.Aired;
import highway.Observation.Pin;
import highway.Observation.Spoilt;
import java.util.Optional;

/** Reads the emulator's trace, one JSON line an event (emulator/README.md). */
final class Trace {

    private double seconds;

    /** Emulated time of the last event: what happens outside of the emulator is not earlier than that. */
    double seconds() {
        return seconds;
    }

    /**
     * What a line shows of the scenario; nothing for events that are of no interest here.
     *
     * @throws JsonParseException if it is no event: a message of the emulator, or cut off
     */
    Optional<Observation> read(String line) {
        if (!line.startsWith("{")) {
            throw new JsonParseException(line);
        }
        JsonObject event = JsonParser.parseString(line).getAsJsonObject();
        seconds = event.get("t").getAsDouble();
        return switch (text(event, "event")) {
            case "rf-tx" -> Optional.of(text(event, "kind").equals("acknowledgement")
                    ? new Acknowledged(seconds, text(event, "origin"), text(event, "answers")) : aired(seconds, event));
            case "rf-damaged" ->
                device(event).map(device -> new Spoilt(seconds, device, "a packet: damaged on the air"));
            case "rf-collision" -> device(event).map(device -> new Spoilt(seconds, device, "packets: they collided"));
            case "pin" -> device(event)
                    .map(device -> new Pin(seconds, device, text(event, "name"), event.get("level").getAsInt()));
            default -> Optional.empty();
        };
    }

    private static Aired aired(double seconds, JsonObject event) {
        return new Aired(seconds, text(event, "origin"), text(event, "destination"),
                event.has("sealed") && event.get("sealed").getAsBoolean(), text(event, "content"));
    }

    private static Optional<Device> device(JsonObject event) {
        return Device.withId(text(event, "board"));
    }

    private static String text(JsonObject event, String key) {
        return event.has(key) ? event.get(key).getAsString() : "";
    }
}
