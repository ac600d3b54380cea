package uppaal.replay;

import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.Map;

/** What a line says of a packet beside its bytes must be what the bytes say. */
final class Fields {
    private static final int ADDRESS = 4;
    private static final int INDEX_AT = 3;
    private static final int INDEXES = 16;
    private static final Map<Integer, String> ANSWERS = Map.of(8, "delivered", 9, "fragments", 16, "stale");

    private Fields() {
    }

    static void check(Event event, Payload payload) throws RefusedException {
        Map<String, String> said = new LinkedHashMap<>();
        said.put("kind", kind(payload));
        if (!said.get("kind").equals("no frame")) {
            said.put("destination", payload.destination());
            said.put("origin", payload.origin());
        }
        if (payload.isPiece()) {
            said.put("id", "" + payload.pieceId());
            said.put("index", "" + payload.index());
            said.put("asks", "" + payload.asks());
        } else if (payload.isAcknowledgement()) {
            said.put("answers", ANSWERS.getOrDefault(payload.message().length, "unknown"));
        } else if (event.fields().has("content")) {
            said.put("content", new String(payload.message(), StandardCharsets.UTF_8));
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

    private static String kind(Payload payload) {
        byte[] frame = HexFormat.of().parseHex(payload.hex());
        if (Payload.lengthIn(frame) != frame.length) {
            return "no frame";
        }
        String to = new String(frame, 0, ADDRESS, StandardCharsets.US_ASCII);
        if (to.startsWith("//")) {
            return to.equals(Payload.ALL) ? "broadcast" : "multicast";
        }
        if (to.startsWith("+F") && Payload.digit(to, INDEX_AT) < INDEXES) {
            return "fragment";
        }
        return to.startsWith("+K") ? "acknowledgement" : to.matches("[+/].*") ? "reserved" : "unicast";
    }
}
