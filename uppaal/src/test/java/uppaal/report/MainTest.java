package uppaal.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MainTest {
    @TempDir
    private Path folder;

    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();

    private List<String> run(Path models) throws IOException {
        PrintStream out = new PrintStream(printed, true, StandardCharsets.UTF_8);
        return Main.run(models, folder.resolve("output"), new CheckReport(out));
    }

    @Test
    void run_ourModels_areAsExpected() throws IOException {
        assertEquals(List.of(), run(Path.of("models")));
        String report = printed.toString(StandardCharsets.UTF_8);
        assertTrue(report.contains("Counterexample to P7") && report.contains("Counterexample to P8"), report);
    }

    @Test
    void disagreements_wrongExpectation_isSaid() throws IOException {
        Path queries = Files.writeString(folder.resolve("wrong.q"), "/* Q1 fails: it stops. */\nA[] not deadlock\n");
        List<String> wrong =
                Check.of(new Scene("quiet", "", "quiet.xml", Map.of(), Map.of(), List.of(queries.toString())),
                        Path.of("models"), folder).disagreements();
        assertEquals("quiet.xml, Q1: expected that it fails, for our checker it holds", wrong.get(0));
    }

    @Test
    void compare_ourModels_areAsTheFirmware() throws IOException {
        assertEquals(List.of(), Main.compare(Path.of("models"), Firmware.of(Path.of("../javino-firmware/src"))));
    }
}
