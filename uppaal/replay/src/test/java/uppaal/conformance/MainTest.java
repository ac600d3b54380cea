package uppaal.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MainTest {
    private static final Path TRACES = Path.of("src/test/resources/traces");

    @TempDir
    private Path folder;

    private static Path keys(Path trace) {
        return trace.resolveSibling(trace.getFileName().toString().replace(".jsonl", ".keys"));
    }

    private int run(String trace) throws IOException {
        return Main.run(Files.writeString(folder.resolve("trace.jsonl"), trace), null);
    }

    private static List<Path> genuine(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.toString().endsWith(".jsonl")).toList();
        }
    }

    @Test
    void run_genuineTraces_endsWithZero() throws IOException {
        for (Path trace : genuine(TRACES)) {
            assertEquals(0, Main.run(trace, keys(trace)), trace.toString());
            assertEquals(0, Main.run(trace, null), trace.toString());
        }
        for (Path trace : genuine(TRACES.resolve("keyless"))) {
            assertEquals(0, Main.run(trace, null), trace.toString());
        }
    }

    /** Its board has lost a packet while its host sent a long request. */
    @Test
    void run_packetThatABoardHasLost_endsWithOne() {
        assertEquals(1, Main.run(TRACES.resolve("refused/lost-packet.jsonl"), null));
    }

    @Test
    void run_otherKeys_endsWithOne() {
        assertEquals(1, Main.run(TRACES.resolve("relays.jsonl"), TRACES.resolve("phases.keys")));
        assertEquals(2, Main.run(TRACES.resolve("relays.jsonl"), folder.resolve("missing")));
    }

    @Test
    void run_pointIsMissing_endsWithOne() throws IOException {
        String trace = Files.readString(TRACES.resolve("relays.jsonl"));

        assertEquals(1, run(trace.replaceFirst("\\{[^}]*\"RELAY_COPY\"[^}]*}\n", "\n")));
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
