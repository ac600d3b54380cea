package live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javino.JavinoException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TraceSourceTest {

    private static final String EVENT = "{\"t\":1.5,\"event\":\"note\",\"text\":\"<script>\"}";

    /** A trace that a hub of its own has. */
    static final Source NOTHING = nothing();

    @TempDir
    private Path folder;
    private final Hub hub = new Hub();

    private static Source nothing() {
        try {
            Path file = Files.createTempFile("trace", ".jsonl");
            file.toFile().deleteOnExit();
            return TraceSource.read(Files.writeString(file, EVENT), new Hub());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (JavinoException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void file_ofEvents_isReadToItsEnd() throws Exception {
        String decided = "{\"t\":2,\"event\":\"agent-choice\"}";
        Path file = Files.writeString(folder.resolve("trace.jsonl"), EVENT + "\n" + decided + "\n" + EVENT);

        Source source = TraceSource.read(file, hub);

        assertEquals(List.of(EVENT, EVENT), hub.after(0, 10, false).events());
        assertEquals(decided, source.log().orElseThrow().events().get(1).line());
        assertEquals("trace", source.kind());
        assertEquals(List.of(), source.controls());
        assertThrows(JavinoException.class, () -> source.command(new JsonObject()));
    }

    @Test
    void file_withWindowsLineEndsAndEmptyLines_isRead() throws Exception {
        Path file = Files.writeString(folder.resolve("trace.jsonl"), EVENT + "\r\n\r\n" + EVENT + "\r\n");

        TraceSource.read(file, hub);

        assertEquals(List.of(EVENT, EVENT), hub.after(0, 10, false).events());
    }

    @ParameterizedTest
    @ValueSource(strings = {"x", "{\"t\":1}"})
    void file_withAnotherLine_isRefusedWithItsNumber(String line) throws IOException {
        Path file = Files.writeString(folder.resolve("trace.jsonl"), EVENT + "\n" + line + "\n");

        String message = assertThrows(JavinoException.class, () -> TraceSource.read(file, hub)).getMessage();

        assertTrue(message.startsWith(file + ":2: this is no event"), message);
    }
}
