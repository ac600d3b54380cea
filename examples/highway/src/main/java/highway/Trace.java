package highway;

import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import highway.Observation.Acknowledged;
import highway.Observation.Aired;
import highway.Observation.Hosts;
import highway.Observation.Pin;
import highway.Observation.Spoilt;
import java.util.List;
import java.util.Optional;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;

/** Reads the emulator's trace, one JSON line an event (emulator/README.md). */
final class Trace {

    /** In the payload of a packet: header, and then kind and addressee of a host message (SPEC 2, 11.3). */
    private static final int MESSAGE = 10;
    private static final int BODY = MESSAGE + 4;
    private static final List<String> KINDS = List.of("handshake 1", "handshake 2", "handshake 3", "renewal 1",
            "renewal 2", "renewal 3", "asks for a part", "asks for the key of the group");

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
                    ? new Acknowledged(seconds, text(event, "origin"), text(event, "answers"))
                    : hostMessage(event).<Observation>map(hosts -> hosts).orElseGet(() -> aired(seconds, event)));
            case "rf-damaged" ->
                device(event).map(device -> new Spoilt(seconds, device, "a packet: damaged on the air"));
            case "rf-collision" -> device(event).map(device -> new Spoilt(seconds, device, "packets: they collided"));
            case "pin" -> device(event)
                    .map(device -> new Pin(seconds, device, text(event, "name"), event.get("level").getAsInt()));
            default -> Optional.empty();
        };
    }

    /** What one host says to another in a broadcast. */
    private Optional<Hosts> hostMessage(JsonObject event) {
        Bytes frame = Bytes.ofHex(text(event, "payload"));
        boolean isHostMessage = text(event, "kind").equals("broadcast") && frame.length() >= BODY
                && HostMessage.isHostMessage(frame.from(MESSAGE));
        if (!isHostMessage) {
            return Optional.empty();
        }
        Bytes message = frame.from(MESSAGE);
        Address to = new Address((int) message.number(1, 4));
        int kind = message.at(0) - 0x80 >> 2;
        String part = kind == 1 ? ", part " + (1 + message.at(0) % 4) : "";
        return Optional.of(new Hosts(seconds, text(event, "origin"), to.toString(),
                (kind < KINDS.size() ? KINDS.get(kind) : "unknown") + part));
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
