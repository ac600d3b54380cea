package highway;

import highway.Observation.Acknowledged;
import highway.Observation.Aired;
import highway.Observation.Hosts;
import highway.Observation.Pin;
import highway.Observation.Spoilt;
import java.util.List;
import java.util.Optional;
import javino.protocol.Bytes;
import javino.protocol.Payload;
import javino.protocol.HostMessage;
import javino.protocol.ProtocolException;
import trace.TraceEvent;

/** The observations in the emulator's trace (emulator/README.md). */
final class Trace {

    /** Kinds of host messages in broadcasts, in the order of their numbers. */
    private static final List<String> WORDS = List.of("handshake 1", "handshake 2", "handshake 3", "renewal 1",
            "renewal 2", "renewal 3", "asks for a part", "asks for the key of the group");

    private Trace() {
    }

    /** The observation of an event; nothing for those that are of no interest here. */
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

    /** The message of one host to another in a broadcast. */
    private static Optional<Hosts> word(TraceEvent event) {
        Payload payload = Payload.of(Bytes.copyOf(event.bytes("payload")));
        if (payload.kind() != Payload.Kind.BROADCAST) {
            return Optional.empty();
        }
        try {
            HostMessage word = HostMessage.decode(payload.message());
            String part = word.kind().fragments() > 1 ? ", part " + (1 + word.fragment()) : "";
            return word.to().map(to -> new Hosts(event.seconds(), event.textOrEmpty("origin"), to.toString(),
                    WORDS.get(word.kind().ordinal()) + part));
        } catch (ProtocolException e) {
            return Optional.empty();
        }
    }

    private static Aired aired(TraceEvent event) {
        return new Aired(event.seconds(), event.textOrEmpty("origin"), event.textOrEmpty("destination"),
                event.textOrEmpty("sealed").equals("true"), event.textOrEmpty("content"));
    }

    private static Optional<Device> device(TraceEvent event) {
        return Device.withId(event.board());
    }
}
