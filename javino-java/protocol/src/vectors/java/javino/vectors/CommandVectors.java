package javino.vectors;

import static javino.vectors.Vectors.vector;
import static javino.vectors.Wire.bytes;
import static javino.vectors.Wire.counting;
import static javino.vectors.Wire.join;
import static javino.vectors.Wire.text;

import java.util.List;
import java.util.Map;

/** SPEC 4.3 and 4.4: each command, each record of a poll, each status. */
final class CommandVectors {

    /** SPEC 4.5, from number 1 on. */
    private static final List<String> COUNTERS = List.of("serialRequests", "serialDamaged", "serialBadFrames",
            "serialRepeats", "radioReceived", "radioDamaged", "radioMissed", "radioBadFrames", "radioReserved",
            "radioNotForUs", "radioOwn", "radioNoKey", "radioBadTag", "radioReplayed", "radioReplayFull",
            "radioQueueFull", "radioSent", "perceptsLeftOut", "radioRepeats", "radioFragmentsDropped", "radioExpired",
            "radioAcknowledged", "radioUndelivered", "radioBadProofs", "radioResent", "radioDeferred", "radioStale",
            "radioMended", "radioBlocked", "radioAnswersDropped", "radioDoubtful", "radioAnswersTolerated",
            "radioOverheardDropped",
            "relayCopies", "relayAnswers", "relayRefused", "memoryDamaged", "loopMillis", "perceptsMillis",
            "actionMillis",
            "radioLateMicros", "radioAirtime", "airtimeWait");

    private static final byte[] FRAME = text("+KAACAFEBA12345678");

    private CommandVectors() {
    }

    static Map<String, List<Map<String, Object>>> all() {
        var lists = Vectors.lists("requests", requests());
        lists.put("badRequests", badRequests());
        lists.put("replies", replies());
        lists.put("badReplies", badReplies());
        return lists;
    }

    private static List<Map<String, Object>> requests() {
        byte[] key = counting(0, 16);
        return List.of(
                vector("name", "hello", "version", 1, "message", "4801"),
                poll("none", 0, 0, null, "here"), poll("changed", 1000, 0, null, "here"),
                poll("now", 0xFFFF, 0xFFFFFF, 0, "here"), poll("changed", 1000, 500, 255, "lost"),
                poll("none", 1000, 0, 7, "lost"), poll("changed", 1000, 0, 8, "coming"),
                vector("name", "act", "action", "stop", "message", Wire.hex(text("Astop"))),
                vector("name", "act", "action", "goTo(12,\"\u00e9\")",
                        "message", Wire.hex(text("AgoTo(12,\"\u00e9\")"))),
                vector("name", "listActions", "offset", 0, "message", "430000"),
                vector("name", "listActions", "offset", 0xFFFE, "message", "43fffe"),
                vector("name", "setRfId", "address", "ROMA", "message", Wire.hex(text("IROMA"))),
                vector("name", "radio", "open", true, "message", "5201"),
                vector("name", "radio", "open", false, "message", "5200"),
                vector("name", "overhear", "on", true, "message", "4f01"),
                vector("name", "overhear", "on", false, "message", "4f00"),
                vector("name", "relaying", "on", true, "number", 470, "message", "570101d6"),
                vector("name", "relaying", "on", false, "message", "5700"),
                vector("name", "isRelaying", "message", "57"),
                vector("name", "relay", "frame", Wire.hex(FRAME), "message", Wire.hex(join(text("Y"), FRAME))),
                vector("name", "raiseEpoch", "epoch", 0, "message", "45000000"),
                vector("name", "raiseEpoch", "epoch", 470_012, "message", "45072bfc"),
                vector("name", "setKey", "address", "SUPO", "key", Wire.hex(key),
                        "message", Wire.hex(join(text("KSUPO"), key))),
                vector("name", "setKey", "address", "//SU", "key", Wire.hex(key),
                        "message", Wire.hex(join(text("K//SU"), key))),
                vector("name", "renewKey", "address", "SUPO", "key", Wire.hex(counting(16, 16)),
                        "message", Wire.hex(join(text("NSUPO"), counting(16, 16)))),
                vector("name", "renewKey", "address", "//SU", "key", Wire.hex(counting(16, 16)),
                        "message", Wire.hex(join(text("N//SU"), counting(16, 16)))),
                vector("name", "useKey", "address", "SUPO", "message", Wire.hex(text("USUPO"))),
                vector("name", "useKey", "address", "//SU", "message", Wire.hex(text("U//SU"))),
                vector("name", "finishRenewal", "address", "SUPO", "message", Wire.hex(text("FSUPO"))),
                vector("name", "deleteKey", "address", "//SU", "message", Wire.hex(text("D//SU"))),
                vector("name", "setSessionKey", "address", "ROMA", "key", Wire.hex(key),
                        "message", Wire.hex(join(text("VROMA"), key))),
                vector("name", "listKeys", "message", "4c"),
                vector("name", "statistics", "message", "53"),
                transmit("////", "ROMA", "tell;help"),
                transmit("//SU", "SUPO", "tell;someoneNeedHelp"),
                transmit("SUHO", "SUPP", "achieve;goTo(12,\"km\")"),
                transmit("////", "ROMA", "tell;" + "x".repeat(489)));
    }

    private static Map<String, Object> poll(String percepts, int hold, int least, Integer taken, String lastReply) {
        int flags = List.of("none", "changed", "", "now").indexOf(percepts)
                + 4 * List.of("here", "lost", "coming").indexOf(lastReply);
        byte[] body = bytes('P', flags, hold >> 8, hold & 0xFF,
                least >> 16, least >> 8 & 0xFF, least & 0xFF);
        return vector("name", "poll", "percepts", percepts, "hold", hold, "least", least, "taken", taken, "lastReply",
                lastReply, "message", Wire.hex(taken == null ? body : join(body, bytes(taken))));
    }

    private static Map<String, Object> transmit(String destination, String origin, String content) {
        return vector("name", "transmit", "destination", destination, "origin", origin, "content", content,
                "message", Wire.hex(text(content)));
    }

    /** Requests that are no commands, and the answers of a greeted board without a key. */
    private static List<Map<String, Object>> badRequests() {
        return List.of(
                badRequest(bytes('Z'), "UNKNOWN_COMMAND"),
                badRequest(bytes(0), "UNKNOWN_COMMAND"),
                badRequest(bytes('h', 1), "UNKNOWN_COMMAND"),
                badRequest(bytes('P'), "BAD_ARGUMENT"),
                badRequest(bytes('P', 0, 0, 0, 0, 0), "BAD_ARGUMENT"),
                badRequest(bytes('P', 0, 0, 0, 0, 0, 0, 1, 2), "BAD_ARGUMENT"),
                badRequest(bytes('P', 2, 0, 0, 0, 0, 0), "BAD_ARGUMENT"),
                badRequest(bytes('P', 6, 0, 0, 0, 0, 0), "BAD_ARGUMENT"),
                badRequest(bytes('P', 16, 0, 0, 0, 0, 0), "BAD_ARGUMENT"),
                badRequest(bytes('R'), "BAD_ARGUMENT"),
                badRequest(bytes('R', 2), "BAD_ARGUMENT"),
                badRequest(bytes('O'), "BAD_ARGUMENT"),
                badRequest(bytes('O', 2), "BAD_ARGUMENT"),
                badRequest(bytes('Y'), "BAD_ARGUMENT"),
                badRequest(bytes('W', 2), "BAD_ARGUMENT"),
                badRequest(bytes('W', 1), "BAD_ARGUMENT"),
                badRequest(bytes('W', 1, 0), "BAD_ARGUMENT"),
                badRequest(bytes('W', 1, 0, 0, 0), "BAD_ARGUMENT"),
                badRequest(bytes('W', 2, 0, 0), "BAD_ARGUMENT"),
                badRequest(bytes('W', 0, 0, 0), "BAD_ARGUMENT"),
                badRequest(text("Y////CAFEAI"), "BAD_ARGUMENT"),
                badRequest(text("Y////++++AIx"), "BAD_ARGUMENT"),
                badRequest(text("Y+AAACAFEAIx"), "BAD_DESTINATION"),
                badRequest(bytes('C'), "BAD_ARGUMENT"),
                badRequest(bytes('C', 0, 0, 0), "BAD_ARGUMENT"),
                badRequest(bytes('C', 0), "BAD_ARGUMENT"),
                badRequest(text("IROM"), "BAD_ARGUMENT"),
                badRequest(text("IROMAA"), "BAD_ARGUMENT"),
                badRequest(text("I////"), "BAD_ARGUMENT"),
                badRequest(text("I//SU"), "BAD_ARGUMENT"),
                badRequest(text("I++++"), "BAD_ARGUMENT"),
                badRequest(text("IRO-A"), "BAD_ARGUMENT"),
                badRequest(text("KROMA0123456789abcde"), "BAD_ARGUMENT"),
                badRequest(text("KROMA0123456789abcdefg"), "BAD_ARGUMENT"),
                badRequest(text("K////0123456789abcdef"), "BAD_ARGUMENT"),
                badRequest(text("K+FAA0123456789abcdef"), "BAD_ARGUMENT"),
                badRequest(text("NROMA0123456789abcde"), "BAD_ARGUMENT"),
                badRequest(text("NROMA0123456789abcdefg"), "BAD_ARGUMENT"),
                badRequest(text("N////0123456789abcdef"), "BAD_ARGUMENT"),
                badRequest(text("N+KAA0123456789abcdef"), "BAD_ARGUMENT"),
                badRequest(text("E"), "BAD_ARGUMENT"),
                badRequest(bytes('E', 0, 1), "BAD_ARGUMENT"),
                badRequest(bytes('E', 0, 1, 2, 3), "BAD_ARGUMENT"),
                badRequest(bytes('E', 0xFF, 0xFF, 0xFF), "BAD_ARGUMENT"),
                badRequest(text("NROMA0123456789abcdef"), "NO_KEY"),
                badRequest(text("UROM"), "BAD_ARGUMENT"),
                badRequest(text("UROMAA"), "BAD_ARGUMENT"),
                badRequest(text("U////"), "BAD_ARGUMENT"),
                badRequest(text("UROMA"), "NO_KEY"),
                badRequest(text("FROMA"), "NO_KEY"),
                badRequest(text("FROM"), "BAD_ARGUMENT"),
                badRequest(text("FROMAA"), "BAD_ARGUMENT"),
                badRequest(text("DROM"), "BAD_ARGUMENT"),
                badRequest(text("VROMA0123456789abcde"), "BAD_ARGUMENT"),
                badRequest(text("VROMA0123456789abcdefg"), "BAD_ARGUMENT"),
                badRequest(text("V//SU0123456789abcdef"), "BAD_ARGUMENT"),
                badRequest(text("V+KAA0123456789abcdef"), "BAD_ARGUMENT"));
    }

    private static Map<String, Object> polled(boolean more, boolean leftOut, boolean reading, boolean damaged,
            Integer takenTimer, List<?> records) {
        return vector("more", more, "leftOut", leftOut, "reading", reading, "damaged", damaged, "takenTimer",
                takenTimer, "records", records);
    }

    private static Map<String, Object> timerTaken(int flags, boolean damaged, int timer) {
        return ok("poll", bytes(flags), polled(false, false, false, damaged, timer, List.of()));
    }

    private static Map<String, Object> badRequest(byte[] message, String status) {
        return vector("message", Wire.hex(message), "status", status);
    }

    private static List<Map<String, Object>> replies() {
        return List.of(
                hello(1, null, 1, 3, "blink 1.0"), hello(2, "ROMA", 0xFFFFFE, 3, ""),
                hello(1, null, 0, 0, "blink 1.0"), hello(1, "ROMA", 1, 7, "\u00e9"), hello(1, "ROMA", 2, 0x1F, " "),
                hello(1, "ROMA", 7, null, "blink 1.0"), hello(1, "ROMA", 7, null, "\u00e9"),
                hello(1, null, 0, null, ""),
                ok("poll", bytes(0),
                        polled(false, false, false, false, null, List.of())),
                ok("poll", bytes(4),
                        polled(false, false, true, false, null, List.of())),
                ok("poll", join(bytes(1), bytes('T', 0, 2, 9, 0), bytes('T', 0, 2, 10, 1), bytes('T', 0, 2, 255, 2),
                        record('M', join(bytes(255), text("////ROMA"), bytes(0, 0, 0), text("tell;help"))),
                        record('M', join(bytes(0), text("SUPOROMA"), bytes(0xFF, 0, 1), text("tell;x(\"\u00e9\")")))),
                        polled(true, false, false, false, null, List.of(
                                transmission(9, 0), transmission(10, 1), transmission(255, 2),
                                message(255, "////", "ROMA", 0, "tell;help"),
                                message(0, "SUPO", "ROMA", 0xFF0001, "tell;x(\"\u00e9\")")))),
                ok("poll", join(bytes(6), record('P', text("proximity(17)")), record('P', text("dark"))),
                        polled(false, true, true, false, null, List.of(percept("proximity(17)"), percept("dark")))),
                ok("poll", join(bytes(4), record('P', text("x".repeat(300))), record('P', new byte[0])),
                        polled(false, false, true, false, null, List.of(percept("x".repeat(300)), percept("")))),
                ok("poll", join(bytes(1), record('M', join(bytes(7), text("9///AAAA"), bytes(0xFF, 0xFF, 0xFF),
                        text("tell;" + "x".repeat(489))))),
                        polled(true, false, false, false, null,
                                List.of(message(7, "9///", "AAAA", 0xFFFFFF, "tell;" + "x".repeat(489))))),
                ok("poll", join(bytes(0), record('O', join(bytes(0, 1, 2, 3, 0), text("////ROMAAIx"))),
                        record('O', bytes(0xFF, 0xFF, 0xFF, 0xFF, 1, 0x78)), record('O', bytes(0, 0, 0, 0, 2))),
                        polled(false, false, false, false, null, List.of(overheard(66_051, 0, "2f2f2f2f524f4d41414978"),
                                overheard(0xFFFF_FFFFL, 1, "78"), overheard(0, 2, "")))),
                ok("poll", join(bytes(0), record('N', text("SUPOROMA")), record('N', text("//SUCAFE"))),
                        polled(false, false, false, false, null,
                                List.of(noKey("SUPO", "ROMA"), noKey("//SU", "CAFE")))),
                ok("poll", bytes(8), polled(false, false, false, true, null, List.of())),
                timerTaken(0x10, false, 0), timerTaken(0x28, true, 1), timerTaken(0x60, false, 5),
                ok("poll", join(bytes(12), record('P', text("dark"))),
                        polled(false, false, true, true, null, List.of(percept("dark")))),
                ok("act", new byte[0], vector("number", null)),
                acted(0, 0, 0, 0), acted(470, 0, 1, 0xD6), acted(-1, 0xFF, 0xFF, 0xFF),
                acted(0x7FFFFF, 0x7F, 0xFF, 0xFF), acted(-0x800000, 0x80, 0, 0),
                ok("listActions", bytes(0), actions(0, "", true)),
                ok("listActions", join(bytes(2), text("lampOn"), bytes(0), text("lampOff"), bytes(0)),
                        actions(2, "6c616d704f6e006c616d704f666600", true, "lampOn", "lampOff")),
                ok("listActions", join(bytes(255), text("\u00e9"), bytes(0), text("la")),
                        actions(255, "c3a9006c61", false, "\u00e9")),
                ok("listActions", bytes(1), actions(1, "", false)),
                ok("setKey", bytes(0xAB, 0, 0x12), vector("check", "ab0012")),
                ok("renewKey", bytes(0xFF, 0, 1), vector("check", "ff0001")),
                ok("setSessionKey", bytes(1, 0, 0xFF), vector("check", "0100ff")),
                ok("useKey", new byte[0], vector()),
                ok("raiseEpoch", new byte[0], vector()),
                ok("finishRenewal", new byte[0], vector()),
                ok("listKeys", new byte[0], vector("keys", List.of())),
                ok("listKeys", join(text("SUPO"), bytes(0, 1, 2, 3), text("SUPO"), bytes(1, 9, 8, 7),
                        text("//SU"), bytes(0, 0, 0, 0), text("//SU"), bytes(2, 6, 5, 4),
                        text("ROMA"), bytes(3, 7, 7, 7)),
                        vector("keys", List.of(key("SUPO", 0, "010203"), key("SUPO", 1, "090807"),
                                key("//SU", 0, "000000"), key("//SU", 2, "060504"),
                                key("ROMA", 3, "070707")))),
                ok("listKeys", join(text("SUPO"), bytes(4, 1, 2, 3), text("SUPO"), bytes(6, 9, 8, 7)),
                        vector("keys", List.of(key("SUPO", 4, "010203"), key("SUPO", 6, "090807")))),
                ok("statistics", bytes(1, 0, 0, 1, 2, 18, 0xFF, 0xFF, 0xFF, 0xFF, 200, 0, 0, 0, 1),
                        vector("counters", vector("serialRequests", 258, "perceptsLeftOut", 4294967295L))),
                ok("statistics", allCounters(), vector("counters", countersByName())),
                ok("transmit", bytes(255), vector("number", 255)),
                ok("overhear", new byte[0], vector()),
                ok("relay", bytes(7), vector("number", 7)),
                ok("relaying", bytes(1), vector("on", true)),
                ok("isRelaying", bytes(0), vector("on", false)),
                refused(1, "NOT_GREETED"), refused(2, "UNKNOWN_COMMAND"), refused(3, "BAD_ARGUMENT"),
                refused(4, "UNKNOWN_ACTION"), refused(5, "ACTION_FAILED"), refused(6, "NO_RF_ID"),
                refused(7, "WRONG_ORIGIN"), refused(8, "BAD_DESTINATION"), refused(9, "NO_KEY"),
                refused(10, "TOO_LONG"), refused(11, "QUEUE_FULL"), refused(12, "STORE_FULL"),
                refused(13, "STORE_FAILED"), refused(14, "NONCE_EXHAUSTED"),
                refused(15, "BUSY"), refused(16, "HAS_KEY"), refused(17, "EPOCH_LOST"), refused(18, "MEMORY_DAMAGED"),
                refused(19, "NO_RADIO"), refused(20, "UNICASTS_ONLY"));
    }

    /** @param capabilities null for a board of an earlier library, which has radio and memory. */
    private static Map<String, Object> hello(int version, String id, int epoch, Integer capabilities, String firmware) {
        int has = capabilities == null ? 3 : capabilities;
        return ok("hello",
                join(bytes(version), text(id == null ? "++++" : id), bytes(epoch >> 16, epoch >> 8, epoch),
                        capabilities == null ? new byte[0] : bytes(capabilities), text(firmware)),
                vector("version", version, "rfId", id, "bootEpoch", epoch, "radio", (has & 1) != 0,
                        "memory", (has & 2) != 0, "unicastsOnly", (has & 4) != 0, "earlier", capabilities == null,
                        "firmware", firmware));
    }

    private static Map<String, Object> acted(int number, int... body) {
        return ok("act", bytes(body), vector("number", number));
    }

    private static byte[] record(char type, byte[] value) {
        return join(bytes(type, value.length >> 8, value.length), value);
    }

    private static Map<String, Object> percept(String literal) {
        return vector("type", "percept", "literal", literal);
    }

    private static Map<String, Object> message(int number, String destination, String origin, int id,
            String content) {
        return vector("type", "message", "number", number, "destination", destination, "origin", origin,
                "id", id, "content", content);
    }

    private static Map<String, Object> transmission(int number, int outcome) {
        return vector("type", "transmission", "number", number, "outcome", outcome);
    }

    private static Map<String, Object> noKey(String destination, String origin) {
        return vector("type", "noKey", "destination", destination, "origin", origin);
    }

    private static Map<String, Object> overheard(long millis, int how, String payload) {
        return vector("type", "overheard", "millis", millis, "how", how, "payload", payload);
    }

    private static Map<String, Object> key(String address, int role, String check) {
        return vector("address", address, "role", role, "check", check);
    }

    private static Map<String, Object> actions(int count, String told, boolean all, String... names) {
        return vector("count", count, "told", told, "all", all, "names", List.of(names));
    }

    /** Each counter with ten times its number. */
    private static byte[] allCounters() {
        byte[] all = new byte[0];
        for (int number = 1; number <= COUNTERS.size(); number++) {
            all = join(all, bytes(number, 0, 0, 10 * number >> 8, 10 * number));
        }
        return all;
    }

    private static Map<String, Object> countersByName() {
        Map<String, Object> byName = vector();
        for (String name : COUNTERS) {
            byName.put(name, 10 * (byName.size() + 1));
        }
        return byName;
    }

    private static Map<String, Object> ok(String name, byte[] body, Map<String, Object> fields) {
        return vector("name", name, "status", "OK", "fields", fields, "message", Wire.hex(join(bytes(0), body)));
    }

    private static Map<String, Object> refused(int value, String status) {
        return vector("name", "act", "status", status, "fields", vector("number", null), "message",
                Wire.hex(bytes(value)));
    }

    private static List<Map<String, Object>> badReplies() {
        return List.of(
                badReply("act", new byte[0], "no status"),
                badReply("act", bytes(21), "unknown status"),
                badReply("act", bytes(0, 1, 2), "short number"),
                badReply("act", bytes(0, 1, 2, 3, 4), "long number"),
                badReply("hello", join(bytes(0, 1), text("ROMA"), bytes(0, 0)), "a byte short"),
                badReply("hello", join(bytes(0, 1), text("RO-A"), bytes(0, 0, 1)), "no address"),
                badReply("hello", join(bytes(0, 1), text("ROMA"), bytes(0, 0, 1, 0xFF)), "name is no UTF-8"),
                badReply("hello", join(bytes(0, 1), text("ROMA"), bytes(0, 0, 1, 3, 0xFF)),
                        "name behind the capabilities is no UTF-8"),
                badReply("poll", bytes(0), "no flags"),
                badReply("poll", bytes(0, 0, 'P', 0), "half a record header"),
                badReply("poll", bytes(0, 0, 'P', 0, 2, 'x'), "record longer than the reply"),
                badReply("poll", bytes(0, 0, 'Q', 0, 0), "unknown type of record"),
                badReply("poll", bytes(0, 0, 'T', 0, 1, 1), "transmission without outcome"),
                badReply("poll", bytes(0, 0, 'T', 0, 2, 1, 3), "unknown outcome"),
                badReply("poll", join(bytes(0, 0, 'M', 0, 8, 1), text("////ROM")), "half a message"),
                badReply("poll", join(bytes(0, 0, 'M', 0, 11, 1), text("////ROMA"), bytes(0, 0)), "half an id"),
                badReply("poll", join(bytes(0, 0, 'M', 0, 12, 1), text("////RO=A"), bytes(0, 0, 0)),
                        "message without an origin"),
                badReply("poll", join(bytes(0, 0, 'N', 0, 7), text("SUPOROM")), "half an origin"),
                badReply("poll", join(bytes(0, 0, 'N', 0, 9), text("SUPOROMAA")), "something after the origin"),
                badReply("poll", join(bytes(0, 0, 'N', 0, 8), text("SUPORO=A")), "no address"),
                badReply("poll", bytes(0, 0, 'O', 0, 4, 0, 0, 0, 0), "overheard, but not how"),
                badReply("poll", bytes(0, 0, 'O', 0, 5, 0, 0, 0, 0, 3), "unknown way to come"),
                badReply("relay", bytes(0), "no number"),
                badReply("relaying", bytes(0), "not whether it is one"),
                badReply("isRelaying", bytes(0, 2), "neither on nor off"),
                badReply("listActions", bytes(0), "no number"),
                badReply("listActions", bytes(0, 1, 'a', 0, 'b', 0), "more names than actions"),
                badReply("listActions", bytes(0, 1, 'a', 0, 'b'), "something after the last name"),
                badReply("listActions", bytes(0, 1, 0xFF, 0), "name is no UTF-8"),
                badReply("setKey", bytes(0, 1, 2), "short check value"),
                badReply("renewKey", bytes(0, 1, 2, 3, 4), "long check value"),
                badReply("setSessionKey", bytes(0, 1, 2), "short check value"),
                badReply("useKey", bytes(0, 0), "something where nothing is due"),
                badReply("raiseEpoch", bytes(0, 0, 0, 1), "something where nothing is due"),
                badReply("finishRenewal", bytes(0, 0), "something where nothing is due"),
                badReply("listKeys", join(bytes(0), text("SUPO"), bytes(0, 1, 2)), "half a key"),
                badReply("listKeys", join(bytes(0), text("SUPO"), bytes(8, 1, 2, 3)), "unknown role"),
                badReply("listKeys", join(bytes(0), text("SU=O"), bytes(0, 1, 2, 3)), "key without an address"),
                badReply("statistics", bytes(0, 1, 0, 0, 0), "half a counter"),
                badReply("transmit", bytes(0), "no number"));
    }

    private static Map<String, Object> badReply(String name, byte[] message, String why) {
        return vector("name", name, "message", Wire.hex(message), "why", why);
    }
}
