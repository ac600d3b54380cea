package javino.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class SerialPacketTest {

    private static final VectorFile FILE = new VectorFile("packets.json");
    private static final Frame FRAME = new Frame(Address.BROADCAST, Address.parse("CAFE"), Bytes.ofText("Hello!"));

    static Stream<JsonObject> valid() {
        return FILE.list("valid");
    }

    static Stream<JsonObject> invalid() {
        return FILE.list("invalid");
    }

    private static SerialPacket packetOf(JsonObject vector) throws ProtocolException {
        return new SerialPacket(vector.get("sequence").getAsInt(), Frame.decode(VectorFile.bytes(vector, "frame")));
    }

    /** Feeds the bytes in chunks of a size; frames found, names of errors, "again" and texts. */
    private static List<Object> decode(byte[] bytes, int chunk) {
        PacketDecoder decoder = new PacketDecoder();
        List<Object> results = new ArrayList<>();
        for (int at = 0; at < bytes.length; at += chunk) {
            byte[] part = Arrays.copyOfRange(bytes, at, Math.min(at + chunk, bytes.length));
            for (PacketDecoder.Result result : decoder.feed(part, part.length)) {
                if (result instanceof PacketDecoder.Found found) {
                    results.add(found.packet());
                } else if (result instanceof PacketDecoder.Refused refused) {
                    results.add(refused.cause().error().name());
                } else if (result instanceof PacketDecoder.Printed printed) {
                    results.add(printed.text());
                } else if (((PacketDecoder.Empty) result).asksAgain()) {
                    results.add("again");
                }
            }
        }
        return results;
    }

    @ParameterizedTest
    @MethodSource("valid")
    void encode_validVector_givesItsBytes(JsonObject vector) throws ProtocolException {
        assertEquals(VectorFile.bytes(vector, "packet"), packetOf(vector).encode());
    }

    @ParameterizedTest
    @MethodSource("valid")
    void feed_validVectorInEveryChunkSize_findsIt(JsonObject vector) throws ProtocolException {
        byte[] bytes = VectorFile.bytes(vector, "packet").toArray();
        for (int chunk = 1; chunk <= bytes.length; chunk++) {
            assertEquals(List.of(packetOf(vector)), decode(bytes, chunk), "in chunks of " + chunk);
        }
    }

    @ParameterizedTest
    @MethodSource("invalid")
    void feed_invalidVector_isRefusedAndTheNextFound(JsonObject vector) {
        SerialPacket next = new SerialPacket(9, FRAME);
        byte[] bytes = Bytes.join(VectorFile.bytes(vector, "packet"), next.encode()).toArray();
        List<Object> expected = List.of(VectorFile.text(vector, "error"), next);
        assertEquals(expected, decode(bytes, 1));
        assertEquals(expected, decode(bytes, bytes.length));
    }

    @Test
    void feed_zerosOnly_givesOneEmptyPacketEach() {
        assertEquals(List.of(), decode(new byte[100], 7));
        assertEquals(Collections.nCopies(3, new PacketDecoder.Empty(false)),
                new PacketDecoder().feed(new byte[3], 3));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 100})
    void feed_emptyPacket_asksAgain(int chunk) {
        assertEquals(List.of("again", "again", "TOO_SHORT"), decode(new byte[] {0, 1, 0, 0, 1, 0, 1, 1, 0}, chunk));
    }

    @ParameterizedTest
    @CsvSource({"'t = 20,5 \u00b0\r\n', 't = 20,5 \u00b0'", "'x\r\n', x", "'  a\tb  ', 'a\tb'", "'ab', BAD_COBS",
            "'abc\u0007b', BAD_COBS", "'abc\u007fb', BAD_COBS"})
    void feed_textBetweenZeros_isTold(String sent, String told) {
        SerialPacket next = new SerialPacket(9, FRAME);
        byte[] bytes = Bytes.join(next.encode(), Bytes.ofText(sent), Bytes.of(0), next.encode()).toArray();
        for (int chunk = 1; chunk <= bytes.length; chunk++) {
            assertEquals(List.of(next, told, next), decode(bytes, chunk));
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 5, 255})
    void feed_textBeforeAPacketWithoutAZero_bothAreFound(int sequence) {
        SerialPacket next = new SerialPacket(sequence, new Frame(Address.SERIAL, Address.SERIAL, Bytes.of(0, 1, 2)));
        byte[] bytes = Bytes.join(Bytes.of(0), Bytes.ofText("t = 20\r\n"), next.encode(), Bytes.ofText("again"),
                Bytes.of(1, 0), next.encode()).toArray();
        for (int chunk = 1; chunk <= bytes.length; chunk++) {
            assertEquals(List.of("t = 20", next, "again", "again", next), decode(bytes, chunk));
        }
    }

    @Test
    void feed_longText_isToldInPartsAndThePacketBehindItFound() {
        SerialPacket next =
                new SerialPacket(5, new Frame(Address.SERIAL, Address.SERIAL, Bytes.ofText("\0" + "x".repeat(500))));
        String text = "0123456789".repeat(300);
        byte[] bytes = Bytes.join(Bytes.ofText(text), next.encode()).toArray();
        for (int chunk : new int[] {1, 7, 1000, bytes.length}) {
            List<Object> results = decode(bytes, chunk);
            assertEquals(next, results.remove(results.size() - 1));
            assertEquals(text, results.stream().map(Object::toString).collect(Collectors.joining()));
        }
    }

    @Test
    void feed_bytesThatAreNoUtf8_areNoText() {
        assertEquals(List.of("BAD_COBS"), decode(new byte[] {'a', 'b', (byte) 0xC3, 0}, 4));
    }

    @Test
    void packetComes_textAndPacketBegin_tellsThemApart() {
        PacketDecoder decoder = new PacketDecoder();
        assertFalse(decoder.packetComes());
        decoder.feed(Bytes.ofText("printed\r\n").toArray(), 9);
        assertFalse(decoder.packetComes());
        decoder.feed(new byte[1], 1);
        decoder.feed(new SerialPacket(1, FRAME).encode().toArray(), 5);
        assertTrue(decoder.packetComes());
        decoder.feed(Bytes.ofText("x".repeat(2000)).toArray(), 2000);
        assertFalse(decoder.packetComes());
    }

    @Test
    void feed_emptyBlockAfterFullOne_isAccepted() throws ProtocolException {
        // The other encoding that COBS allows: a code of 01 after a full last block.
        Frame frame = new Frame(Address.parse("CAFE"), Address.parse("ROMA"), Bytes.ofText("x".repeat(241)));
        Bytes packet = null;
        int sequence = 0;
        while (packet == null || packet.length() != 256 || packet.at(0) != 0xFF) {
            packet = new SerialPacket(++sequence, frame).encode();
        }
        byte[] longer = Bytes.join(packet.slice(0, packet.length() - 1), Bytes.of(1, 0)).toArray();
        assertEquals(List.of(new SerialPacket(sequence, frame)), decode(longer, 3));
    }

    @Test
    void feed_endlessGarbage_keepsLittleAndRecovers() {
        PacketDecoder decoder = new PacketDecoder();
        byte[] garbage = new byte[1 << 16];
        Arrays.fill(garbage, (byte) 0x05);
        for (int i = 0; i < 100; i++) {
            assertEquals(List.of(), decoder.feed(garbage, garbage.length));
        }
        byte[] rest = Bytes.join(Bytes.of(0), new SerialPacket(1, FRAME).encode()).toArray();
        List<PacketDecoder.Result> results = decoder.feed(rest, rest.length);
        assertEquals(2, results.size());
        assertEquals(new PacketDecoder.Found(new SerialPacket(1, FRAME)), results.get(1));
    }

    @Test
    void abandon_midPacket_forgetsIt() {
        PacketDecoder decoder = new PacketDecoder();
        byte[] packet = new SerialPacket(1, FRAME).encode().toArray();
        assertFalse(decoder.abandon());
        decoder.feed(packet, 5);
        assertTrue(decoder.abandon());
        assertEquals(List.of(new PacketDecoder.Found(new SerialPacket(1, FRAME))), decoder.feed(packet, packet.length));
    }

    @Test
    void feed_randomDamage_deliversNothingThatWasNotSent() {
        Random random = new Random(42);
        int delivered = 0;
        for (int round = 0; round < 5_000; round++) {
            List<Object> sent = new ArrayList<>();
            ByteArrayOutputStream line = new ByteArrayOutputStream();
            for (int i = 0; i < 4; i++) {
                byte[] message = new byte[random.nextInt(40)];
                random.nextBytes(message);
                SerialPacket packet = new SerialPacket(random.nextInt(256),
                        new Frame(Address.SERIAL, Address.SERIAL, Bytes.copyOf(message)));
                sent.add(packet);
                line.writeBytes(packet.encode().toArray());
            }
            List<Object> found = decode(damage(line.toByteArray(), random), 1 + random.nextInt(20));
            found.removeIf(String.class::isInstance);
            assertTrue(sent.containsAll(found), "round " + round);
            delivered += found.size();
            // One damage spoils at most two packets: a lost 0x00 joins it with its neighbour.
            assertTrue(found.size() >= 2, "round " + round + " found " + found.size());
        }
        assertTrue(delivered < 20_000, "the damage was none");
    }

    private static byte[] damage(byte[] line, Random random) {
        int at = random.nextInt(line.length);
        ByteArrayOutputStream damaged = new ByteArrayOutputStream();
        damaged.write(line, 0, at);
        switch (random.nextInt(3)) {
            case 0 -> damaged.write(line[at] ^ 1 << random.nextInt(8));
            case 1 -> {
                damaged.write(random.nextInt(256));
                damaged.write(line[at]);
            }
            default -> {}
        }
        damaged.write(line, at + 1, line.length - at - 1);
        return damaged.toByteArray();
    }
}
