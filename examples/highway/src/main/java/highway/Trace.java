package highway;

import highway.Observation.Kind;
import java.util.List;
import java.util.Optional;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.Payload;
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
        return switch (event.name()) {
            case "rf-tx" -> Optional.of(packet(event));
            case "rf-damaged" -> of(event, Kind.LOSES, "a packet: damaged on the air");
            case "rf-collision" -> of(event, Kind.LOSES, "packets: they collided");
            case "pin" ->
                of(event, Kind.PIN, event.textOrEmpty("name") + (event.number("level") == 1 ? " on" : " off"));
            default -> Optional.empty();
        };
    }

    private static Optional<Observation> of(TraceEvent event, Kind kind, String text) {
        return Device.withId(event.board())
                .map(device -> new Observation(event.seconds(), kind, device.address, "", text));
    }

    private static Observation packet(TraceEvent event) {
        String origin = event.textOrEmpty("origin");
        if (event.textOrEmpty("kind").equals("acknowledgement")) {
            return new Observation(event.seconds(), Kind.ACKS, origin, "", event.textOrEmpty("answers"));
        }
        boolean sealed = event.textOrEmpty("sealed").equals("true");
        return betweenHosts(event).orElseGet(() -> new Observation(event.seconds(), sealed ? Kind.SEALED : Kind.SENDS,
                origin, event.textOrEmpty("destination"), sealed ? "" : event.textOrEmpty("content")));
    }

    /** The message of one host to another in a broadcast, before they have a key (SPEC 11.3). */
    private static Optional<Observation> betweenHosts(TraceEvent event) {
        Payload payload = Payload.of(Bytes.copyOf(event.bytes("payload")));
        if (payload.kind() != Payload.Kind.BROADCAST) {
            return Optional.empty();
        }
        try {
            HostMessage word = HostMessage.decode(payload.message());
            String part = word.kind().fragments() > 1 ? ", part " + (1 + word.fragment()) : "";
            return word.to().map(to -> new Observation(event.seconds(), Kind.HOSTS, event.textOrEmpty("origin"),
                    to.toString(), WORDS.get(word.kind().ordinal()) + part));
        } catch (ProtocolException e) {
            return Optional.empty();
        }
    }
}
