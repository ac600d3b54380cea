package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import trace.TraceEvent;

/** How often {@code loop()} turns, as the firmware's page says. */
class QuickLoopTest {

    private static final int EMULATED_SECONDS = 2;
    /** The pin of turns.cpp changes so seldom. */
    private static final int TURNS = 16;
    /** The page's figures may be so far from those of a changed library. */
    private static final double TOLERANCE = 0.1;

    @TempDir
    private Path folder;

    /** Columns: board, call, whether the board has a radio, what the page says of that; N is the figure. */
    @ParameterizedTest
    @Tag("verify")
    @CsvSource({"uno, run, false, `loop()` turns N times", "uno, run, true, `loop()` turns N times",
            "mega, run, false, `loop()` turns N times", "mega, run, true, `loop()` turns N times",
            "uno, serve, false, it turns N times on an Uno", "uno, serve, true, on an Uno (with a radio N)",
            "mega, serve, false, and N on a Mega", "mega, serve, true, on a Mega (N)"})
    void turnsOfALoop_areThoseOfThePage(String board, String call, boolean radio, String words) throws Exception {
        Matcher figure = Pattern.compile(Pattern.quote(words).replace("N", "\\E([\\d ]+)\\Q"))
                .matcher(Files.readString(SketchBuild.ROOT.resolve("javino-firmware/README.md")));
        assertTrue(figure.find(), "the page does not say " + words);
        double said = Double.parseDouble(figure.group(1).replace(" ", ""));
        assertEquals(said, turns(call, board, radio), TOLERANCE * said);
    }

    private double turns(String call, String board, boolean radio) throws Exception {
        List<String> options = new ArrayList<>(List.of("-DCALL=" + call));
        if (radio) {
            options.add("-DRADIO");
        }
        Path program = folder.resolve("turns.elf");
        String said = SketchBuild.compile(board, options, List.of("turns.cpp"), program);
        assertTrue(Files.exists(program), said);
        List<Double> edges = SketchBuild.emulate(folder, EMULATED_SECONDS, """
                {"boards": [{"name": "tested", "model": "%s", "firmware": "%s",
                    "watch": [{"pin": 8, "name": "turns"}]}]}
                """.formatted(board, program)).stream().filter(event -> event.is("pin", "tested"))
                .map(TraceEvent::seconds).filter(seconds -> seconds > 1).toList();
        return (edges.size() - 1) * TURNS / (edges.get(edges.size() - 1) - edges.get(0));
    }
}
