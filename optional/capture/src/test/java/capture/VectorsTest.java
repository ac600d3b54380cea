package capture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.SerialPacket;
import javino.protocol.Status;
import javino.vectors.Crypto;
import javino.vectors.RadioVectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The dissector against all of test/vectors: each field as the vector has it, each error by its name. */
@Tag("verify")
class VectorsTest {

    private static final String NO_KEY = "NO_KEY";
    private static final String BAD_HOST_MESSAGE = "BAD_HOST_MESSAGE";
    private static final int PARTS_PAYLOAD = 0;
    private static final int PARTS_PACKET = 3;
    private static final int PARTS_TRAILER = 7;
    private static final int SYMBOL_BITS = 6;
    private static final int START_BITS = 48;
    /** Each nibble's symbol in the order of its bits: SPEC 6. */
    private static final List<String> SYMBOLS = List.of("101100", "011100", "110010", "101010", "011010", "100110",
            "010110", "001110", "110001", "101001", "011001", "100101", "010101", "001101", "010011", "001011");

    private final List<Tshark.Packet> packets = new ArrayList<>();
    private final List<Check> checks = new ArrayList<>();
    private final Set<String> keyring = new LinkedHashSet<>();
    private List<Tshark.Dissected> dissected;
    private int cases;

    /** A check of some packets once all were dissected. */
    private record Check(String what, Runnable check) {
    }

    private static Stream<JsonObject> vectors(String file, String list) throws Exception {
        Path path = Path.of(System.getProperty("javino.root"), "test/vectors", file + ".json");
        List<JsonElement> vectors =
                JsonParser.parseString(Files.readString(path)).getAsJsonObject().getAsJsonArray(list).asList();
        assertTrue(!vectors.isEmpty(), file + " " + list);
        return vectors.stream().map(JsonElement::getAsJsonObject);
    }

    private static String text(JsonObject vector, String name) {
        return vector.get(name).getAsString();
    }

    private static String hexOf(String text) {
        return Bytes.ofText(text).hex();
    }

    private static Bytes counted(String text) {
        return Bytes.join(Bytes.of(text.length()), Bytes.ofText(text));
    }

    /** A board of its own for each case, so that nothing is linked across cases. */
    private Bytes board() {
        return counted("v" + cases);
    }

    /** @return the packet's index. */
    private int air(int parts, Bytes packet) {
        return air(1, AirPacket.UNKNOWN_PATH, parts, packet);
    }

    private int air(int way, int path, int parts, Bytes packet) {
        return add(Pcapng.AIR, Bytes.join(Bytes.of(1, way, 0, 255, path, parts), board(), counted(""), packet));
    }

    private int serial(int from, Bytes packet) {
        return add(Tshark.SERIAL, Bytes.join(Bytes.of(1, from), board(), packet));
    }

    private int serial(int from, int sequence, String destination, String origin, Bytes message) {
        return serial(from,
                new SerialPacket(sequence, new Frame(Address.parse(destination), Address.parse(origin), message))
                        .encode());
    }

    private int add(int linkType, Bytes record) {
        packets.add(new Tshark.Packet(linkType, 1000L * packets.size(), record));
        return packets.size() - 1;
    }

    private void check(Object what, Runnable check) {
        checks.add(new Check(what.toString(), check));
        cases++;
    }

    private void dissect() throws Exception {
        // Some editors put a mark before a text.
        dissected = Tshark.dissect(Tshark.file(packets), "\uFEFF" + String.join("\n", keyring) + "\n");
        assertEquals(packets.size(), dissected.size());
        for (Check check : checks) {
            try {
                check.check.run();
            } catch (AssertionError | RuntimeException e) {
                throw new AssertionError(check.what, e);
            }
        }
    }

    private void shows(int index, String field, Object... values) {
        assertEquals(Stream.of(values).map(Object::toString).toList(), dissected.get(index).shown("javino." + field),
                field);
    }

    private void has(int index, String field, String... hex) {
        assertEquals(List.of(hex), dissected.get(index).hex("javino." + field), field);
    }

    private void fails(int index, String error) {
        assertTrue(dissected.get(index).errors().contains(error), () -> error + " in " + dissected.get(index));
    }

    private void isRight(int index) {
        assertEquals(List.of(), dissected.get(index).errors());
    }

    private void showsFrame(int index, Frame frame) {
        String destination = frame.destination().toString();
        String origin = frame.origin().toString();
        shows(index, "destination", destination);
        shows(index, "origin", origin);
        shows(index, "destination.group", destination.substring(0, 2));
        shows(index, "destination.member", destination.substring(2));
        shows(index, "origin.group", origin.substring(0, 2));
        shows(index, "origin.member", origin.substring(2));
        shows(index, "size", 8 * frame.message().length());
        if (frame.message().length() > 0) {
            has(index, "message", frame.message().hex());
        }
    }

    private static Frame frame(Bytes bytes) {
        try {
            return Frame.decode(bytes);
        } catch (javino.protocol.ProtocolException e) {
            throw new AssertionError(e);
        }
    }

    private static Bytes frame(String to, String from, Bytes message) {
        return new Frame(Address.parse(to), Address.parse(from), message).encode();
    }

    @Test
    void addresses_ofAllClasses_areNamedAndTheReservedOnesRefused() throws Exception {
        vectors("addresses", "valid").forEach(vector -> {
            String address = text(vector, "text");
            int index = air(PARTS_PAYLOAD, frame(address, "CAFE", Bytes.ofText("tell;help")));
            check(vector, () -> {
                shows(index, "destination", address);
                shows(index, "destination.class", text(vector, "class"));
                shows(index, "destination.group", text(vector, "group"));
                shows(index, "destination.member", text(vector, "member"));
                if (List.of("serial", "reserved").contains(text(vector, "class"))) {
                    fails(index, "radioReserved");
                }
            });
        });
        vectors("addresses", "invalid").filter(vector -> Bytes.ofText(text(vector, "text")).length() == Address.LENGTH)
                .forEach(vector -> {
                    int index = air(PARTS_PAYLOAD,
                            Bytes.join(Bytes.ofText(text(vector, "text")), Bytes.ofText("CAFEAA")));
                    check(vector, () -> fails(index, "BAD_DIGIT"));
                });
        dissect();
    }

    @Test
    void frames_allFieldsAndErrors() throws Exception {
        vectors("frames", "valid").forEach(vector -> {
            Bytes bytes = Bytes.ofHex(text(vector, "frame"));
            int index = air(PARTS_PAYLOAD, bytes);
            check(vector, () -> {
                showsFrame(index, frame(bytes));
                has(index, "message", Stream.of(text(vector, "message")).filter(hex -> !hex.isEmpty())
                        .toArray(String[]::new));
            });
        });
        vectors("frames", "invalid").forEach(vector -> {
            int index = air(PARTS_PAYLOAD, Bytes.ofHex(text(vector, "bytes")));
            check(vector, () -> {
                if (text(vector, "bytes").isEmpty()) {
                    shows(index, "payload");
                } else {
                    fails(index, text(vector, "error"));
                }
            });
        });
        dissect();
    }

    @Test
    void packets_ofTheSerialLine_allFieldsAndErrors() throws Exception {
        vectors("packets", "valid").forEach(vector -> {
            int index = serial(0, Bytes.ofHex(text(vector, "packet")));
            check(vector, () -> {
                shows(index, "serial.sequence", vector.get("sequence").getAsInt());
                shows(index, "serial.crc.right", 1);
                has(index, "serial.packet", text(vector, "packet"));
                showsFrame(index, frame(Bytes.ofHex(text(vector, "frame"))));
            });
        });
        vectors("packets", "invalid").forEach(vector -> {
            int index = serial(0, Bytes.ofHex(text(vector, "packet")));
            check(vector, () -> assertEquals(List.of(text(vector, "error")), dissected.get(index).errors()));
        });
        dissect();
    }

    /** The bytes of a packet's bits, up to the first symbol that is in no table. */
    private static Bytes decoded(String bits) {
        List<Integer> nibbles = IntStream.rangeClosed(0, (bits.length() - START_BITS) / SYMBOL_BITS - 1)
                .mapToObj(i -> SYMBOLS.indexOf(
                        bits.substring(START_BITS + SYMBOL_BITS * i, START_BITS + SYMBOL_BITS * (i + 1))))
                .takeWhile(nibble -> nibble >= 0).toList();
        return Bytes.of(IntStream.range(0, nibbles.size() / 2)
                .map(i -> nibbles.get(2 * i) << 4 | nibbles.get(2 * i + 1)).toArray());
    }

    @Test
    void radioPackets_allFieldsAndErrors() throws Exception {
        vectors("radio", "packets").forEach(vector -> {
            radioPacket(vector, 0);
        });
        vectors("radio", "copies").forEach(vector -> radioPacket(vector, vector.get("path").getAsInt()));
        vectors("radio", "invalid").filter(vector -> !text(vector, "why").equals("no start symbol")).forEach(vector -> {
            int index = air(PARTS_PACKET, decoded(text(vector, "bits")));
            check(vector, () -> fails(index, "radioDamaged"));
        });
        vectors("radio", "trailers").forEach(vector -> {
            Bytes packet = Bytes.copyOf(RadioVectors.packet(Bytes.ofHex(text(vector, "payload")).toArray()));
            Bytes trailer = Bytes.ofHex(text(vector, "trailer"));
            int index = air(PARTS_TRAILER, Bytes.join(packet, trailer));
            check(vector, () -> {
                has(index, "payload", text(vector, "payload"));
                shows(index, "crc.right", 1);
                has(index, "trailer.bytes", trailer.hex());
                has(index, "trailer.parity",
                        trailer.at(0) == 0x87 ? new String[] {trailer.from(1).hex()} : new String[0]);
            });
        });
        dissect();
    }

    private void radioPacket(JsonObject vector, int path) {
        Bytes packet = decoded(text(vector, "bits"));
        int index = air(PARTS_PACKET, packet);
        int without = air(1, packet.slice(0, packet.length() - 2));
        check(vector, () -> {
            for (int each : List.of(index, without)) {
                shows(each, "count", packet.at(0));
                has(each, "payload", text(vector, "payload"));
            }
            showsPath(index, path);
            shows(without, "hops");
            shows(without, "distance");
            shows(index, "crc.right", 1);
            has(index, "crc", packet.from(packet.length() - 2).hex());
        });
    }

    private void showsPath(int index, int path) {
        shows(index, "hops", path % 4);
        shows(index, "distance", path < 4 ? new Object[0] : new Object[] {path / 4 - 1});
    }

    @Test
    void path_thatTheRecordTells_isShown() throws Exception {
        Bytes sealed = frame("ROMA", "SUPO", Bytes.of(new int[20]));
        for (int path = 0; path < 20; path++) {
            int told = path;
            int copy = air(1, path, PARTS_PAYLOAD, sealed);
            check(path, () -> {
                showsPath(copy, told);
                isRight(copy);
            });
        }
        dissect();
    }

    @Test
    void copyThatItsSenderHears_isNotWhatIsAcknowledged() throws Exception {
        Bytes sealed = frame("SUPO", "ROMA", Bytes.of(new int[15]));
        Bytes answer = frame("+KAA", "SUPO", Bytes.of(new int[8]));
        int sent = air(0, 0, PARTS_PAYLOAD, sealed);
        int copy = air(1, 1, PARTS_PAYLOAD, sealed);
        int acknowledgement = air(1, 1, PARTS_PAYLOAD, answer);
        check("sender", () -> {
            shows(acknowledgement, "acknowledgement.of", sent + 1);
            shows(sent, "acknowledged_in", acknowledgement + 1);
            shows(copy, "acknowledged_in");
        });
        // At a board that has sent neither.
        int other = air(1, 1, PARTS_PAYLOAD, sealed);
        int heard = air(1, 1, PARTS_PAYLOAD, answer);
        check("other", () -> shows(heard, "acknowledgement.of", other + 1));
        dissect();
    }

    /** A host message as a board gives it to its host, opened. */
    private int opened(String destination, Bytes message) {
        request(requestOf("poll"), 7);
        Bytes record = Bytes.join(Bytes.of(0), Bytes.ofText(destination + "ROMA"), Bytes.of(0, 0, 5), message);
        return serial(1, 7, "++++", "++++",
                Bytes.join(Bytes.of(0, 0, 'M'), Bytes.ofNumber(record.length(), 2), record));
    }

    @Test
    void hostMessages_allFieldsAndErrors() throws Exception {
        vectors("host-messages", "valid").forEach(vector -> {
            Bytes bytes = Bytes.ofHex(text(vector, "hostMessage"));
            boolean isPlain = !vector.get("to").isJsonNull();
            int index = isPlain ? air(PARTS_PAYLOAD, frame("////", "ROMA", bytes)) : opened("SUPO", bytes);
            int wrongCast = isPlain ? opened("SUPO", bytes) : opened("////", bytes);
            check(vector, () -> {
                isRight(index);
                fails(wrongCast, BAD_HOST_MESSAGE);
                String body = text(vector, "body");
                shows(index, "host_message", text(vector, "kind"));
                shows(index, "host_message.kind", String.format("0x%02x", bytes.at(0)));
                shows(index, "host_message.to", isPlain ? new Object[] {text(vector, "to")} : new Object[0]);
                has(index, "host_message.body", body.isEmpty() ? new String[0] : new String[] {body});
                shows(index, "host_message.fragment", text(vector, "kind").equals("MESSAGE_2")
                        ? new Object[] {vector.get("fragment").getAsInt()} : new Object[0]);
            });
        });
        vectors("host-messages", "invalid").forEach(vector -> {
            Bytes bytes = Bytes.ofHex(text(vector, "hostMessage"));
            int index = bytes.at(0) < 0x88 ? air(PARTS_PAYLOAD, frame("////", "ROMA", bytes)) : opened("SUPO", bytes);
            check(vector, () -> fails(index, BAD_HOST_MESSAGE));
        });
        dissect();
    }

    @Test
    void hostMessages_bodies_haveTheirFields() throws Exception {
        int want = air(PARTS_PAYLOAD, frame("////", "ROMA", Bytes.of(0x86, 1, 2, 3, 0x81, 1)));
        int content = opened("SUPO", Bytes.join(Bytes.of(0x88, 0, 1, 2), Bytes.ofText("tell;help")));
        int sequences = opened("SUPO", Bytes.of(0x89, 9, 1, 0, 8, 0, 2));
        Bytes signature = Bytes.of(IntStream.range(5, 5 + 64).toArray());
        int revocationList =
                opened("SUPO", Bytes.join(Bytes.of(0x8A, 9, 0, 3, 0x50, 1, 0x50, 2, 0, 7, 1, 0), signature));
        int offer = opened("SUPO", Bytes.join(Bytes.of(0x8C, 1, 2, 3, 4, 'm', 1, 1, 2, 3, 4, 5, 6, 7, 8, 0, 0, 9, 0, 1,
                0, 8, 7, 6, 5, 4, 3, 2, 1), Bytes.ofText("SUPObus")));
        int data = opened("SUPO", Bytes.of(0x8E, 1, 2, 3, 4, 1, 0, 1, 0, 7, 8));
        int refused = opened("SUPO", Bytes.join(Bytes.of(0x93, 1, 2, 3, 4), Bytes.ofText("lacks .fly")));
        List<Integer> wrong = List.of(opened("SUPO", Bytes.of(0x88, 0, 1, 2)), opened("SUPO", Bytes.of(0x89, 9, 1)),
                opened("SUPO", Bytes.join(Bytes.of(0x8A, 1), signature)), opened("SUPO", Bytes.of(0x8E, 1)));
        check("fields", () -> {
            List.of(want, content, sequences, revocationList, offer, data, refused).forEach(this::isRight);
            shows(want, "host_message.wanted", "0x81");
            shows(want, "host_message.wanted.fragment", 1);
            shows(content, "host_message.id", 0x102);
            shows(content, "content", "tell;help");
            has(sequences, "revocation_list.authority", "09", "08");
            shows(sequences, "revocation_list.sequence", 0x100, 2);
            shows(revocationList, "revocation_list.sequence", 3);
            shows(revocationList, "revocation_list.day", 0x5001);
            shows(revocationList, "revocation_list.least_until", 0x5002);
            shows(revocationList, "revocation_list.serial", 7, 0x100);
            has(revocationList, "revocation_list.signature", signature.hex());
            shows(offer, "move", "0x01020304");
            shows(offer, "move.protocol", "mutualism");
            has(offer, "move.hash", "0102030405060708");
            shows(offer, "move.packed_length", 9);
            shows(offer, "move.text_length", 0x100);
            has(offer, "move.token", "0807060504030201");
            shows(offer, "move.home", "SUPO");
            shows(offer, "move.name", "bus");
            shows(data, "move.part", 1);
            shows(data, "move.offset", 0x100);
            has(data, "move.packed", "0708");
            shows(refused, "move.reason", "lacks .fly");
            wrong.forEach(index -> fails(index, BAD_HOST_MESSAGE));
        });
        dissect();
    }

    @Test
    void contents_allFieldsAndErrors() throws Exception {
        vectors("contents", "valid").forEach(vector -> {
            int index = air(PARTS_PAYLOAD, frame("////", "ROMA", Bytes.ofHex(text(vector, "content"))));
            check(vector, () -> {
                isRight(index);
                shows(index, "performative", text(vector, "performative"));
                shows(index, "conversation",
                        vector.get("conversation").isJsonNull() ? new Object[0]
                                : new Object[] {text(vector, "conversation")});
                has(index, "content", text(vector, "content"));
                has(index, "term", hexOf(text(vector, "term")));
            });
        });
        vectors("contents", "invalid").forEach(vector -> {
            // The last one is too long for a frame of its own, and its reader for bytes is the same.
            int index = air(PARTS_PAYLOAD, frame("////", "ROMA", Bytes.ofHex(text(vector, "content"))));
            check(vector, () -> assertEquals(List.of(text(vector, "error")), dissected.get(index).errors()));
        });
        dissect();
    }

    /** The vectors of one key after those of the other, as a pair has one key in a keyring. */
    private void forEachKey(String file, String list, java.util.function.Consumer<JsonObject> action) throws Exception {
        Set<String> keys = vectors(file, list).map(vector -> text(vector, "key")).collect(Collectors.toSet());
        for (String key : keys) {
            packets.clear();
            checks.clear();
            keyring.clear();
            vectors(file, list).filter(vector -> text(vector, "key").equals(key)).forEach(action);
            dissect();
        }
    }

    private void share(String one, String other, String key) {
        String members = one.startsWith("//") ? one
                : Stream.of(one, other).sorted().collect(Collectors.joining(" "));
        keyring.add(members + " = " + key + "  # a test's");
    }

    @Test
    void envelopes_withTheKey_areOpened() throws Exception {
        forEachKey("envelopes", "valid", vector -> {
            share(text(vector, "destination"), text(vector, "origin"), text(vector, "key"));
            int index = air(PARTS_PAYLOAD, Bytes.ofHex(text(vector, "frame")));
            check(vector, () -> {
                has(index, "nonce", text(vector, "nonce"));
                shows(index, "epoch", Integer.parseInt(text(vector, "nonce").substring(0, 6), 16));
                shows(index, "counter", Integer.parseInt(text(vector, "nonce").substring(6), 16));
                shows(index, "tag.right", 1);
                String content = text(vector, "content");
                has(index, "content", content.isEmpty() ? new String[0] : new String[] {content});
            });
        });
    }

    @Test
    void envelopes_thatAreNotGenuine_haveNoContent() throws Exception {
        forEachKey("envelopes", "invalid", vector -> {
            Bytes bytes = Bytes.ofHex(text(vector, "frame"));
            share(frame(bytes).destination().toString(), frame(bytes).origin().toString(), text(vector, "key"));
            int index = air(PARTS_PAYLOAD, bytes);
            check(vector, () -> {
                assertEquals(List.of("radioBadTag"), dissected.get(index).errors());
                shows(index, "content");
            });
        });
    }

    /** A frame that the acknowledgement may answer, as its header and nonce are; and the acknowledgement. */
    private int[] answered(JsonObject vector) {
        String sender = text(vector, "sender");
        String acknowledger = text(vector, "acknowledger");
        share(sender, acknowledger, text(vector, "key"));
        Bytes sealed = Bytes.join(Bytes.ofHex(text(vector, "nonce")), Bytes.of(new int[9]));
        return new int[] {air(PARTS_PAYLOAD, frame(acknowledger, sender, sealed)),
                air(PARTS_PAYLOAD, Bytes.ofHex(text(vector, "frame")))};
    }

    @Test
    void acknowledgements_withTheKey_areProvenAndLinked() throws Exception {
        forEachKey("acknowledgements", "valid", vector -> {
            int[] both = answered(vector);
            check(vector, () -> {
                isRight(both[1]);
                shows(both[1], "acknowledgement.answers", text(vector, "kind"));
                shows(both[1], "acknowledgement.proof.right", 1);
                shows(both[1], "acknowledgement.parity", 0);
                shows(both[1], "acknowledgement.of", both[0] + 1);
                shows(both[1], "acknowledgement.sender", text(vector, "sender"));
                shows(both[1], "acknowledgement.time", "0.001000000");
                shows(both[0], "acknowledged_in", both[1] + 1);
                String frame = text(vector, "frame");
                has(both[1], "acknowledgement.proof", frame.substring(frame.length() - 16));
                for (String field : List.of("fragments", "uptime")) {
                    assertEquals(vector.has(field) ? List.of(vector.get(field).getAsLong()) : List.of(),
                            dissected.get(both[1]).shown("javino.acknowledgement." + field).stream()
                                    .map(Long::decode).toList());
                }
                has(both[1], "acknowledgement.floor",
                        vector.has("floor") ? new String[] {text(vector, "floor")} : new String[0]);
            });
        });
    }

    @Test
    void staleAcknowledgement_ofAMember_answersTheGroupsFrame() throws Exception {
        Bytes key = Bytes.ofHex("000102030405060708090a0b0c0d0e0f");
        share("//SU", "", key.hex());
        Bytes nonce = Bytes.ofNumber(0x1000005, 6);
        int multicast = air(PARTS_PAYLOAD, frame("//SU", "ROMA", Bytes.join(nonce, Bytes.of(new int[9]))));
        Bytes floor = Bytes.join(nonce, Bytes.of(0, 9));
        byte[] proof = Crypto.cmac(Crypto.kdf(key.toArray(), "JavinoMac"),
                Bytes.join(Bytes.of(8), nonce, Bytes.ofText("ROMASUPO"), floor).toArray());
        int stale = air(PARTS_PAYLOAD,
                frame("+KAF", "SUPO", Bytes.join(floor, Bytes.copyOf(proof).slice(0, 8))));
        check("stale", () -> {
            shows(stale, "acknowledgement.of", multicast + 1);
            shows(stale, "acknowledgement.proof.right", 1);
        });
        dissect();
    }

    @Test
    void acknowledgements_thatAreNotGenuine_areNotProven() throws Exception {
        forEachKey("acknowledgements", "invalid", vector -> {
            int[] both = answered(vector);
            check(vector, () -> {
                List<String> right = dissected.get(both[1]).shown("javino.acknowledgement.proof.right");
                assertTrue(!right.contains("1"), right::toString);
                shows(both[0], "acknowledged_in");
                // Another nonce's has nothing here that it could answer.
                if (!text(vector, "why").equals("the address is of another nonce")) {
                    fails(both[1], "radioBadProofs");
                }
            });
        });
    }

    @Test
    void fragments_inAnyOrder_arePutTogether() throws Exception {
        List<JsonObject> valid = vectors("fragments", "valid").toList();
        for (boolean backwards : List.of(false, true)) {
            for (JsonObject vector : valid) {
                List<JsonElement> fragments = new ArrayList<>(vector.getAsJsonArray("fragments").asList());
                if (backwards) {
                    Collections.reverse(fragments);
                }
                List<Integer> indexes = fragments.stream()
                        .map(fragment -> air(PARTS_PAYLOAD, Bytes.ofHex(fragment.getAsString()))).toList();
                int last = indexes.get(indexes.size() - 1);
                Frame whole = frame(Bytes.ofHex(text(vector, "frame")));
                check(text(vector, "frame") + backwards, () -> {
                    for (int index : indexes) {
                        int k = backwards ? last - index : indexes.indexOf(index);
                        shows(index, "fragment.id", digit(text(vector, "id")));
                        shows(index, "fragment.index", k);
                        shows(index, "fragment.asks", 0);
                        shows(index, "fragment.whole_in", index == last ? new Object[0] : new Object[] {last + 1});
                    }
                    Tshark.Dissected end = dissected.get(last);
                    assertEquals(List.of(whole.destination().toString()),
                            end.shown("javino.destination").stream().skip(1).toList());
                    assertEquals(List.of(whole.message().hex()), end.hex("javino.message").stream().skip(1).toList());
                    assertEquals(indexes.stream().filter(index -> index != last).map(index -> index + 1).sorted()
                            .map(Object::toString).toList(),
                            end.shown("javino.fragment.in").stream().sorted((a, b) -> Integer.parseInt(a)
                                    - Integer.parseInt(b)).toList());
                });
            }
        }
        vectors("fragments", "asking").forEach(vector -> {
            int index = air(PARTS_PAYLOAD, Bytes.ofHex(text(vector, "fragment")));
            check(vector, () -> {
                shows(index, "origin", text(vector, "origin"));
                shows(index, "fragment.id", digit(text(vector, "id")));
                shows(index, "fragment.index", text(vector, "index"));
                shows(index, "fragment.asks", 1);
                has(index, "fragment.part", text(vector, "part"));
            });
        });
        vectors("fragments", "invalid").forEach(vector -> {
            int index = air(PARTS_PAYLOAD, Bytes.ofHex(text(vector, "fragment")));
            boolean fromSerial = text(vector, "why").equals("from the serial line");
            check(vector, () -> fails(index, fromSerial ? "radioBadFrames" : "radioFragmentsDropped"));
        });
        dissect();
    }

    private static int digit(String digit) {
        return Address.parse("AAA" + digit).value();
    }

    private static Bytes message(JsonObject vector) {
        return Bytes.ofHex(text(vector, "message"));
    }

    private int request(JsonObject vector, int sequence) {
        boolean transmit = text(vector, "name").equals("transmit");
        return serial(0, sequence, transmit ? text(vector, "destination") : "++++",
                transmit ? text(vector, "origin") : "++++", message(vector));
    }

    private static JsonObject requestOf(String name) {
        try {
            return vectors("commands", "requests").filter(vector -> text(vector, "name").equals(name)).findFirst()
                    .orElseThrow();
        } catch (Exception e) {
            throw new AssertionError(name, e);
        }
    }

    @Test
    void requests_allFieldsAndErrors() throws Exception {
        vectors("commands", "requests").forEach(vector -> {
            int index = request(vector, cases % 256);
            check(vector, () -> {
                isRight(index);
                shows(index, "serial.command", command(text(vector, "name")));
                showsRequest(index, vector);
            });
        });
        vectors("commands", "badRequests").filter(vector -> !text(vector, "status").equals(NO_KEY)).forEach(vector -> {
            int index = serial(0, 0, "++++", "++++", message(vector));
            check(vector, () -> assertEquals(List.of(text(vector, "status")), dissected.get(index).errors()));
        });
        dissect();
    }

    /** {@code listKeys} is {@code list keys} in SPEC 4.3. */
    private static String command(String name) {
        return name.equals("setRfId") ? "set RF id"
                : name.equals("isRelaying") ? "relaying" : name.replaceAll("([A-Z])", " $1").toLowerCase();
    }

    private void showsRequest(int index, JsonObject vector) {
        Map<String, String> numbers = Map.of("version", "serial.protocol_version", "hold", "serial.poll.hold", "least",
                "serial.poll.least", "taken", "serial.poll.taken", "offset", "serial.actions.offset", "epoch",
                "serial.boot_epoch", "number", "serial.relaying.number");
        Map<String, String> texts = Map.of("action", "serial.action", "frame", "serial.relay", "key", "serial.key",
                "content", "content");
        for (String name : vector.keySet()) {
            JsonElement value = vector.get(name);
            if (numbers.containsKey(name)) {
                shows(index, numbers.get(name), value.isJsonNull() ? new Object[0] : new Object[] {value.getAsInt()});
            } else if (texts.containsKey(name)) {
                boolean isHex = List.of("frame", "key").contains(name);
                has(index, texts.get(name), isHex ? value.getAsString() : hexOf(value.getAsString()));
            } else {
                switch (name) {
                    case "name", "message" -> {
                    }
                    case "percepts" -> {
                        shows(index, "serial.poll.percepts", value.getAsString().equals("none") ? 0 : 1);
                        shows(index, "serial.poll.now", value.getAsString().equals("now") ? 1 : 0);
                    }
                    case "lastReply" -> {
                        shows(index, "serial.poll.lost", value.getAsString().equals("lost") ? 1 : 0);
                        shows(index, "serial.poll.coming", value.getAsString().equals("coming") ? 1 : 0);
                    }
                    case "open" -> shows(index, "serial.radio", value.getAsBoolean() ? 1 : 0);
                    case "on" -> shows(index,
                            "serial." + text(vector, "name"), value.getAsBoolean() ? 1 : 0);
                    case "address" -> shows(index,
                            text(vector, "name").equals("setRfId") ? "serial.rf_id" : "serial.key.address",
                            value.getAsString());
                    case "destination", "origin" -> shows(index, name, value.getAsString());
                    default -> throw new AssertionError("the vectors have a new field " + name);
                }
            }
        }
    }

    @Test
    void replies_allFieldsAndErrors() throws Exception {
        vectors("commands", "replies").forEach(vector -> {
            int request = request(requestOf(text(vector, "name")), 7);
            int index = serial(1, 7, "++++", "++++", message(vector));
            check(vector, () -> {
                boolean isOk = text(vector, "status").equals("OK");
                assertEquals(isOk ? List.of() : List.of(text(vector, "status")), dissected.get(index).errors());
                shows(index, "serial.status", Status.valueOf(text(vector, "status")).ordinal());
                shows(index, "serial.request_in", request + 1);
                shows(request, "serial.reply_in", index + 1);
                shows(index, "serial.command", command(text(vector, "name")));
                vector.getAsJsonObject("fields").entrySet()
                        .forEach(field -> showsReply(index, text(vector, "name"), field.getKey(), field.getValue()));
            });
        });
        vectors("commands", "badReplies").forEach(vector -> {
            request(requestOf(text(vector, "name")), 7);
            int index = serial(1, 7, "++++", "++++", message(vector));
            check(vector, () -> fails(index, "BAD_REPLY"));
        });
        dissect();
    }

    /** A board of an earlier library does not tell it. */
    private void showsCapability(int index, String name, JsonElement value) {
        if (!dissected.get(index).hex("javino.serial.capabilities").isEmpty()) {
            shows(index, "serial.capabilities." + name, value.getAsBoolean() ? 1 : 0);
        }
    }

    private void showsReply(int index, String name, String field, JsonElement value) {
        switch (field) {
            case "version" -> shows(index, "serial.protocol_version", value.getAsInt());
            case "rfId" -> shows(index, "serial.rf_id", value.isJsonNull() ? "++++" : value.getAsString());
            case "bootEpoch" -> shows(index, "serial.boot_epoch", value.getAsInt());
            case "firmware" -> has(index, "serial.firmware", nonEmpty(value.getAsString()));
            case "earlier" -> assertEquals(value.getAsBoolean(),
                    dissected.get(index).hex("javino.serial.capabilities").isEmpty());
            case "radio" -> showsCapability(index, "radio", value);
            case "memory" -> showsCapability(index, "memory", value);
            case "unicastsOnly" -> showsCapability(index, "unicasts_only", value);
            case "more" -> shows(index, "serial.poll.more", value.getAsBoolean() ? 1 : 0);
            case "leftOut" -> shows(index, "serial.poll.left_out", value.getAsBoolean() ? 1 : 0);
            case "reading" -> shows(index, "serial.poll.reading", value.getAsBoolean() ? 1 : 0);
            case "damaged" -> shows(index, "serial.poll.damaged", value.getAsBoolean() ? 1 : 0);
            case "takenTimer" -> shows(index, "serial.poll.taken_timer", value.isJsonNull() ? 0 : value.getAsInt() + 1);
            case "records" -> showsRecords(index, value.getAsJsonArray().asList());
            case "count" -> shows(index, "serial.actions.count", value.getAsInt());
            case "names" -> assertEquals(value.getAsJsonArray().asList().stream().map(JsonElement::getAsString)
                    .map(VectorsTest::hexOf).toList(),
                    dissected.get(index).hex("javino.serial.actions.name").stream().limit(value.getAsJsonArray().size())
                            .toList());
            case "told", "all" -> {
            }
            case "check" -> has(index, "serial.key.check", value.getAsString());
            case "keys" -> {
                List<JsonObject> keys = value.getAsJsonArray().asList().stream().map(JsonElement::getAsJsonObject)
                        .toList();
                shows(index, "serial.key.address", keys.stream().map(key -> text(key, "address")).toArray());
                shows(index, "serial.key.role", keys.stream().map(key -> text(key, "role")).toArray());
                has(index, "serial.key.check", keys.stream().map(key -> text(key, "check")).toArray(String[]::new));
            }
            case "counters" -> value.getAsJsonObject().entrySet().forEach(
                    counter -> shows(index, "serial.counters." + counter.getKey(), counter.getValue().getAsLong()));
            case "number" -> shows(index, name.equals("act") ? "serial.act.number" : "serial.transmission.number",
                    value.isJsonNull() ? new Object[0] : new Object[] {value.getAsInt()});
            case "on" -> shows(index, "serial.relaying", value.getAsBoolean() ? 1 : 0);
            default -> throw new AssertionError("the vectors have a new field " + field + " of " + name);
        }
    }

    private static String[] nonEmpty(String text) {
        return text.isEmpty() ? new String[0] : new String[] {hexOf(text)};
    }

    private void showsRecords(int index, List<JsonElement> list) {
        List<JsonObject> records = list.stream().map(JsonElement::getAsJsonObject).toList();
        shows(index, "serial.record.type", records.stream()
                .map(record -> text(record, "type").equals("noKey") ? "no key" : text(record, "type")).toArray());
        Map<String, Map<String, String>> fields = Map.of(
                "percept", Map.of("literal", "serial.percept"),
                "transmission",
                Map.of("number", "serial.transmission.number", "outcome", "serial.transmission.outcome"),
                "message",
                Map.of("number", "serial.message.number", "destination", "serial.message.destination", "origin",
                        "serial.message.origin", "id", "serial.message.id", "content", "content"),
                "noKey", Map.of("destination", "serial.no_key.destination", "origin", "serial.no_key.origin"),
                "overheard", Map.of("millis", "serial.overheard.time", "how", "serial.overheard.how", "payload",
                        "serial.overheard.payload"));
        fields.forEach((type, names) -> names.forEach((name, field) -> {
            List<String> expected = records.stream().filter(record -> text(record, "type").equals(type))
                    .map(record -> text(record, name)).filter(value -> !value.isEmpty()).toList();
            if (List.of("literal", "content").contains(name)) {
                assertEquals(expected.stream().map(VectorsTest::hexOf).toList(),
                        dissected.get(index).hex("javino." + field), field);
            } else if (name.equals("payload")) {
                assertEquals(expected, dissected.get(index).hex("javino." + field), field);
            } else {
                assertEquals(expected, dissected.get(index).shown("javino." + field), field);
            }
        }));
    }
}
