package uppaal.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

class InterpretationTest {
    private static final List<Interpretation> READINGS = Interpretation.all(Path.of("models"));

    @Test
    void readme_readings_areThoseThatAreFound() throws IOException {
        String readme = Files.readString(Path.of("README.md"));
        for (Interpretation reading : READINGS) {
            String row =
                    "| " + reading.sentence() + " | " + CheckReport.names(reading.failing()) + " | " + reading.states()
                            + " |";
            assertTrue(readme.contains(row), () -> "README.md needs the row " + row);
        }
    }

    @Test
    void all_readings_areDifferent() {
        assertEquals(List.of("P7", "P8"), READINGS.get(0).failing());
        assertEquals(List.of(232, 232, 144, 1272, 9256, 1376, 844),
                READINGS.stream().map(Interpretation::states).toList());
    }
}
