package capture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.ServiceLoader;
import javino.JavinoException;
import javino.cli.CommandPlugin;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

class CaptureCommandTest {

    private static final Path TRACES =
            Path.of(System.getProperty("javino.root"), "optional/capture/src/test/resources/traces");

    @TempDir
    private Path folder;

    private final StringWriter out = new StringWriter();
    private final StringWriter errors = new StringWriter();

    private int run(Object... words) {
        return new CommandLine(new CaptureCommand()).setOut(new PrintWriter(out, true))
                .setErr(new PrintWriter(errors, true)).execute(List.of(words).stream().map(Object::toString)
                        .toArray(String[]::new));
    }

    @Test
    void javino_findsTheCommand() {
        assertTrue(ServiceLoader.load(CommandPlugin.class).stream().map(ServiceLoader.Provider::type)
                .anyMatch(CaptureCommand.class::equals));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "--port a --trace b", "--write c"})
    void options_wrong_areRefused(String options) {
        assertEquals(CommandLine.ExitCode.USAGE, run((Object[]) options.split(" ")));
        assertTrue(errors.toString().contains("--port") || errors.toString().contains("Unmatched"), errors.toString());
    }

    @Test
    void trace_isNotOverwritten() throws Exception {
        Path trace = Files.writeString(folder.resolve("trace.jsonl"), "{}");
        assertEquals(CommandLine.ExitCode.USAGE, run("--trace", trace, "--write", folder.resolve("./trace.jsonl")));
        assertTrue(errors.toString().startsWith("--write would overwrite the trace"), errors.toString());
        assertEquals("{}", Files.readString(trace));
    }

    @Test
    void packets_areALineEach() {
        assertEquals(0, run("--trace", TRACES.resolve("fragments.jsonl")));
        List<String> lines = out.toString().lines().toList();
        assertEquals("    1.261913 s  board4      sent     SUPO -> +FzA  fragment  0 of z", lines.get(0));
        assertEquals("    1.262023 s  board5      intact   SUPO -> +FzA  fragment  0 of z", lines.get(1));
        assertEquals("    2.533626 s  board5      damaged  SUPO -> +FzL  fragment  3 of z, asks (no start symbol)",
                lines.get(7));
        assertEquals("    2.820720 s  board4      intact   SUPP -> +KAA  acknowledgement  8 bytes", lines.get(9));
    }

    @Test
    void copy_saysItsHops() {
        assertEquals(0, run("--trace", TRACES.resolve("relays.jsonl")));
        String copy = out.toString().lines().filter(line -> line.contains("  relay1 ") && line.contains("  sent "))
                .findFirst().orElseThrow();
        assertTrue(copy.endsWith("bytes, hops 1"), copy);
    }

    @Test
    void copy_saysTheDistanceItTells() throws Exception {
        Path trace = Files.writeString(folder.resolve("trace.jsonl"), "{\"t\":1,\"board\":\"a\",\"event\":\"rf-rx\","
                + "\"payload\":\"41\",\"hops\":3,\"distance\":0,\"start\":0.5,\"end\":1}\n");
        assertEquals(0, run("--trace", trace));
        assertTrue(out.toString().strip().endsWith(", hops 3, distance 0"), out.toString());
    }

    @Test
    void text_fromTheAir_cannotCommandTheTerminal() throws Exception {
        String event = "{\"t\":1,\"board\":\"a\",\"event\":\"rf-rx\",\"payload\":\"%s\",\"start\":0.5,\"end\":1}\n";
        Path trace = Files.writeString(folder.resolve("trace.jsonl"),
                String.format(event, "2f2f2f2f524f4d4141671b5b326a") + String.format(event, "41")
                        + String.format(event, "2f2f2f2f524f4d4141679c1b5b6a"));
        assertEquals(0, run("--trace", trace));
        assertEquals(List.of("    1.000000 s  a           intact   ROMA -> ////  broadcast  \\u001b[2j",
                "    1.000000 s  a           intact   1 bytes that are no frame: TOO_SHORT",
                "    1.000000 s  a           intact   ROMA -> ////  broadcast  host message, 4 bytes"),
                out.toString().lines().toList());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"no JSON | 2", "{\"t\":1} | 2", "[] | 2",
            "{\"t\":1,\"event\":\"rf-tx\",\"board\":\"a\"} | 2",
            "{\"t\":1,\"board\":\"a\",\"event\":\"rf-rx\",\"payload\":\"4\",\"start\":0,\"end\":0} | 2"})
    void line_thatIsNoEvent_isNamed(String line, int number) throws Exception {
        Path trace = Files.writeString(folder.resolve("trace.jsonl"), "{\"t\":0,\"event\":\"x\"}\n" + line + "\n");
        JavinoException thrown = assertThrows(JavinoException.class, () -> TraceFile.read(trace));
        assertEquals(trace + ":" + number + ": this is no event; name the trace of a run, such as build/trace.jsonl",
                thrown.getMessage());
    }

    @Test
    void standardOutput_hasTheSameBytesAsAFile() throws Exception {
        Path file = folder.resolve("capture.pcapng");
        Path trace = TRACES.resolve("highway.jsonl");
        assertEquals(0, run("--trace", trace, "--write", file));
        assertEquals("capture: 70 packets written; the trace has no bytes of serial lines",
                errors.toString().strip());
        Path piped = folder.resolve("piped.pcapng");
        Process process = new ProcessBuilder(ProcessHandle.current().info().command().orElse("java"), "-cp",
                System.getProperty("java.class.path"), "javino.cli.Main", "capture", "--trace", trace.toString(),
                "--write", "-").redirectOutput(piped.toFile()).redirectError(ProcessBuilder.Redirect.INHERIT).start();
        assertEquals(0, process.waitFor());
        assertArrayEquals(Files.readAllBytes(file), Files.readAllBytes(piped));
    }
}
