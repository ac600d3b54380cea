package live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import trace.BoundedLines;

@Timeout(120)
class RunSourceTest {

    private static final String EVENT = "{\"t\":1.5,\"event\":\"note\",\"text\":\"ä\"}";

    private final Hub hub = new Hub();
    private final StringWriter warnings = new StringWriter();

    private RunSource follow(String lines, Optional<ControlSocket> control) throws InterruptedException {
        RunSource source = RunSource.follow(new ByteArrayInputStream(lines.getBytes(StandardCharsets.UTF_8)), hub,
                control, new PrintWriter(warnings, true));
        while (source.isLive()) {
            Thread.sleep(2);
        }
        return source;
    }

    @Test
    void lines_someAreNoEvents_areLeftOutAndCounted() throws InterruptedException {
        String tooLong = "{\"t\":1,\"event\":\"" + "x".repeat(BoundedLines.MOST_CHARACTERS) + "\"}";
        follow(EVENT + "\nwarning\n" + tooLong + "\n[[[\n" + EVENT + "\n", Optional.empty());

        assertEquals(List.of(EVENT, EVENT), hub.after(0, 10, false).events());
        List<String> told = warnings.toString().lines().toList();
        assertEquals(2, told.size(), told.toString());
        assertEquals("watch: 3 lines that were no events were left out", told.get(1));
    }

    @Test
    void controls_areThoseOfTheSocket() throws InterruptedException {
        assertEquals(List.of(), follow("", Optional.empty()).controls());
        RunSource controlled = follow("", Optional.of(new ControlSocket(Path.of("control"))));
        assertTrue(controlled.controls().contains("jam"));
        assertFalse(controlled.controls().contains("act"));
    }
}
