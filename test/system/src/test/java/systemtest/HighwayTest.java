package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The scenario as a user runs it: its launcher, which starts everything else. */
class HighwayTest {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));
    private static final Path HIGHWAY = ROOT.resolve("examples/highway");

    private record Run(int status, List<String> lines) {
        String last() {
            return lines.get(lines.size() - 1);
        }
    }

    @Test
    void cleanRadio_showsAllNineBehaviours() throws Exception {
        Run run = run();

        assertEquals("highway: 9 of 9 behaviours observed", run.last(), () -> String.join("\n", run.lines));
        assertEquals(0, run.status);
        assertNothingLeft();
    }

    @Test
    void badRadio_endsCleanlyAndSaysWhatWasMissing() throws Exception {
        Run run = run("--radioBitErrorRate=0.05", "--timeout=15");

        assertTrue(run.last().matches("highway: [0-8] of 9 behaviours observed"), run.last());
        assertEquals(1, run.status);
        assertTrue(run.lines.stream().anyMatch(line -> line.contains("the agent did not say")), () -> String.join("\n", run.lines));
        assertNothingLeft();
    }

    @Test
    void missingEmulator_isSaidAndNothingIsLeft() throws Exception {
        Run run = launch(List.of("--emulator", "no-such-emulator"));

        assertTrue(run.lines.stream().anyMatch(line -> line.contains("no-such-emulator")), () -> String.join("\n", run.lines));
        assertEquals(1, run.status);
        assertNothingLeft();
    }

    private static Run run(String... options) throws Exception {
        List<String> arguments = new ArrayList<>(List.of(options));
        arguments.addAll(List.of("--emulator", ROOT.resolve("emulator/build/javino-emulator").toString()));
        return launch(arguments);
    }

    private static Run launch(List<String> arguments) throws Exception {
        String java = System.getProperty("java.home") + File.separator + "bin" + File.separator + "java";
        List<String> command = new ArrayList<>(List.of(java, "-cp", System.getProperty("java.class.path"), "highway.Highway"));
        command.addAll(arguments);
        ProcessBuilder builder = new ProcessBuilder(command).directory(HIGHWAY.toFile()).redirectErrorStream(true);
        builder.environment().put("NO_COLOR", "1");
        Process process = builder.start();
        List<String> lines = process.inputReader().lines().toList();
        return new Run(process.waitFor(), lines);
    }

    private static void assertNothingLeft() throws Exception {
        try (Stream<Path> ports = Files.exists(HIGHWAY.resolve("ports")) ? Files.list(HIGHWAY.resolve("ports")) : Stream.of()) {
            assertEquals(List.of(), ports.toList());
        }
        List<String> running = ProcessHandle.allProcesses()
            .map(process -> process.info().commandLine().orElse(""))
            .filter(line -> line.contains("highway.json") || line.contains("RunLocalMAS")).toList();
        assertEquals(List.of(), running);
    }
}
