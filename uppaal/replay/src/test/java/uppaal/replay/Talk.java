package uppaal.replay;

import com.google.gson.JsonObject;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HexFormat;

import java.util.Map;
import javino.protocol.Address;
import javino.protocol.Payload;

/** A trace of two boards, the police SUPO and the support SUPP, with what they would send. One event a second. */
final class Talk {
    /** Those of {@code talk.keys}. */
    static final SharedKey PAIR = new SharedKey(HexFormat.of().parseHex("000102030405060708090a0b0c0d0e0f"));
    static final SharedKey GROUP = new SharedKey(HexFormat.of().parseHex("2b7e151628aed2a6abf7158809cf4f3c"));
    static final String LONG = "tell;" + "x".repeat(70);
    private static final Map<Integer, Integer> TYPES = Map.of(0, 6, 1, 7, 8, 8);
    private static final int ASKS_PARITY = 0x10;
    private static final int PIECE = Payload.PART_LENGTH;

    final Lines lines = new Lines();

    {
        lines.madeUp = true;
    }
    private int now;
    private int asked;

    Talk() {
        lines.add(0, "police", "reset", Map.of("why", "power")).add(0, "support", "reset", Map.of("why", "power"));
        greets("police", "SUPO", "000001").greets("support", "SUPP", "000001");
    }

    Talk greets(String board, String id, String epoch) {
        lines.add(++now, board, "host-id", Map.of("id", id, "epoch", epoch));
        return this;
    }

    Talk resets(String board, String why) {
        lines.add(++now, board, "reset", Map.of("why", why));
        asked = board.equals("police") ? 0 : asked;
        return this;
    }

    Talk pauses(int seconds) {
        now += seconds;
        return this;
    }

    /** The police's host wants something to be sent. */
    Talk asks(String destination, String content) {
        now++;
        lines.add(now, "police", "host-transmit",
                Map.of("number", asked++, "destination", destination, "asked", now, "content", content));
        return this;
    }

    /** A board sends a packet, which the other hears. */
    Talk sends(String board, byte[] payload) {
        return unheard(board, payload).heard(board, payload);
    }

    Talk unheard(String board, byte[] payload) {
        now++;
        lines.add(now + 0.3, board, "rf-tx", Map.of("payload", HexFormat.of().formatHex(payload), "kind",
                kind(payload), "start", now, "end", now + 0.3));
        return this;
    }

    private Talk heard(String board, byte[] payload) {
        Map<String, Object> fields = new HashMap<>(Map.of("payload", HexFormat.of().formatHex(payload), "kind",
                kind(payload), "start", now, "end", now + 0.3));
        fields.put("from", board);
        lines.add(now + 0.3, board.equals("support") ? "police" : "support", "rf-rx", fields);
        return this;
    }

    /** The support's host gets the message with this nonce, and takes it. */
    Talk hands(int number, String nonce, String content) {
        now++;
        lines.add(now, "support", "host-handed", Map.of("number", number, "destination", "SUPP", "origin", "SUPO",
                "id", nonce.substring(4, 6) + nonce.substring(8), "content", content));
        lines.add(now + 0.1, "support", "host-taking", Map.of("number", number));
        lines.add(now + 0.2, "support", "host-taken", Map.of("number", number));
        return this;
    }

    static String kind(byte[] payload) {
        return Payload.of(javino.protocol.Bytes.copyOf(payload)).kind().toString();
    }

    static byte[] sealed(String destination, String nonce, String content) {
        return (destination.startsWith("//") ? GROUP : PAIR).seal(destination, "SUPO", HexFormat.of().parseHex(nonce),
                content.getBytes(StandardCharsets.UTF_8));
    }

    static byte[] broadcast(String content) {
        byte[] message = content.getBytes(StandardCharsets.UTF_8);
        return SharedKey.join(SharedKey.header("////", "SUPO", message.length), message);
    }

    /** @param digits of the id and the index */
    static byte[] fragment(String digits, byte[] frame, int index) {
        byte[] message = Arrays.copyOfRange(frame, index * PIECE, Math.min(frame.length, (index + 1) * PIECE));
        return SharedKey.join(SharedKey.header("+F" + digits, "SUPO", message.length), message);
    }

    /** The support acknowledges. */
    static byte[] acknowledgement(String nonce, String body) {
        return acknowledgement(nonce, body, false);
    }

    static byte[] acknowledgement(String nonce, String body, boolean asksParity) {
        byte[] said = HexFormat.of().parseHex(body);
        int type = TYPES.get(said.length) + (asksParity ? ASKS_PARITY : 0);
        byte[] proof = PAIR.proof(type, SharedKey.join(HexFormat.of().parseHex(nonce),
                "SUPOSUPP".getBytes(StandardCharsets.US_ASCII), said));
        return SharedKey.join(
                SharedKey.header(Address.acknowledgement(Frame.lastBits(nonce)).toString(), "SUPP",
                        said.length + proof.length),
                said, proof);
    }

    static byte[] changed(byte[] bytes, int at) {
        byte[] changed = bytes.clone();
        changed[at < 0 ? bytes.length + at : at] ^= 1;
        return changed;
    }

    static byte[] withZeros(byte[] bytes, int last) {
        byte[] changed = bytes.clone();
        Arrays.fill(changed, bytes.length - last, bytes.length, (byte) 0);
        return changed;
    }

    /** The last event, to be changed. */
    JsonObject last() {
        return lines.all.get(lines.all.size() - 1);
    }

    String verdict() {
        return lines.replayWithKeys("talk").verdict();
    }

    String verdictWithoutKeys() {
        return lines.replay().verdict();
    }

}
