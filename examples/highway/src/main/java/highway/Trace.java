package highway;

import highway.Observation.Acknowledged;
import highway.Observation.Aired;
import highway.Observation.Hosts;
import highway.Observation.Pin;
import highway.Observation.Spoilt;
import java.util.List;
import java.util.Optional;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Payload;
import javino.protocol.HostMessage;
import trace.TraceEvent;

/** What the emulator's trace shows (emulator/README.md). */
final class Trace {

    /** Of a word: its kind and addressee (SPEC 11.3). */
    private static final int HEAD = 4;
    private static final List<String> WORDS = List.of("handshake 1", "handshake 2", "handshake 3", "renewal 1",
            "renewal 2", "renewal 3", "asks for a part", "asks for the key of the group");

    private Trace() {
    }

    /** What an event shows of the scenario; nothing for those that are of no interest here. */
    static Optional<Observation> read(TraceEvent event) {
        double seconds = event.seconds();
        return switch (event.name()) {
            case "rf-tx" -> Optional.of(event.textOrEmpty("kind").equals("acknowledgement")
                    ? new Acknowledged(seconds, event.textOrEmpty("origin"), event.textOrEmpty("answers"))
                    : word(event).<Observation>map(hosts -> hosts).orElseGet(() -> aired(event)));
            case "rf-damaged" ->
                device(event).map(device -> new Spoilt(seconds, device, "a packet: damaged on the air"));
            case "rf-collision" -> device(event).map(device -> new Spoilt(seconds, device, "packets: they collided"));
            case "pin" -> device(event)
                    .map(device -> new Pin(seconds, device, event.textOrEmpty("name"), event.number("level")));
            default -> Optional.empty();
        };
    }

    /** What one host says to another in a broadcast. */
    private static Optional<Hosts> word(TraceEvent event) {
        Payload payload = Payload.of(Bytes.copyOf(event.bytes("payload")));
        Bytes word = payload.message();
        if (payload.kind() != Payload.Kind.BROADCAST || word.length() < HEAD || !HostMessage.isHostMessage(word)) {
            return Optional.empty();
        }
        Address to = new Address((int) word.number(1, 4));
        int kind = word.at(0) - 0x80 >> 2;
        String part = kind == 1 ? ", part " + (1 + word.at(0) % 4) : "";
        return Optional.of(new Hosts(event.seconds(), event.textOrEmpty("origin"), to.toString(),
                (kind < WORDS.size() ? WORDS.get(kind) : "unknown") + part));
    }

    private static Aired aired(TraceEvent event) {
        return new Aired(event.seconds(), event.textOrEmpty("origin"), event.textOrEmpty("destination"),
                event.textOrEmpty("sealed").equals("true"), event.textOrEmpty("content"));
    }

    private static Optional<Device> device(TraceEvent event) {
        return Device.withId(event.board());
    }
}
