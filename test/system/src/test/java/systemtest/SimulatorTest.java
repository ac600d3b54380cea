package systemtest;

import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Host;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javino.link.SerialLink;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A board in another simulator's world (docs/how-to/join-a-simulator.md), by its stand-in for Webots. */
class SimulatorTest {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));
    private static final Path EXAMPLE = ROOT.resolve("examples/simulator");

    @Test
    void robotThatDrives_comesToTheWall(@TempDir Path folder) throws Exception {
        Process simulator = start(folder, EXAMPLE.resolve("robot.json").toString());
        try {
            while (!Files.exists(folder.resolve("ports/robot"))) {
                assertTrue(simulator.isAlive(), "the simulator has ended");
                Thread.sleep(20);
            }
            try (Host robot = Host.over(SerialLink.opener(folder.resolve("ports/robot").toString()))) {
                robot.board.percepts(true);
                robot.percepts(seen -> isBetween(145, 155, seen));
                robot.board.act("drive").get();
                robot.percepts(seen -> isBetween(2, 7, seen) && seen.contains("moving"));
            }
        } finally {
            simulator.descendants().forEach(ProcessHandle::destroy);
            simulator.destroy();
            simulator.waitFor();
        }
    }

    /** The sonar trembles, and its sketch does not tell small changes. */
    private static boolean isBetween(int least, int most, List<String> percepts) {
        return percepts.stream().filter(percept -> percept.startsWith("proximity"))
                .mapToInt(percept -> Integer.parseInt(percept.replaceAll("\\D", "")))
                .anyMatch(centimetres -> centimetres >= least && centimetres <= most);
    }

    @Test
    void scenarioThatIsWrong_endsWithTheEmulatorsLine(@TempDir Path folder) throws Exception {
        Process simulator = start(folder, "no.json");

        String said = new String(simulator.getInputStream().readAllBytes());
        assertTrue(said.contains("no.json") && said.contains("joined: the emulator has ended"), said);
        assertTrue(simulator.waitFor() != 0);
    }

    private static Process start(Path folder, String scenario) throws IOException {
        return new ProcessBuilder(List.of("python3", EXAMPLE.resolve("joined.py").toString(),
                ROOT.resolve("emulator/build/javino-emulator").toString(), scenario))
                .directory(folder.toFile()).redirectErrorStream(true).start();
    }
}
