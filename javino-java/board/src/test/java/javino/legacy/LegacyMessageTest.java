package javino.legacy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javino.protocol.Bytes;
import javino.protocol.ProtocolException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class LegacyMessageTest {

    @Test
    void encode_getPercepts_isWhatHostsSend() {
        assertEquals(Bytes.ofText("fffe0BgetPercepts"), LegacyMessage.GET_PERCEPTS.encode());
    }

    @ParameterizedTest
    @CsvSource({"0,00", "1,01", "10,0A", "16,10", "255,FF"})
    void encode_length_isTwoHexadecimalDigits(int length, String digits) {
        String text = "x".repeat(length);
        assertEquals(Bytes.ofText("fffe" + digits + text), new LegacyMessage(Bytes.ofText(text)).encode());
    }

    @Test
    void encode_textOfManyByteCharacters_countsBytes() {
        assertEquals(Bytes.ofText("fffe05é€"), new LegacyMessage(Bytes.ofText("é€")).encode());
    }

    @Test
    void text_tooLong_throws() {
        Bytes text = Bytes.ofText("x".repeat(256));
        assertThrows(IllegalArgumentException.class, () -> new LegacyMessage(text));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', nullValues = "none", value = {
            "ledStatus(on);            | ledStatus(on)",
            "ledStatus(on)             | ledStatus(on)",
            "a(1);b(2);                | a(1) b(2)",
            "a(1);b(2)                 | a(1) b(2)",
            "' a(1) ; b(2)\r\n;'       | a(1) b(2)",
            ";;a(1);;;b(2);;           | a(1) b(2)",
    })
    void percepts_someDivided_areTakenApart(String text, String expected) throws ProtocolException {
        assertEquals(List.of(expected.split(" ")), percepts(text));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", ";", ";;", " ", " ; ;\r\n"})
    void percepts_none_areNone(String text) throws ProtocolException {
        assertEquals(List.of(), percepts(text));
    }

    private static List<String> percepts(String text) throws ProtocolException {
        List<String> texts = new ArrayList<>();
        for (Bytes percept : new LegacyMessage(Bytes.ofText(text)).percepts()) {
            texts.add(percept.text());
        }
        assertEquals(texts.stream().map(String::strip).toList(), texts, Arrays.toString(text.toCharArray()));
        return texts;
    }
}
