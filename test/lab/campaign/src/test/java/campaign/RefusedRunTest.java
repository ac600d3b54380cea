package campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.Report;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** A campaign goes on behind a run that the replay refuses. */
@Tag("soak")
class RefusedRunTest {

    @Test
    void close_ofARunThatTheReplayRefuses_isToldInTheReportWithSeedAndTrace() throws Exception {
        Report report = new Report("some", new PrintStream(OutputStream.nullOutputStream()));
        Field field = Field.start(new Emulator.Scenario().seed(7).inEmulatedTime(),
                List.of(new Field.Cell("Station", 1)), report);
        try {
            Field.Post one = field.cell(0).get(0);
            Host.of(field.emulator(), one.name()).as(one.address().toString(), Map.of());
            field.emulator().command(Map.of("do", "transition", "machine", "nothing", "host",
                    one.address().toString(), "peer", "SUBB", "id", "929240ac", "state", "gone"));

            field.close();

            assertEquals(1, report.violations().size(), report.violations()::toString);
            List<String> lines = report.violations().get(0).lines().toList();
            assertEquals("some: runs that the replay refuses: 1", lines.get(0));
            assertTrue(lines.get(1).startsWith("seed 7: "), lines::toString);
            assertTrue(lines.get(1).endsWith("; its trace is in " + field.folder()), lines::toString);
            assertTrue(Files.size(field.folder().resolve("trace1.jsonl")) > 0);
        } finally {
            Field.delete(field.folder());
        }
    }
}
