package features;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RealTimeEngineTest {

    private static final String PIN = "{\"t\": 1, \"board\": \"robot\", \"event\": \"pin\", \"name\": \"lamp\", "
            + "\"level\": 1}";

    /** The agent's process tells of an action's end before the emulator tells of the pin. */
    @Test
    void state_thatIsToldLate_isWaitedFor(@TempDir Path folder) {
        Run run = new Run("a.feature:1", folder, true, null);
        try (RealTimeEngine engine = new RealTimeEngine(folder, run.account) {
            @Override
            public void command(Map<String, Object> command) {
                throw new AssertionError("nobody commands");
            }
        }) {
            run.engine = engine;
            engine.at(100 * Window.MILLI, () -> run.account.traced(PIN, own -> engine.nanos()));
            assertDoesNotThrow(() -> run.expected.now(() -> run.account.state("robot", "lamp").equals("on"),
                    () -> "lamp is off"));
        }
    }
}
