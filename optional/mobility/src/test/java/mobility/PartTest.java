package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import java.util.zip.Deflater;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import javino.protocol.Bytes;

class PartTest {

    private static Part of(Bytes text, Bytes packed) {
        return new Part(Part.hash(text), packed.length(), text.length());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "x", "+!start <- .print(\"h\u00e9\"); .wait(1000); !start."})
    void unpack_whatWasPacked_isTheText(String content) throws RefusedException {
        Bytes text = Bytes.ofText(content);
        Bytes packed = Part.pack(text);
        assertEquals(text, of(text, packed).unpack(packed));
    }

    @Test
    void pack_anAgentsPlans_haveLessBytesThanWithoutTheDictionary() {
        Bytes text = Bytes.ofText("""
                +!inspect : true <- .send(bus,askOne,proximity(_),P); !note(P); .wait(1000); !inspect
                +!note(proximity(X)) : X<20 <- +close(X); .print("close: ",X)
                -!inspect[error(E),error_msg(M)] <- .print("cannot: ",M)
                """);
        Deflater plain = new Deflater(Deflater.BEST_COMPRESSION, true);
        plain.setInput(text.toArray());
        plain.finish();
        int without = plain.deflate(new byte[1000]);
        plain.end();
        assertTrue(5 * Part.pack(text).length() < 4 * without, Part.pack(text).length() + " of " + without);
    }

    @Test
    void dictionary_isThatOfTheSpecification() throws IOException {
        String section = Files.readString(Path.of(System.getProperty("javino.root"), "SPEC.md"))
                .split("### 9.5 Dictionary\n")[1];
        assertEquals(section.split("```\n")[1], Part.DICTIONARY + "\n");
    }

    @Test
    void unpack_bomb_isRefusedWithoutItsText() {
        Bytes zeros = Bytes.copyOf(new byte[10_000_000]);
        Bytes bomb = Part.pack(zeros);
        Part offered = new Part(Part.hash(zeros), bomb.length(), 1000);
        assertEquals("damaged", assertThrows(RefusedException.class, () -> offered.unpack(bomb)).error());
    }

    @Test
    void unpack_anotherText_isRefused() {
        Bytes text = Bytes.ofText("b(1)");
        Bytes other = Part.pack(Bytes.ofText("b(2)"));
        assertThrows(RefusedException.class, () -> of(text, other).unpack(other));
    }

    @Test
    void unpack_damagedOrCut_isTheTextOrRefused() throws RefusedException {
        Bytes text = Bytes.ofText("+!p(X) <- q(X); !p(X+1). ".repeat(20));
        Bytes packed = Part.pack(text);
        Random random = new Random(5);
        for (int i = 0; i < 2_000; i++) {
            byte[] bytes = packed.slice(0, 1 + random.nextInt(packed.length())).toArray();
            bytes[random.nextInt(bytes.length)] ^= 1 << random.nextInt(8);
            Bytes damaged = Bytes.copyOf(bytes);
            try {
                assertEquals(text, of(text, packed).unpack(damaged));
            } catch (RefusedException e) {
                assertEquals("damaged", e.error());
            }
        }
    }

    @Test
    void unpack_noUtf8_isRefused() {
        Bytes text = Bytes.of(0xFF);
        Bytes packed = Part.pack(text);
        assertThrows(RefusedException.class, () -> of(text, packed).unpack(packed));
    }
}
