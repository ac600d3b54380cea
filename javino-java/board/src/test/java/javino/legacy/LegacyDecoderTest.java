package javino.legacy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import javino.protocol.Bytes;
import javino.protocol.ProtocolException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class LegacyDecoderTest {

    private final LegacyDecoder decoder = new LegacyDecoder();

    /** The texts of the messages that are found in what is fed in pieces of a size. */
    private List<String> feed(Bytes bytes, int step) throws ProtocolException {
        List<String> texts = new ArrayList<>();
        for (int at = 0; at < bytes.length(); at += step) {
            byte[] piece = bytes.slice(at, Math.min(at + step, bytes.length())).toArray();
            for (LegacyMessage message : decoder.feed(piece, piece.length)) {
                texts.add(message.text().text());
            }
        }
        return texts;
    }

    private List<String> feed(String bytes) throws ProtocolException {
        return feed(Bytes.ofText(bytes), Integer.MAX_VALUE / 2);
    }

    private static String encoded(String text) {
        return "fffe" + String.format("%02X", text.length()) + text;
    }

    @Test
    void feed_messagesInPiecesOfEachSize_findsThem() throws ProtocolException {
        List<String> texts = List.of("ledStatus(on);", "", "x", "fffe02", "y".repeat(255));
        Bytes line = Bytes.ofText(String.join("", texts.stream().map(LegacyDecoderTest::encoded).toList()));
        for (int step = 1; step <= line.length(); step++) {
            assertEquals(texts, feed(line, step), "in pieces of " + step);
            assertEquals(0, decoder.skipped());
        }
    }

    @ParameterizedTest
    @CsvSource({"fffe0Bledoff,nothing", "fffe0bgetPercepts,getPercepts", "fffe0BgetPercepts,getPercepts",
            "FFFE01x,nothing", "fffe1,nothing"})
    void feed_digitsOfEitherCase_areRead(String line, String expected) throws ProtocolException {
        assertEquals(expected.equals("nothing") ? List.of() : List.of(expected), feed(line));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', value = {
            "\u00ff\u00ff        | 4",
            "f                     | 1",
            "ff                    | 2",
            "fff                   | 3",
            "fffffff               | 7",
            "ffx                   | 3",
            "fffx                  | 4",
            "ffe                   | 3",
            "fffe                  | 0",
            "fffeX                 | 5",
            "fffe1X                | 6",
            "fffe-1                | 6",
            "fffe+1                | 6",
            "\"fffe \"             | 5",
            "hello fff             | 9",
    })
    void feed_noiseBeforeAMessage_isSkippedAndTheMessageFound(String noise, int skipped) throws ProtocolException {
        // A preamble that is whole takes the next one's first two letters for a size: so it ends with the silence.
        boolean whole = noise.equals("fffe");
        List<String> before = feed(noise);
        if (whole) {
            assertTrue(decoder.abandon());
        }
        assertEquals(List.of(), before);
        assertEquals(List.of("dark"), feed(encoded("dark")));
        assertEquals(whole ? 4 : skipped, decoder.skipped());
    }

    @Test
    void feed_afterTooLongAText_findsTheNextMessage() throws ProtocolException {
        String percepts = "distance(100);".repeat(20);
        // The older library writes the length's first two digits of three.
        List<String> found = feed("fffe" + String.format("%02X", percepts.length()).substring(0, 2) + percepts
                + encoded("dark"));
        assertEquals(List.of(percepts.substring(0, 0x11), "dark"), found);
        assertEquals(percepts.length() - 0x11, decoder.skipped());
    }

    @ParameterizedTest
    @ValueSource(strings = {"f", "fff", "fffe", "fffe0", "fffe05", "fffe05ledO"})
    void abandon_messageBegun_isCountedAndTheNextFound(String begun) throws ProtocolException {
        assertEquals(List.of(), feed(begun));
        assertTrue(decoder.abandon());
        assertFalse(decoder.abandon());
        assertEquals(begun.length(), decoder.skipped());
        assertEquals(List.of("dark"), feed(encoded("dark")));
    }

    @Test
    void feed_randomBytes_neverFailsAndCountsAll() {
        Random random = new Random(5);
        String likely = "fffe0123456789abcdefABCDEF;(x)";
        for (int run = 0; run < 2000; run++) {
            LegacyDecoder fresh = new LegacyDecoder();
            byte[] bytes = new byte[random.nextInt(600)];
            for (int i = 0; i < bytes.length; i++) {
                bytes[i] = (byte) (random.nextInt(8) == 0 ? random.nextInt(256)
                        : likely.charAt(random.nextInt(random.nextBoolean() ? 4 : likely.length())));
            }
            long used = fresh.feed(bytes, bytes.length).stream().mapToInt(message -> message.encode().length()).sum();
            fresh.abandon();
            assertEquals(bytes.length, used + fresh.skipped());
        }
    }

    @Test
    void feed_messagesAmongRandomDamage_laterOnesAreFound() throws ProtocolException {
        Random random = new Random(6);
        for (int run = 0; run < 1000; run++) {
            byte[] damaged = encoded("light(312);door(open);").getBytes(StandardCharsets.UTF_8);
            damaged[random.nextInt(damaged.length)] ^= (byte) (1 << random.nextInt(8));
            decoder.feed(damaged, damaged.length);
            // The board speaks only when asked: silence ends what the damage has left open.
            decoder.abandon();
            assertEquals(List.of("dark"), feed(encoded("dark")));
        }
    }
}
