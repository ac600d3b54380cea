package systemtest;

import static harness.Host.get;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.AvrBoard;
import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.SketchBoard;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.ExecutionException;
import javino.protocol.BoardInfo;
import javino.protocol.Counter;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A host and a board of percepts and actions, here an Uno or a Mega. */
@InEmulatedTime
class SerialSessionTest {

    private static final String LED_ON = "ledOn";
    private static final String LIT = "led(on)";
    private static final String DARK = "led(off)";
    private static final int PRESSES = 3;

    @TempDir
    private Path folder;

    /** Starts a board with some of the emulator's sensors. */
    SketchBoard start(String sketch, Path where, List<Map<String, Object>> sensors) throws Exception {
        String model = List.of("Counter", "OtherPort").contains(sketch) ? "mega" : "uno";
        return new AvrBoard(new Emulator.Scenario().board("board", sketch,
                Map.of("model", model, "sensors", sensors, "watch", List.of(AvrBoard.LAMP))).start(where), "board");
    }

    private interface Body {
        void run(SketchBoard board, Host host) throws Exception;
    }

    private void blink(Body body) throws Exception {
        try (SketchBoard board = start("Blink", folder, List.of()); Host host = board.host()) {
            body.run(board, host);
        }
    }

    private void neighbour(List<Map<String, Object>> sensors, Body body) throws Exception {
        try (SketchBoard board = start("Neighbour", folder, sensors); Host host = board.host()) {
            host.board.percepts(true);
            body.run(board, host);
        }
    }

    private static Map<String, Object> light(int value) {
        return Map.of("type", "ldr", "pin", "A0", "light", List.of(List.of(0, value)));
    }

    /** A button that is pressed for a moment every other second, from when percepts are wanted. */
    private static Map<String, Object> button() {
        List<List<Number>> series = new ArrayList<>(List.of(List.of(0, 0)));
        for (int i = 1; i <= PRESSES; i++) {
            series.add(List.of(2 * i, 1));
            series.add(List.of(2 * i + 0.2, 0));
        }
        return Map.of("type", "digital", "pin", 2, "level", series, "after", Map.of("pin", 13));
    }

    private static void awaitPercepts(Host host, String... wanted) throws InterruptedException {
        host.percepts(percepts -> percepts.containsAll(List.of(wanted)));
    }

    @Test
    void hello_tellsWhatTheBoardIs() throws Exception {
        blink((board, host) -> {
            BoardInfo info = get(host.board.greeted());
            assertEquals("blink 1.0", info.firmware());
            assertFalse(info.hasRadio());
            assertEquals(List.of(LED_ON, "ledOff"), List.copyOf(info.actions()));
        });
    }

    @Test
    void actions_switchTheLampAndUnknownOnesAreRefused() throws Exception {
        blink((board, host) -> {
            host.board.percepts(true);
            host.percepts(List.of(DARK)::equals);
            get(host.board.act(LED_ON));
            board.awaitLit(1);
            host.percepts(List.of(LIT)::equals);
            AssertionError refused = assertThrows(AssertionError.class, () -> get(host.board.act("fly")));
            assertTrue(refused.getMessage().contains("UNKNOWN_ACTION"), refused.getMessage());
            get(host.board.act("ledOff"));
            host.percepts(List.of(DARK)::equals);
        });
    }

    @Test
    void hostAtAnotherPortThanSerial_isAnsweredEvenIfThePortNeverTellsItsRoom() throws Exception {
        try (SketchBoard board = start("OtherPort", folder, List.of()); Host host = board.host()) {
            assertEquals("other 1.0", get(host.board.greeted()).firmware());
            host.board.percepts(true);
            host.percepts(List.of(DARK)::equals);
            get(host.board.act(LED_ON));
            host.percepts(List.of(LIT)::equals);
        }
    }

    @Test
    @Tag("verify")
    void boardThatWasReset_isGreetedAgainAndDoesWhatItIsAsked() throws Exception {
        blink((board, host) -> {
            host.board.percepts(true);
            get(host.board.act(LED_ON));
            host.percepts(List.of(LIT)::equals);
            board.reset();
            host.awaitOnline(2);
            host.percepts(List.of(DARK)::equals);
            get(host.board.act(LED_ON));
            board.awaitLit(2);
        });
    }

    @Test
    void textOnTheLine_delaysNoPerceptAndLosesNoAction() throws Exception {
        neighbour(List.of(light(100)), (board, host) -> {
            get(host.board.greeted());
            // A board that is late is sent more than it can take before it greets.
            long before = host.counter(Counter.SERIAL_DAMAGED);
            for (int millis : List.of(100, 5)) {
                get(host.board.act("print(" + millis + ")"));
                for (int kept = millis; kept < millis + 5; kept++) {
                    get(host.board.act("keep(" + kept + ")"));
                    String percept = "kept(" + kept + ")";
                    host.percepts(percepts -> percepts.contains(percept));
                }
            }
            host.awaitOnline(1);
            if (board.isInEmulatedTime()) {
                assertEquals(before, host.counter(Counter.SERIAL_DAMAGED));
            }
        });
    }

    @Test
    void numbersUpToTheGreatestLong_areReadAndTold() throws Exception {
        try (SketchBoard board = start("Counter", folder, List.of()); Host host = board.host()) {
            host.board.percepts(true);
            for (String number : List.of("-2147483648", "2147483647")) {
                assertEquals(OptionalInt.empty(), get(host.board.act("note(" + number + ")")), "24 bits");
                host.percepts(percepts -> percepts.contains("last(" + number + ")"));
            }
            assertEquals(2, host.counter(Counter.PERCEPTS_LEFT_OUT));
            assertEquals(OptionalInt.of(-8388608), get(host.board.act("note(8388607)")));
            ExecutionException refused =
                    assertThrows(ExecutionException.class, () -> Host.await(host.board.act("note(2147483648)")));
            assertTrue(refused.getMessage().endsWith("; it says: no(number)"), refused.getMessage());
        }
    }

    @Test
    void numbers_haveTwoDecimalsAndDeadBands() throws Exception {
        neighbour(List.of(light(83)), (board, host) -> {
            awaitPercepts(host, "precise(20.75)", "steady(20.75)", "text(83)");
            board.analog("A0", 90);
            awaitPercepts(host, "precise(22.50)", "steady(20.75)", "text(90)");
            board.analog("A0", 100);
            awaitPercepts(host, "precise(25.00)", "steady(25.00)", "text(100)");
        });
    }

    @Test
    void pressForAMoment_isToldThoughPerceptsAreRare() throws Exception {
        try (SketchBoard board = start("Neighbour", folder, List.of(light(0), button())); Host host = board.host()) {
            host.board.perceptInterval(Duration.ofSeconds(1));
            host.board.percepts(true);
            // On a busy machine two may come between two readings, and are one.
            for (int i = board.isInEmulatedTime() ? PRESSES : 1; i > 0; i--) {
                host.percepts(percepts -> percepts.contains("pressed"));
                host.percepts(percepts -> !percepts.contains("pressed"));
            }
        }
    }
}
