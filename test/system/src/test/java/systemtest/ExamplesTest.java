package systemtest;

import static harness.Host.get;
import static org.junit.jupiter.api.Assertions.assertEquals;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.SerialMonitor;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/** The examples of the Arduino library that no other test uses, nor a feature (sketches.feature). */
@InEmulatedTime
class ExamplesTest {

    private static final int STEPS = 3000;
    private static final int STEPS_A_SECOND = 1500;

    @Test
    void stepper_turnsAtItsSpeedWhileItsAgentIsTold(@TempDir Path folder) throws Exception {
        Map<String, Object> watched = Map.of("model", "uno", "watch", List.of(Map.of("pin", 3, "name", "step")));
        try (Emulator emulator = new Emulator.Scenario().board("motor", "Stepper", watched).start(folder);
                Host host = Host.of(emulator, "motor")) {
            host.board.percepts(true);
            get(host.board.act("turn(" + STEPS + ")"));
            host.percepts(List.of("position(" + STEPS + ")")::equals);
            Predicate<TraceEvent> step = event -> event.is("pin", "motor") && event.number("level") == 1;
            // The percept may be here before the trace of the last steps.
            emulator.await("the last step", STEPS, step);
            List<Double> steps = emulator.trace().stream().filter(step).map(TraceEvent::seconds).toList();
            assertEquals(STEPS, steps.size());
            double aSecond = (STEPS - 1) / (steps.get(STEPS - 1) - steps.get(0));
            assertEquals(STEPS_A_SECOND, aSecond, 0.05 * STEPS_A_SECOND);
            get(host.board.act("turn(-" + STEPS + ")"));
            host.percepts(List.of("position(0)")::equals);
        }
    }

    @Test
    void twoBoards_chatByWhatIsTyped(@TempDir Path folder) throws Exception {
        try (Emulator emulator = new Emulator.Scenario()
                .board("one", "TwoBoards", Map.of("model", "uno"))
                .board("other", "TwoBoards",
                        Map.of("sensors",
                                List.of(Map.of("type", "digital", "pin", 2, "level", List.of(List.of(0, 0))))))
                .start(folder);
                SerialMonitor one = SerialMonitor.of(emulator, "one");
                SerialMonitor other = SerialMonitor.of(emulator, "other")) {
            assertEquals("ALFA: type a line", one.line());
            assertEquals("BETA: type a line", other.line());

            one.type("hello there\n");
            assertEquals("ALFA: hello there", other.line());
            other.type("hello to you\r\n");
            assertEquals("BETA: hello to you", one.line());

            one.type("x".repeat(68) + "\n");
            assertEquals("too long, not sent: 67 bytes at most", one.line());
            one.type("x".repeat(67) + "\n");
            assertEquals("ALFA: " + "x".repeat(67), other.line());
        }
    }

    @Test
    @Tag("verify")
    void twoBoards_isUnderstoodByAgentsAndUnderstandsThem(@TempDir Path folder) throws Exception {
        try (Emulator emulator =
                new Emulator.Scenario().board("one", "TwoBoards").board("station", "Station").start(folder);
                SerialMonitor one = SerialMonitor.of(emulator, "one");
                Host station = Host.of(emulator, "station").as("ROMA", Map.of())) {
            assertEquals("ALFA: type a line", one.line());
            one.type("tell;hello\n");
            assertEquals("tell;hello", station.message().content().toString());
            station.send("////", "tell;welcome");
            assertEquals("ROMA: tell;welcome", one.line());
        }
    }
}
