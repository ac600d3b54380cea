package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The distance that the vehicle sees ahead. */
@InEmulatedTime
class SonarTest {

    private static final int RESETS = 25;
    private static final Map<String, Object> WALL_AT_300_CM = Map.of("resetOnOpen", true, "sensors", List.of(
            Map.of("type", "hc-sr04", "trigger", 22, "echo", 2, "distance", List.of(List.of(0, 300)))));

    @Test
    @Tag("verify")
    void resetInTheMiddleOfAnEcho_makesNoObstacle(@TempDir Path folder) throws Exception {
        try (Emulator emulator = new Emulator.Scenario().board("car", "Vehicle", WALL_AT_300_CM).start(folder)) {
            for (int reset = 0; reset < RESETS; reset++) {
                try (Host car = Host.of(emulator, "car")) {
                    car.board.percepts(true);
                    List<String> first = car.percepts(seen -> proximity(seen) != null);
                    assertEquals("proximity(300)", proximity(first), "after reset " + reset);
                }
            }
        }
    }

    private static String proximity(List<String> percepts) {
        return percepts.stream().filter(percept -> percept.startsWith("proximity")).findFirst().orElse(null);
    }
}
