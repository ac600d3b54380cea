package uppaal.replay;

import com.google.gson.JsonParseException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import javino.protocol.Payload;

/** What a line says of a packet beside its bytes must be what the bytes say. */
final class Fields {
    private static final Map<Integer, String> ANSWERS = Map.of(8, "delivered", 9, "pieces", 16, "stale");

    private Fields() {
    }

    /** @throws JsonParseException where the event has no packet */
    static Payload payload(Event event) throws RefusedException {
        try {
            event.text("kind");
            Payload payload = Payload.of(javino.protocol.Bytes.ofHex(event.text("payload")));
            check(event, payload);
            return payload;
        } catch (IllegalArgumentException wrong) {
            throw new JsonParseException("a payload that is not in hexadecimal digits", wrong);
        }
    }

    private static void check(Event event, Payload payload) throws RefusedException {
        Map<String, String> said = new LinkedHashMap<>();
        said.put("kind", payload.kind().toString());
        if (payload.kind() != Payload.Kind.NO_FRAME) {
            said.put("destination", payload.destination());
            said.put("origin", payload.origin());
        }
        if (payload.isPiece()) {
            said.put("id", "" + payload.pieceId());
            said.put("index", "" + payload.index());
            said.put("asks", "" + payload.asks());
        } else if (payload.isAcknowledgement()) {
            said.put("answers", ANSWERS.getOrDefault(payload.message().length(), "unknown"));
        } else if (event.fields().has("content")) {
            said.put("content", new String(payload.message().toArray(), StandardCharsets.UTF_8));
        }
        for (Map.Entry<String, String> field : said.entrySet()) {
            String told = event.textOrEmpty(field.getKey());
            if (event.fields().has(field.getKey()) && !told.equals(field.getValue())) {
                throw new RefusedException(event.board() + "'s packet is told with the " + field.getKey() + " '"
                        + Bytes.shown(told) + "'; expected '" + Bytes.shown(field.getValue()) + "', as its bytes say"
                        + (field.getValue().equals("no frame") ? ": the size in their header is not theirs" : ""));
            }
        }
    }
}
