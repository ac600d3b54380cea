package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.TestKeys;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javino.keyring.DeviceNotes;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The {@code javino} command in processes of its own, as a user runs it, with two boards that share a key. */
@Timeout(120)
class DriveCommandsTest {

    private static final int ENDED_BY_SIGTERM = 143;

    @AutoClose
    private Emulator emulator;

    @BeforeEach
    void switchOn(@TempDir Path folder) throws Exception {
        emulator = new Emulator.Scenario().board("police", "Vehicle").board("support", "Station").start(folder);
        Host.of(emulator, "police").as("SUPO", Map.of("SUPP", TestKeys.PAIR)).close();
        Host.of(emulator, "support").as("SUPP", Map.of("SUPO", TestKeys.PAIR)).close();
    }

    /** Starts the command on a board's port. */
    private Process start(String command, String board, String... more) throws IOException {
        String java = System.getProperty("java.home") + File.separator + "bin" + File.separator + "java";
        ProcessBuilder builder = new ProcessBuilder(Stream.concat(Stream.of(java,
                "-D" + DeviceNotes.FOLDER_PROPERTY + "=" + DeviceNotes.named().folder(), "-cp",
                System.getProperty("java.class.path"), "javino.cli.Main", command, "--port", emulator.port(board)),
                Stream.of(more)).toList());
        return builder.redirectError(ProcessBuilder.Redirect.DISCARD).start();
    }

    /** The lines that it prints, and at last its exit status. */
    private static List<String> end(Process process) throws InterruptedException {
        Stream<String> lines = process.inputReader().lines().toList().stream();
        return Stream.concat(lines, Stream.of("" + process.waitFor())).toList();
    }

    /** Reads on to the first line with these words. */
    private static void await(BufferedReader lines, String words) throws IOException {
        String line = lines.readLine();
        while (line != null && !line.contains(words)) {
            line = lines.readLine();
        }
        assertTrue(line != null, "no line has " + words);
    }

    @Test
    void percepts_andActions_areThoseOfTheSketch() throws Exception {
        List<String> percepts = end(start("percepts", "police"));
        assertTrue(percepts.get(0).startsWith("light("), percepts.toString());
        assertEquals("0", percepts.get(percepts.size() - 1));
        assertEquals(List.of("sirenOn is done", "0"), end(start("act", "police", "sirenOn")));
        assertEquals(List.of("1"), end(start("act", "police", "fly")));
    }

    @Test
    @Tag("verify")
    void send_toABoardThatIsMonitored_isDeliveredAndShown() throws Exception {
        Process monitor = start("monitor", "support");
        try {
            BufferedReader lines = monitor.inputReader();
            await(lines, "online    station 1.0, RF id SUPP");
            assertEquals(List.of("delivered", "0"), end(start("send", "police", "SUPP", "tell;help")));
            await(lines, "message   SUPO -> SUPP  sealed  tell;help");
            monitor.toHandle().destroy();
            assertEquals(ENDED_BY_SIGTERM, monitor.waitFor());
        } finally {
            monitor.destroyForcibly();
        }
        // It has blocked the radio again.
        assertEquals(List.of("undelivered", "1"), end(start("send", "police", "SUPP", "tell;help")));
    }
}
