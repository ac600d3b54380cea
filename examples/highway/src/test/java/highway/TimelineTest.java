package highway;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TimelineTest {

    private static final String ERASE = "\033[K";

    /** Gradle counts the colours as columns, and so takes a line for longer than its own progress line below it. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void line_coloured_erasesWhatIsBehindIt(boolean coloured) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        Timeline timeline = new Timeline(new PrintStream(out, true, StandardCharsets.UTF_8), coloured);
        timeline.note("a note");
        timeline.warn("a warning");
        timeline.show(new Observation(1, Observation.Kind.SAYS, Device.BUS.address, "", "Ready"));
        timeline.table(Map.of("Bus ROMA: stops", "", "Police SUPO: hears it", "police does not print \"a\""));
        timeline.verdict("refused", false);

        List<String> lines = out.toString(StandardCharsets.UTF_8).lines().toList();
        List<String> withColours = lines.stream().filter(line -> line.contains("\033[")).toList();
        assertEquals(coloured, !withColours.isEmpty());
        assertTrue(withColours.stream().allMatch(line -> line.endsWith(ERASE)), withColours::toString);
    }
}
