package capture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.Request;
import javino.protocol.SerialPacket;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Bytes of attackers: the dissector shows what it can, and never fails. {@link Tshark} looks for that. */
class HostileTest {

    private static final String KEYRING = "ROMA SUPO = 000102030405060708090a0b0c0d0e0f\n"
            + "//SU = 000102030405060708090a0b0c0d0e0f, next 101112131415161718191a1b1c1d1e1f\nno key\n= \nA = 12\n";
    private static final int PACKETS = 1000;
    private static final int SEEDS = 10;

    private final List<Tshark.Packet> packets = new ArrayList<>();

    private void add(int linkType, Bytes record) {
        packets.add(new Tshark.Packet(linkType, 1000L * packets.size(), record));
    }

    private List<Tshark.Dissected> dissect() throws Exception {
        List<Tshark.Dissected> dissected = Tshark.dissect(Tshark.file(packets), KEYRING);
        assertEquals(packets.size(), dissected.size());
        return dissected;
    }

    private static Bytes random(Random random, int most) {
        byte[] bytes = new byte[random.nextInt(most)];
        random.nextBytes(bytes);
        return Bytes.copyOf(bytes);
    }

    @Test
    @Tag("verify")
    void bytes_ofAnyKind_areShown() throws Exception {
        showAnyBytes(new Random(0));
    }

    @Test
    @Tag("verify")
    void frames_withAnyMessage_areShown() throws Exception {
        showAnyMessages(new Random(0));
    }

    @Tag("soak")
    @RepeatedTest(SEEDS)
    void bytes_andMessages_areShown(RepetitionInfo repetition) throws Exception {
        showAnyBytes(new Random(repetition.getCurrentRepetition()));
        showAnyMessages(new Random(repetition.getCurrentRepetition()));
    }

    private void showAnyBytes(Random random) throws Exception {
        for (int i = 0; i < PACKETS; i++) {
            Bytes any = random(random, 90);
            add(random.nextBoolean() ? Pcapng.AIR : Tshark.SERIAL, any);
            // Past the header, with any parts.
            add(Pcapng.AIR, Bytes.join(Bytes.of(1, random.nextInt(3), random.nextInt(5), random.nextInt(4),
                    random.nextInt(256), random.nextInt(9), 1, 'b', 0), any));
            add(Tshark.SERIAL, Bytes.join(Bytes.of(1, random.nextInt(2), 1, 'b'), any, Bytes.of(0)));
        }
        dissect();
    }

    private void showAnyMessages(Random random) throws Exception {
        String[] destinations = {"////", "//SU", "ROMA", "SUPO", "+FAA", "+FAB", "+FAI", "+FAH", "+KAA", "+KAB", "++++",
                "self", "+AAA"};
        String[] origins = {"SUPO", "ROMA", "++++"};
        for (int i = 0; i < PACKETS; i++) {
            Frame frame = new Frame(Address.parse(destinations[random.nextInt(destinations.length)]),
                    Address.parse(origins[random.nextInt(origins.length)]), random(random, 70));
            add(Pcapng.AIR, Bytes.join(Bytes.of(1, 1, random.nextInt(4), 255, random.nextInt(3), 0, 1, 'b', 0),
                    frame.encode()));
            // A command byte or a status, and then anything.
            Request.Command[] commands = Request.Command.values();
            Bytes message = Bytes.join(Bytes.of(random.nextBoolean()
                    ? commands[random.nextInt(commands.length)].letter() : random.nextInt(3)), random(random, 40));
            boolean own = random.nextBoolean();
            add(Tshark.SERIAL, Bytes.join(Bytes.of(1, random.nextInt(2), 1, 'b'), new SerialPacket(random.nextInt(4),
                    own ? new Frame(Address.SERIAL, Address.SERIAL, message) : frame).encode()));
        }
        dissect();
    }

    private static Stream<JsonObject> vectors(String file, String list) throws Exception {
        Path path = Path.of(System.getProperty("javino.root"), "test/vectors", file + ".json");
        return JsonParser.parseString(Files.readString(path)).getAsJsonObject().getAsJsonArray(list).asList().stream()
                .map(JsonElement::getAsJsonObject);
    }

    @Test
    @Tag("verify")
    void goodPackets_cutOffAnywhere_areShown() throws Exception {
        List<Bytes> records = new ArrayList<>();
        for (String field : List.of("acknowledgements", "envelopes")) {
            vectors(field, "valid").limit(8).forEach(vector -> records.add(Bytes.join(
                    Bytes.of(1, 1, 0, 255, 255, 0, 1, 'b', 2, 'n', 'o'),
                    Bytes.ofHex(vector.get("frame").getAsString()))));
        }
        vectors("contents", "valid").forEach(vector -> records.add(Bytes.join(Bytes.of(1, 0, 0, 2, 0, 0, 0, 0),
                new Frame(Address.BROADCAST, Address.parse("ROMA"), Bytes.ofHex(vector.get("content").getAsString()))
                        .encode())));
        for (Bytes record : records) {
            for (int length = 0; length < Math.min(record.length(), 120); length++) {
                add(Pcapng.AIR, record.slice(0, length));
            }
        }
        // A reply cut off within its frame, which then is whole again.
        vectors("commands", "requests").forEach(request -> add(Tshark.SERIAL, serial(0, message(request))));
        for (JsonObject reply : vectors("commands", "replies").toList()) {
            Bytes message = message(reply);
            for (JsonObject request : vectors("commands", "requests")
                    .filter(one -> one.get("name").equals(reply.get("name"))).limit(1).toList()) {
                for (int length = 0; length < Math.min(message.length(), 60); length++) {
                    add(Tshark.SERIAL, serial(0, message(request)));
                    add(Tshark.SERIAL, serial(1, message.slice(0, length)));
                }
            }
        }
        dissect();
    }

    private static Bytes message(JsonObject vector) {
        return Bytes.ofHex(vector.get("message").getAsString());
    }

    private static Bytes serial(int from, Bytes message) {
        return Bytes.join(Bytes.of(1, from, 1, 'b'),
                new SerialPacket(7, new Frame(Address.SERIAL, Address.SERIAL, message)).encode());
    }

    @Test
    void keyring_withoutTheKey_opensNothingAndComplainsOfNothing() throws Exception {
        Bytes sealed = Bytes.ofHex(vectors("envelopes", "valid").toList().get(2).get("frame").getAsString());
        add(Pcapng.AIR, Bytes.join(Bytes.of(1, 1, 0, 255, 255, 0, 0, 0), sealed));
        Tshark.Dissected packet = dissect().get(0);
        assertEquals(List.of(), packet.errors());
        assertTrue(packet.shown("javino.tag.right").isEmpty());
    }
}
