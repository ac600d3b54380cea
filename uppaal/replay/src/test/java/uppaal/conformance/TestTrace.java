package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import javino.protocol.Address;
import javino.protocol.Airtime;
import javino.protocol.Bytes;
import javino.protocol.Counter;
import javino.protocol.Crc16;
import javino.protocol.Payload;

/**
 * A trace of two boards, the police SUPO and the support SUPP, by a script: one step a second, steps with a {@code ;}
 * between them. A step is
 *
 * <pre>
 * BOARD boots [EPOCH]            a reset, with what a board declares then, and hello
 * BOARD asks TO CONTENT          its host wants a message to be sent; numbers from 0 on
 * BOARD seals NUMBER [KEY]       it is taken up
 * BOARD sends NUMBER PACKET      all of it, or the last fragment; with a trailer: + mark, + parity
 * BOARD parts NUMBER PACKET      another fragment
 * BOARD answers KIND PACKET      it owes and sends an acknowledgement; !KIND: as the tag of the whole was wrong
 * BOARD throws PACKET            a packet that it does not declare
 * BOARD queues NONCE [KEY]       its inbox takes a message in
 * BOARD hands NUMBER TO ID CONTENT   its host is handed it, from the police
 * BOARD stores AT RECORD…        records, each with its seal, one behind the other in its EEPROM
 * BOARD does EVENT FIELD=VALUE…  any other event
 * BOARD POINT OPERAND=VALUE…     any point
 * </pre>
 *
 * and a packet is
 *
 * <pre>
 * s:TO:COUNTER:CONTENT   sealed by the police in epoch 1, or with all of a nonce
 * c:TO:COUNTER:CONTENT   the same, but in the clear
 * b:CONTENT              its broadcast
 * f:DIGITS:PACKET        a fragment of that with these digits of id and index
 * a:COUNTER:BODY         the support's acknowledgement to it; p: asks for parity
 * x:BYTES                anything
 * </pre>
 *
 * with {@code ~N} behind it where byte N is wrong, from the end if negative. {@code LONG} is a long content.
 */
final class TestTrace {
    static final SharedKey PAIR = key("000102030405060708090a0b0c0d0e0f");
    private static final SharedKey GROUP = key("2b7e151628aed2a6abf7158809cf4f3c");
    private static final Map<String, String> IDS = Map.of("police", "SUPO", "support", "SUPP");
    private static final Map<Integer, Integer> TYPES = Map.of(0, 6, 1, 7, 8, 8);
    private static final int ALL = 0xFF;
    static final int SEALED_BYTES = Payload.NONCE_LENGTH + Payload.TAG_LENGTH;
    private static final String KEYS = "src/test/resources/traces/talk.keys";
    private static final double RATE = 4000;

    final List<JsonObject> lines = new ArrayList<>();
    private double now;
    private int asked;
    /** How many packets, each of which comes to the other board. */
    private int sent;
    private final Map<String, Integer> came = new HashMap<>();
    private final Map<String, String> turns = new HashMap<>();

    TestTrace(String script) {
        JsonArray boards = new JsonArray();
        IDS.keySet().stream().sorted().map(name -> "name=" + name).map(TestTrace::fields).forEach(boards::add);
        JsonObject scenario = add("", "scenario", "version=3");
        scenario.add("radio", fields("bitRate=" + (int) RATE));
        scenario.add("boards", boards);
        run("police boots; support boots; " + script);
    }

    private static SharedKey key(String hex) {
        return SharedKey.of(Bytes.ofHex(hex));
    }

    private void run(String script) {
        for (String step : script.split("; ")) {
            String[] words = step.split(" ");
            now++;
            run(words[0], words[1], words);
        }
    }

    private void run(String board, String verb, String... words) {
        String third = words.length > 2 ? words[2] : "";
        switch (verb) {
            case "boots" -> {
                String epoch = third.isEmpty() ? "000001" : third;
                add(board, "reset", "why=power");
                turns.remove(board);
                store(board, "100", epoch);
                store(board, "200", epoch);
                point(board, "EPOCH_STORED", "low=" + Integer.parseInt(epoch.substring(4), 16));
                point(board, "MEMORY", "kept=0");
                point(board, "QUIET");
                add(board, "host-id", "id=" + IDS.get(board), "epoch=" + epoch);
                asked = board.equals("police") ? 0 : asked;
            }
            case "asks" -> add(board, "host-transmit", "number=" + asked++, "destination=" + third, "asked=" + now,
                    "content=" + content(words[3]));
            case "seals" -> point(board, "TAKE_UP", "number=" + third, "key=" + (words.length > 3 ? words[3] : 0));
            case "sends", "parts" -> {
                Bytes packet = packet(words[3]);
                point(board, "SEND", "number=" + third,
                        "pending=" + ((verb.equals("parts") ? ALL : 1) << Payload.of(packet).index()));
                send(board, packet, words.length > 5 ? "trailer=" + words[5] : "");
            }
            case "answers" -> {
                Bytes packet = packet(words[3]);
                int nonce = Payload.of(packet).answered() & 0xFF;
                if (third.startsWith("!")) {
                    point(board, "COUNT", "counter=" + Counter.RADIO_BAD_TAG.number());
                }
                if (!third.equals("nothing")) {
                    point(board, "OWE_" + third.replace("!", ""), "nonce=" + nonce, "key=0");
                }
                point(board, "ANSWER", "key=0");
                send(board, packet, "");
            }
            case "throws" -> send(board, packet(third), "");
            case "queues" -> point(board, "QUEUED", "nonce=" + third, "key=" + (words.length > 3 ? words[3] : 0));
            case "hands" -> {
                point(board, "HANDED", "message=" + third);
                add(board, "host-handed", "number=" + third, "destination=" + words[3], "origin=SUPO",
                        "id=" + words[4], "content=" + content(words[5]));
            }
            case "stores" -> store(board, Arrays.copyOfRange(words, 2, words.length));
            case "does" -> add(board, third, Arrays.copyOfRange(words, 3, words.length));
            default -> point(board, verb, Arrays.copyOfRange(words, 2, words.length));
        }
    }

    /** A point of a number, with its turn. */
    private void point(String board, String name, String... operands) {
        if (operands.length != 0 && operands[0].startsWith("number=") && !name.equals("TURN")
                && !operands[0].equals(turns.put(board, operands[0]))) {
            point(board, "TURN", operands[0]);
        }
        JsonObject point = add(board, "point", operands);
        point.addProperty("name", name);
        point.addProperty("run", now);
        point.addProperty("gap", now);
        if (came.containsKey(board)) {
            point.addProperty("packet", came.get(board));
        }
    }

    private void store(String board, String... words) {
        Bytes all = Bytes.EMPTY;
        for (String record : Arrays.copyOfRange(words, 1, words.length)) {
            int crc = Crc16.of(Bytes.ofHex(record));
            int[] seal = {crc >> 8, crc & 0xFF, crc >> 8 ^ crc & 0xFF};
            all = Bytes.join(all, Bytes.ofHex(record),
                    Bytes.of(Arrays.stream(seal).map(each -> each == 0xFF ? 0 : each).toArray()));
        }
        add(board, "eeprom", "at=" + words[0], "length=" + all.length(), "hex=" + all.hex());
    }

    private JsonObject add(String board, String event, String... more) {
        JsonObject line = fields(more);
        line.addProperty("t", now);
        line.addProperty("event", event);
        if (!board.isEmpty()) {
            line.addProperty("board", board);
        }
        lines.add(line);
        return line;
    }

    private static JsonObject fields(String... fields) {
        JsonObject object = new JsonObject();
        for (String field : fields) {
            String[] pair = field.split("=", 2);
            if (pair.length == 2) {
                object.addProperty(pair[0], pair[1]);
            }
        }
        return object;
    }

    private void send(String board, Bytes packet, String trailer) {
        sent++;
        double start = now + 0.01;
        int bits = Airtime.bits(packet.length());
        String kind = Payload.of(packet).kind().toString();
        now = start + bits / RATE;
        String[] fields = {"packet=" + sent, "payload=" + packet.hex(), "kind=" + kind, "start=" + start,
                "end=" + now, "bits=" + bits, trailer};
        add(board, "rf-tx", fields);
        String other = board.equals("support") ? "police" : "support";
        add(other, "rf-rx", fields).addProperty("from", board);
        came.put(other, sent);
    }

    static String content(String word) {
        return word.startsWith("LONG") ? "x".repeat(75 + word.length()) : word;
    }

    static Bytes packet(String words) {
        String[] spoilt = words.split("~");
        byte[] packet = rightPacket(spoilt[0]).toArray();
        for (String place : Arrays.copyOfRange(spoilt, 1, spoilt.length)) {
            packet[Math.floorMod(Integer.parseInt(place), packet.length)] ^= 1;
        }
        return Bytes.copyOf(packet);
    }

    private static Bytes rightPacket(String words) {
        String[] word = words.split(":", 3);
        switch (word[0]) {
            case "s", "c":
                String[] more = word[2].split(":", 2);
                Bytes content = Bytes.ofText(content(more[1]));
                Bytes head = Bytes.join(header(word[1], "SUPO", content.length() + SEALED_BYTES), nonce(more[0]));
                Bytes frame = (word[1].startsWith("//") ? GROUP : PAIR).seal(head, content);
                return word[0].equals("s") ? frame
                        : Bytes.join(head, content, frame.from(head.length() + content.length()));
            case "b":
                return frame("////", "SUPO", Bytes.ofText(content(word[1])));
            case "f":
                List<Bytes> parts = packet(word[2]).split(Payload.PART_LENGTH).toList();
                int index = (word[1].charAt(1) - 'A') % 8;
                return frame("+F" + word[1], "SUPO", index < parts.size() ? parts.get(index) : Bytes.EMPTY);
            case "a", "p":
                Bytes nonce = nonce(word[1]);
                Bytes body = Bytes.ofHex(word[2]);
                int type = TYPES.getOrDefault(body.length(), 0)
                        + (word[0].equals("p") ? SharedKey.ASKS_PARITY : 0);
                return frame(Address.acknowledgement((int) nonce.number(4, 6) & 0xFFF).toString(), "SUPP",
                        Bytes.join(body, PAIR.proof(type, nonce, "SUPOSUPP", body)));
            default:
                return Bytes.ofHex(word[1]);
        }
    }

    private static Bytes frame(String destination, String origin, Bytes message) {
        return Bytes.join(header(destination, origin, message.length()), message);
    }

    static Bytes header(String destination, String origin, int length) {
        return javino.protocol.Frame.header(Address.parse(destination), Address.parse(origin), length);
    }

    private static Bytes nonce(String counter) {
        return Bytes.ofHex(counter.length() > 6 ? counter : "000001" + "0".repeat(6 - counter.length()) + counter);
    }

    static void assertAccepted(String verdict) {
        assertTrue(verdict.contains("accepted"), verdict);
    }

    static void assertRefused(String verdict, String why) {
        assertTrue(verdict.contains("refused at event ") && verdict.contains(why), verdict);
        assertEquals(1, verdict.lines().count());
    }

    String verdict(Function<Header, Check> check) {
        return verdict(check, Optional.of(Path.of(KEYS)));
    }

    String verdictWithoutKeys(Function<Header, Check> check) {
        return verdict(check, Optional.empty());
    }

    private String verdict(Function<Header, Check> check, Optional<Path> keys) {
        Replay replay = new Replay(List.of(check), keys);
        lines.forEach(line -> replay.line(line.toString()));
        replay.finish();
        return replay.verdict();
    }
}
