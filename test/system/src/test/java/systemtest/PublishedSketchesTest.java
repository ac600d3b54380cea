package systemtest;

import static harness.Host.get;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.AvrBoard;
import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.SketchBoard;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Sketches of the published library on an Uno: its examples and what public ones do, in our words. */
@InEmulatedTime
class PublishedSketchesTest {

    private static final String LAMP_ON = "lampOn";

    @TempDir
    private Path folder;

    /** Starts a board with some of the emulator's sensors. */
    SketchBoard start(String sketch, Path where, List<Map<String, Object>> sensors) throws Exception {
        return new AvrBoard(new Emulator.Scenario().board("uno", sketch, Map.of("model", "uno", "sensors", sensors))
                .start(where), "uno");
    }

    private interface Body {
        void run(Host host) throws Exception;
    }

    private void run(String sketch, List<Map<String, Object>> sensors, Body body) throws Exception {
        try (SketchBoard board = start(sketch, folder, sensors); Host host = board.host()) {
            get(host.board.greeted());
            host.board.percepts(true);
            body.run(host);
        }
    }

    private static Map<String, Object> light(String pin, int value) {
        return Map.of("type", "ldr", "pin", pin, "light", List.of(List.of(0, value)));
    }

    private static Map<String, Object> pulses(int pin, double... seconds) {
        List<List<Number>> series = new ArrayList<>(List.of(List.of(0, 0)));
        for (double begin : seconds) {
            series.add(List.of(begin, 1));
            series.add(List.of(begin + 0.005, 0));
        }
        return Map.of("type", "digital", "pin", pin, "level", series, "after", Map.of("pin", 13));
    }

    private static void perceives(Host host, String... percepts) throws InterruptedException {
        host.percepts(List.of(percepts)::equals);
    }

    private static void refuses(Host host, String action) {
        assertThrows(ExecutionException.class, () -> Host.await(host.board.act(action)));
    }

    @Test
    @Tag("verify")
    void functions_arePerceptsAndActions() throws Exception {
        run("PublishedBlink", List.of(), host -> {
            perceives(host, "lamp(off)");
            get(host.board.act(LAMP_ON));
            perceives(host, "lamp(on)");
            refuses(host, "explode");
            get(host.board.act("lampOff"));
            perceives(host, "lamp(off)");
        });
    }

    @Test
    void messages_areAskedForAndTold() throws Exception {
        run("PublishedMessages", List.of(), host -> {
            perceives(host, "device(lamp)", "level(0)");
            get(host.board.act(LAMP_ON));
            perceives(host, "device(lamp)", "level(1)");
            get(host.board.act("lampOff"));
            perceives(host, "device(lamp)", "level(0)");
            for (String text : List.of("\"ARGO online; 20 °C!\"", "speed(80)", "-3.5")) {
                get(host.board.act(text));
                perceives(host, "device(lamp)", "level(0)", "said(" + text + ")");
            }
        });
    }

    @Test
    void whatTheFunctionForgets_isToldEachTime() throws Exception {
        run("PublishedTurnstile", List.of(pulses(2, 1, 4, 7), pulses(3, 10)), host -> {
            for (int i = 0; i < 3; i++) {
                perceives(host, "passed(in)");
            }
            perceives(host, "passed(out)");
        });
    }

    @Test
    void numbersAndTexts_areAsTheSketchWritesThem() throws Exception {
        run("PublishedOven", List.of(light("A0", 512)), host -> {
            perceives(host, "temperature(70.05)", "power(\"off\")");
            get(host.board.act("power"));
            perceives(host, "temperature(70.05)", "power(\"on\")");
        });
    }

    @Test
    void sensors_areReadWhenTheSketchIsAsked() throws Exception {
        run("PublishedRover", List.of(light("A0", 300), light("A1", 700),
                Map.of("type", "hc-sr04", "trigger", 5, "echo", 4, "distance", List.of(List.of(0, 100)))),
                host -> {
                    get(host.board.act("goLeft"));
                    List<String> percepts = host.percepts(all -> all.contains("motor(left)"));
                    assertTrue(percepts.containsAll(List.of("light(300)", "battery(0.68)")), percepts::toString);
                    assertEquals(4, percepts.size());
                });
    }

    @Test
    void actionOfHalfASecond_isPerformedOnce() throws Exception {
        run("PublishedSoil", List.of(light("A0", 1023)), host -> {
            perceives(host, "moisture(0)");
            get(host.board.act("alarm"));
            perceives(host, "moisture(0)", "alarming(true)");
            get(host.board.act("quiet"));
            perceives(host, "moisture(0)");
        });
    }

    @Test
    void perceptsThatNobodyAskedFor_holdUntilTheNext() throws Exception {
        run("PublishedClock", List.of(), host -> {
            List<String> one = host.percepts(PublishedSketchesTest::isUptime);
            host.percepts(percepts -> isUptime(percepts) && !percepts.equals(one));
        });
    }

    private static boolean isUptime(List<String> percepts) {
        return percepts.size() == 2 && percepts.get(0).startsWith("uptime(") && percepts.get(1).equals("device(clock)");
    }
}
