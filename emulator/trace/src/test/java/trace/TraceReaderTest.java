package trace;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TraceReaderTest {

    private static final String EVENT =
            "{\"t\":1.5,\"board\":\"a\",\"event\":\"x\",\"n\":3,\"who\":[\"b\"],\"hex\":\"0aff\"}";

    @Test
    void read_byteOrderMark_isSkipped(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("trace"), "\uFEFF" + EVENT + "\n" + EVENT + "\n");
        assertEquals(2, TraceReader.all(file).size());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "\n\n"})
    void read_fileWithoutAnEvent_isRefused(String text, @TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("trace"), text);
        IOException e = assertThrows(IOException.class, () -> TraceReader.all(file));
        assertTrue(e.getMessage().contains("it has no event; name the trace of a run"), e.getMessage());
    }

    @Test
    void read_stream_goesOnBehindLinesThatAreNoEvents() throws IOException {
        String tooLong = EVENT.replace("0aff", "0".repeat(BoundedLines.MOST_CHARACTERS));
        String lines = String.join("\n", EVENT, "", "oops", tooLong, EVENT + "\r", "");
        List<Integer> events = new ArrayList<>();
        List<Integer> others = new ArrayList<>();
        TraceReader.read(new ByteArrayInputStream(lines.getBytes(StandardCharsets.UTF_8)),
                event -> events.add(event.number()), none -> others.add(none.number()));
        assertEquals(List.of(1, 5), events);
        assertEquals(List.of(3, 4), others);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "x", "[]", "null", "{}", "{\"t\":1}", "{\"event\":\"x\"}",
            "{\"t\":\"1\",\"event\":\"x\"}", "{\"t\":1,\"event\":2}", "{\"t\":1,\"event\":\"x\",\"board\":[]}",
            "{\"t\":NaN,\"event\":\"x\"}", "{t:1,event:\"x\"}", EVENT + EVENT, "{\"t\":1,\"event\":\"x\""})
    void parse_otherLine_isRefusedWithItsNumber(String line) {
        String message = assertThrows(MalformedEventException.class, () -> TraceEvent.parse(7, line)).getMessage();
        assertEquals("line 7 is no line of a trace: ", message.replaceFirst(": .*", ": "));
    }

    @Test
    void fields_areOfTheirTypes() {
        TraceEvent event = TraceEvent.parse(1, EVENT);
        assertEquals(3, event.number("n"));
        assertEquals(List.of("b"), event.texts("who"));
        assertArrayEquals(new byte[] {10, -1}, event.said().orElseThrow());
        assertEquals("", event.textOrEmpty("none"));
        assertEquals("event 1 (1.500000 s, a, x)", event.toString());
    }

    @ParameterizedTest
    @CsvSource({"none, an event 'x' without 'none'", "who, an event 'x' without 'who'",
            "event, an event 'x' whose 'event' is no number"})
    void number_ofAnotherField_isRefused(String field, String why) {
        TraceEvent event = TraceEvent.parse(2, EVENT);
        assertEquals("line 2 is no line of a trace: " + why,
                assertThrows(MalformedEventException.class, () -> event.number(field)).getMessage());
        assertThrows(MalformedEventException.class, () -> event.texts("n"));
        assertThrows(MalformedEventException.class, () -> event.bytes("n"));
    }

    @Test
    void with_field_changesACopy() {
        TraceEvent event = TraceEvent.parse(1, EVENT);
        assertEquals(EVENT.replace("\"n\":3", "\"n\":4"), event.with("n", 4).line());
        assertEquals(EVENT, event.line());
    }
}
