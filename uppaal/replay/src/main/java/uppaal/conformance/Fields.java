package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.nio.charset.StandardCharsets;
import javino.protocol.Bytes;
import javino.protocol.Payload;
import trace.TraceEvent;

/** A line's fields about a packet must be those that its bytes tell. */
final class Fields {
    private static final int MOST_SHOWN = 40;

    private Fields() {
    }

    static void check(TraceEvent event, Payload payload) throws RefusedException {
        event.text("kind");
        compare(event, "kind", payload.kind());
        compare(event, "destination", payload.destination());
        compare(event, "origin", payload.origin());
        if (payload.isFragment()) {
            compare(event, "id", payload.fragmentId());
            compare(event, "index", payload.index());
            compare(event, "asks", payload.asks());
        } else if (payload.isAcknowledgement()) {
            compare(event, "answers", Acknowledgement.of(payload).map(Acknowledgement::kind).orElse("unknown"));
        } else {
            compare(event, "content", new String(payload.message().toArray(), StandardCharsets.UTF_8));
        }
    }

    private static void compare(TraceEvent event, String field, Object said) throws RefusedException {
        String told = event.textOrEmpty(field);
        require(!event.has(field) || told.equals(said.toString()),
                event.board() + "'s packet is told with the " + field + " '" + shown(told) + "'",
                "'" + shown(said.toString()) + "', as its bytes say");
    }

    /** Text of somebody else's in one short line. */
    static String shown(String text) {
        String line = text.replaceAll("[\\p{Cc}\\p{Zl}\\p{Zp}\\uFFFD]", "?");
        return line.length() <= MOST_SHOWN ? line : line.substring(0, MOST_SHOWN) + "…";
    }

    static String shown(Bytes content) {
        return content == null ? "what nobody knows"
                : "'" + shown(new String(content.toArray(), StandardCharsets.UTF_8)) + "'";
    }
}
