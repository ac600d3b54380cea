package uppaal.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class EdgesTest {
    @TempDir
    private Path folder;

    @Test
    void run_allEdgesInSomeRuns_endsWithZero() throws IOException {
        List<String> all = Replay.edges().stream().sorted().toList();
        Files.write(folder.resolve("one"), all.subList(0, 100));
        assertEquals(1, Edges.run(folder, 95));
        Files.write(folder.resolve("other"), all.subList(50, all.size()));
        assertEquals(0, Edges.run(folder, 100));
    }

    @Test
    void run_fewerThanAreEnough_endsWithOne() throws IOException {
        List<String> all = Replay.edges().stream().sorted().toList();
        Files.write(folder.resolve("run"), all.subList(1, all.size()));
        assertEquals(0, Edges.run(folder, 99));
        assertEquals(1, Edges.run(folder, 100));
    }

    @Test
    void edges_areThoseThatTracesTake() {
        assertEquals(132, Replay.edges().size());
        assertEquals(23, Replay.transitions().size());
    }
}
