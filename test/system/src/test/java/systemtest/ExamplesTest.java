package systemtest;

import static harness.Host.get;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.SerialMonitor;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.function.Predicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/** The examples of the Arduino library that no other test uses. */
@InEmulatedTime
class ExamplesTest {

    private static final int STEPS = 3000;
    private static final int STEPS_A_SECOND = 1500;

    @Test
    void thermometer_tellsDegreesOnBoardsOfEachSupply(@TempDir Path folder) throws Exception {
        try (Emulator emulator = new Emulator.Scenario()
                .board("warm", "Thermometer", reading("mega", 153))     // 747 mV of 5 V
                .board("cold", "Thermometer", reading("uno", 82))       // 400 mV
                .board("mini", "Thermometer", reading("promini", 232))  // 748 mV of 3.3 V
                .start(folder)) {
            assertEquals("celsius(24.71)", percept(emulator, "warm"));
            assertEquals("celsius(-9.96)", percept(emulator, "cold"));
            assertEquals("celsius(24.77)", percept(emulator, "mini"));
        }
    }

    @Test
    void button_aPressOfATwentiethOfASecond_isTold(@TempDir Path folder) throws Exception {
        List<List<Number>> level = new ArrayList<>(List.of(List.of(0, 1)));
        for (double at = 3; at < 120; at++) {
            level.add(List.of(at, 0));
            level.add(List.of(at + 0.05, 1));
        }
        try (Emulator emulator = new Emulator.Scenario().board("door", "Button",
                Map.of("model", "uno", "sensors", List.of(Map.of("type", "digital", "pin", 2, "level", level))))
                .start(folder); Host host = Host.of(emulator, "door")) {
            host.board.percepts(true);
            for (int i = 0; i < 3; i++) {
                host.percepts(List.of("pressed")::equals);
                host.percepts(List.of()::equals);
            }
        }
    }

    @Test
    void servo_turnsAsFarAsTheAgentSays(@TempDir Path folder) throws Exception {
        try (Emulator emulator = new Emulator.Scenario().board("arm", "Servo",
                Map.of("model", "uno", "watch", List.of(Map.of("pin", 9, "name", "servo")))).start(folder);
                Host host = Host.of(emulator, "arm")) {
            host.board.percepts(true);
            host.percepts(List.of("angle(90)")::equals);
            get(host.board.act("turn(180)"));
            host.percepts(List.of("angle(180)")::equals);
            for (String wrong : List.of("turn", "turn(181)", "turn(-1)", "turn(half)")) {
                assertThrows(ExecutionException.class, () -> Host.await(host.board.act(wrong)), wrong);
            }
            double[] rose = {0};
            emulator.await("a pulse of 2.4 ms", event -> event.is("pin", "arm") && pulse(event, rose) > 0.0023);
        }
    }

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

    /** How long the pin was high, in seconds, if it falls now. */
    private static double pulse(TraceEvent event, double[] rose) {
        if (event.number("level") == 1) {
            rose[0] = event.seconds();
            return 0;
        }
        return event.seconds() - rose[0];
    }

    private static Map<String, Object> reading(String model, int light) {
        return Map.of("model", model,
                "sensors", List.of(Map.of("type", "ldr", "pin", "A0", "light", List.of(List.of(0, light)))));
    }

    private static String percept(Emulator emulator, String board) throws InterruptedException {
        try (Host host = Host.of(emulator, board)) {
            host.board.percepts(true);
            return host.percepts(literals -> !literals.isEmpty()).get(0);
        }
    }
}
