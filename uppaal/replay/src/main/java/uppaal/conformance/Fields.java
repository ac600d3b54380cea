package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import javino.protocol.Bytes;
import javino.protocol.Payload;
import trace.TraceEvent;

/** What a line says of a packet beside its bytes must be what the bytes say. */
final class Fields {
    private static final int MOST_SHOWN = 40;

    private Fields() {
    }

    static void check(TraceEvent event, Payload payload) throws RefusedException {
        event.text("kind");
        for (Map.Entry<String, String> field : fields(payload).entrySet()) {
            String told = event.textOrEmpty(field.getKey());
            require(!event.has(field.getKey()) || told.equals(field.getValue()),
                    event.board() + "'s packet is told with the " + field.getKey() + " '" + shown(told) + "'",
                    "'" + shown(field.getValue()) + "', as its bytes say" + (field.getValue().equals("no frame")
                            ? ": the size in their header is not theirs" : ""));
        }
    }

    private static Map<String, String> fields(Payload payload) {
        Map<String, String> fields = new LinkedHashMap<>();
        fields.put("kind", payload.kind().toString());
        if (payload.kind() != Payload.Kind.NO_FRAME) {
            fields.put("destination", payload.destination());
            fields.put("origin", payload.origin());
        }
        if (payload.isFragment()) {
            fields.put("id", "" + payload.fragmentId());
            fields.put("index", "" + payload.index());
            fields.put("asks", "" + payload.asks());
        } else if (payload.isAcknowledgement()) {
            fields.put("answers", Acknowledgement.of(payload).map(Acknowledgement::kind).orElse("unknown"));
        } else {
            fields.put("content", new String(payload.message().toArray(), StandardCharsets.UTF_8));
        }
        return fields;
    }

    /** Text of somebody else's in one short line. */
    static String shown(String text) {
        String line = text.replaceAll("[\\p{Cc}\\p{Zl}\\p{Zp}\\uFFFD]", "?");
        return line.length() <= MOST_SHOWN ? line : line.substring(0, MOST_SHOWN) + "…";
    }

    static String shown(byte[] content) {
        return "'" + shown(new String(content, StandardCharsets.UTF_8)) + "'";
    }

    static String shown(Bytes content) {
        return content == null ? "what nobody knows" : shown(content.toArray());
    }
}
