package uppaal.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MainTest {
    private static final Path TRACES = Path.of("src/test/resources/traces");

    @TempDir
    private Path folder;

    private int run(String trace) throws IOException {
        return Main.run(Files.writeString(folder.resolve("trace.jsonl"), trace), null);
    }

    @Test
    void run_acceptedTrace_endsWithZero() {
        assertEquals(0, Main.run(TRACES.resolve("highway.jsonl"), null));
    }

    @Test
    void run_withKeys_opensWhatIsSealed() throws IOException {
        assertEquals(0, Main.run(TRACES.resolve("highway.jsonl"), TRACES.resolve("highway.keys")));
        assertEquals(1, Main.run(TRACES.resolve("highway.jsonl"), TRACES.resolve("fragments.keys")));
        assertEquals(2, Main.run(TRACES.resolve("highway.jsonl"), folder.resolve("missing")));
    }

    @Test
    void run_refusedTrace_endsWithOne() throws IOException {
        assertEquals(1, run(Files.readString(TRACES.resolve("highway.jsonl"))
                .replaceFirst("\"event\":\"host-transmit\"", "\"event\":\"x\"")));
    }

    @Test
    void run_noTrace_endsWithTwo() throws IOException {
        assertEquals(2, run("what is this?"));
    }

    @Test
    void run_noFile_saysSoAndEndsWithTwo() {
        PrintStream before = System.err;
        ByteArrayOutputStream said = new ByteArrayOutputStream();
        System.setErr(new PrintStream(said, true));
        try {
            assertEquals(2, Main.run(folder.resolve("missing"), null));
        } finally {
            System.setErr(before);
        }
        assertEquals("model: " + folder.resolve("missing") + ": there is no such file", said.toString().strip());
    }
}
