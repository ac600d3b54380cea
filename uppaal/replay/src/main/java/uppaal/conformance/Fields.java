package uppaal.conformance;

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

    /** The packet of an event. */
    static Payload payload(TraceEvent event) throws RefusedException {
        Payload payload = Payload.of(Bytes.copyOf(event.bytes("payload")));
        event.text("kind");
        Map<String, String> said = new LinkedHashMap<>();
        said.put("kind", payload.kind().toString());
        if (payload.kind() != Payload.Kind.NO_FRAME) {
            said.put("destination", payload.destination());
            said.put("origin", payload.origin());
        }
        if (payload.isFragment()) {
            said.put("id", "" + payload.fragmentId());
            said.put("index", "" + payload.index());
            said.put("asks", "" + payload.asks());
        } else if (payload.isAcknowledgement()) {
            said.put("answers", Acknowledgement.kind(payload).orElse("unknown"));
        } else if (event.has("content")) {
            said.put("content", new String(payload.message().toArray(), StandardCharsets.UTF_8));
        }
        for (Map.Entry<String, String> field : said.entrySet()) {
            String told = event.textOrEmpty(field.getKey());
            if (event.has(field.getKey()) && !told.equals(field.getValue())) {
                throw new RefusedException(
                        event.board() + "'s packet is told with the " + field.getKey() + " '" + shown(told) + "'",
                        "'" + shown(field.getValue()) + "', as its bytes say" + (field.getValue().equals("no frame")
                                ? ": the size in their header is not theirs" : ""));
            }
        }
        return payload;
    }

    /** Text of somebody else's in one short line. */
    static String shown(String text) {
        String line = text.replaceAll("[\\p{Cc}\\p{Zl}\\p{Zp}\\uFFFD]", "?");
        return line.length() <= MOST_SHOWN ? line : line.substring(0, MOST_SHOWN) + "…";
    }

    static String shown(byte[] content) {
        return content == null ? "what nobody knows" : "'" + shown(new String(content, StandardCharsets.UTF_8)) + "'";
    }
}
