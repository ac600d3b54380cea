package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.link.SerialLink;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import trace.TraceEvent;

/**
 * The radio's timer and all else that takes timers, in small sources of ours that take them as the libraries do
 * (test/system/timers): each pair works on emulated boards, or is refused when it is built, or told.
 */
@Tag("verify")
class TimerNeighboursTest {

    private static final String FREE = "Arduino.h";
    private static final String HOSTED = " -DHOSTED";
    private static final int EMULATED_SECONDS = 3;
    /** An interrupt may hold up another for so long. */
    private static final double LATENESS_SECONDS = 0.0003;

    @TempDir
    private static Path shared;
    @TempDir
    private Path folder;

    /**
     * Each timer of the radio and each neighbour, on each board. Columns: board, the radio's timer, the neighbour's
     * header, an option for it, its pulse and its pause in µs.
     */
    @ParameterizedTest
    @CsvSource({
            "uno, 0, Servo.h, , 1500, 18500", "uno, 1, Arduino.h, -DTONE, 500, 500",
            "uno, 1, NewPing.h, , 5000, 5000", "uno, 0, IRremote.hpp, , 5000, 5000",
            "uno, 0, TimerOne.h, , 5000, 5000", "mega, 1, Servo.h, -DSERVOS=12, 1500, 18500",
            "mega, 3, Arduino.h, -DTONE, 500, 500", "mega, 4, NewPing.h, , 5000, 5000",
            "mega, 0, IRremote.hpp, , 5000, 5000", "mega, 5, TimerOne.h, , 5000, 5000"})
    void anotherTimer_bothWork(String board, int timer, String header, String option, int pulse, int pause)
            throws Exception {
        assertBothWork(board, timer, header, option, pulse, pause);
    }

    @Tag("soak")
    @ParameterizedTest
    @CsvSource({
            "uno, 0, Arduino.h, -DTONE, 500, 500", "uno, 0, NewPing.h, , 5000, 5000",
            "uno, 1, IRremote.hpp, , 5000, 5000", "uno, 0, IRremote.hpp, -DIR_USE_AVR_TIMER1, 5000, 5000",
            "mega, 0, Servo.h, -DSERVOS=48, 1500, 18500", "mega, 3, Servo.h, -DSERVOS=24, 1500, 18500",
            "mega, 4, Servo.h, -DSERVOS=36, 1500, 18500", "mega, 0, Arduino.h, -DTONE, 500, 500",
            "mega, 1, Arduino.h, -DTONE, 500, 500", "mega, 4, Arduino.h, -DTONE, 500, 500",
            "mega, 5, Arduino.h, -DTONE, 500, 500", "mega, 0, NewPing.h, , 5000, 5000",
            "mega, 1, NewPing.h, , 5000, 5000", "mega, 3, NewPing.h, , 5000, 5000",
            "mega, 5, NewPing.h, , 5000, 5000", "mega, 1, IRremote.hpp, , 5000, 5000",
            "mega, 3, IRremote.hpp, , 5000, 5000", "mega, 4, IRremote.hpp, , 5000, 5000",
            "mega, 5, IRremote.hpp, , 5000, 5000", "mega, 0, TimerOne.h, , 5000, 5000",
            "mega, 3, TimerOne.h, , 5000, 5000", "mega, 4, TimerOne.h, , 5000, 5000"})
    void anotherTimer_ofAnyOtherPair_bothWork(String board, int timer, String header, String option, int pulse,
            int pause) throws Exception {
        assertBothWork(board, timer, header, option, pulse, pause);
    }

    private void assertBothWork(String board, int timer, String header, String option, int pulse, int pause)
            throws Exception {
        for (boolean first : board.equals("uno") ? List.of(true, false) : List.of(false)) {
            List<TraceEvent> trace = emulate(board, build(board, timer, header, option, first));
            assertEquals(1, last(trace, "begun"));
            assertHeard(trace, "tested", "other");
            assertHeard(trace, "other", "tested");
            List<TraceEvent> out = pin(trace, "tested", "out").toList();
            assertTrue(out.size() > 2 * EMULATED_SECONDS * 40, out.size() + " edges");
            // The first are those of the beginning.
            for (int i = 4; i < out.size() - 1; i++) {
                double seconds = (out.get(i).number("level") == 1 ? pulse : pause) / 1e6;
                assertEquals(seconds, out.get(i + 1).seconds() - out.get(i).seconds(), LATENESS_SECONDS,
                        "at " + out.get(i).seconds() + " s");
            }
        }
    }

    /** No emulator of ours runs them. */
    @ParameterizedTest
    @CsvSource({"0, Servo.h,", "1, Arduino.h, -DTONE", "3, NewPing.h,", "0, IRremote.hpp,", "3, TimerOne.h,"})
    void anotherTimerOfALeonardo_isBuilt(int timer, String header, String option) throws Exception {
        build("leonardo", timer, header, option, true);
    }

    @Tag("soak")
    @ParameterizedTest
    @CsvSource({"3, Servo.h,", "0, Arduino.h, -DTONE", "0, NewPing.h,", "1, NewPing.h,", "1, IRremote.hpp,",
            "0, TimerOne.h,"})
    void anotherTimerOfALeonardo_ofAnyOtherPair_isBuilt(int timer, String header, String option) throws Exception {
        build("leonardo", timer, header, option, true);
    }

    /** Columns: board, the timer of both, the neighbour's header, more options, whether its header alone says so. */
    @ParameterizedTest
    @CsvSource({"uno, 1, Servo.h, , Servo", "uno, 1, TimerOne.h, , TimerOne",
            "uno, 1, IRremote.hpp, -DIR_USE_AVR_TIMER1, IRremote", "mega, 5, Servo.h, , Servo",
            "mega, 1, TimerOne.h, , TimerOne", "mega, 5, IRremote.hpp, -DIR_USE_AVR_TIMER5, IRremote",
            "leonardo, 1, Servo.h, , Servo", "leonardo, 1, TimerOne.h, , TimerOne",
            "leonardo, 1, IRremote.hpp, -DIR_USE_AVR_TIMER1, IRremote", "leonardo, 3, IRremote.hpp, , IRremote",
            "leonardo, 3, Arduino.h, -DTONE,"})
    void sameTimer_isRefusedWhenItIsBuilt(String board, int timer, String header, String option, String name)
            throws Exception {
        String first = refusal(board, timer, header, option, true);
        String linked = "multiple definition of `__vector_";
        assertTrue(first.contains(name == null ? linked
                : name + " takes the radio's timer: write #define JAVINO_RADIO_TIMER 0 before"), first);
        if (option == null || name == null) {
            String second = refusal(board, timer, header, option, false);
            // If both interrupts are in one file, the compiler finds them.
            assertTrue(second.contains(linked) || second.matches("(?s).*redefinition of .void __vector_.*"), second);
        }
    }

    /** Clashes that no build can see, for each timer. Columns as above; a pin of PWM, or servos. */
    @ParameterizedTest
    @CsvSource({"uno, 0, Arduino.h, -DPWM=5", "uno, 1, Arduino.h, -DPWM=9", "mega, 0, Arduino.h, -DPWM=13",
            "mega, 1, Servo.h, -DSERVOS=13", "mega, 3, Arduino.h, -DPWM=5", "mega, 4, Servo.h, -DSERVOS=37",
            "mega, 5, Arduino.h, -DPWM=44"})
    void sameTimer_thatNoBuildCanSee_isToldByBeginAndByTheHost(String board, int timer, String header, String option)
            throws Exception {
        assertToldByBeginAndByTheHost(board, timer, header, option);
    }

    @Tag("soak")
    @ParameterizedTest
    @CsvSource({"uno, 1, Arduino.h, -DPWM=10", "mega, 1, Arduino.h, -DPWM=11", "mega, 3, Servo.h, -DSERVOS=25",
            "mega, 4, Arduino.h, -DPWM=6"})
    void sameTimer_byAnyOtherNeighbour_isToldByBeginAndByTheHost(String board, int timer, String header, String option)
            throws Exception {
        assertToldByBeginAndByTheHost(board, timer, header, option);
    }

    private void assertToldByBeginAndByTheHost(String board, int timer, String header, String option)
            throws Exception {
        assertWarned(timer, hosted(board, build(board, timer, header, option + HOSTED, true)), false);
        assertWarned(timer, hosted(board, build(board, timer, header, option + HOSTED, false)), true);
    }

    /** Where there is no host to be told, begin() is all that says so: only of what has the timer before. */
    @ParameterizedTest
    @CsvSource({"uno, 1, -DPWM=9", "uno, 1, -DPWM=9 -DRELAYS", "mega, 4, -DPWM=6", "mega, 4, -DPWM=6 -DRELAYS"})
    void sameTimer_withoutAHost_isToldByBegin(String board, int timer, String option) throws Exception {
        for (boolean first : List.of(true, false)) {
            List<TraceEvent> trace = emulate(board, build(board, timer, FREE, option, first));
            assertEquals(first ? 0 : 1, last(trace, "begun"));
            assertEquals(0, trace.stream().filter(event -> event.is("rf-tx", "tested") && first).count());
        }
    }

    /** A radio that does not start, as its pin will not do, is no other's fault. */
    @ParameterizedTest
    @CsvSource({"uno, 1, Arduino.h, -DNOTHING", "mega, 1, Servo.h, -DSERVOS=12", "uno, 0, Arduino.h, -DRX_PIN=12",
            "uno, 1, Arduino.h, -DRX_PIN=12", "mega, 3, Arduino.h, -DRX_PIN=2"})
    void anotherTimer_isNotWarnedOf(String board, int timer, String header, String option) throws Exception {
        BlockingQueue<String> told = new LinkedBlockingQueue<>();
        try (Emulator emulator = hosted(board, build(board, timer, header, option + HOSTED, false));
                Board host = open(emulator, told)) {
            host.greeted().get(1, TimeUnit.MINUTES);
            host.percepts(true);
            host.statistics().get(1, TimeUnit.MINUTES);
            host.statistics().get(1, TimeUnit.MINUTES);
            assertFalse(told.stream().anyMatch(warning -> warning.contains("radio's timer")), told.toString());
        }
    }

    /** @param begun whether begin() says that all works. */
    private static void assertWarned(int timer, Emulator hosted, boolean begun) throws Exception {
        BlockingQueue<String> told = new LinkedBlockingQueue<>();
        try (Emulator emulator = hosted; Board host = open(emulator, told)) {
            String warning = told.poll(1, TimeUnit.MINUTES);
            assertTrue(warning != null && warning.contains("another part of the sketch uses the radio's timer " + timer
                    + ",") && warning.contains("write #define JAVINO_RADIO_TIMER "), host + ": " + warning);
            if (begun) {
                emulator.await("begin()", event -> event.is("pin", "tested") && event.number("level") == 1);
            } else {
                assertEquals(0, last(emulator.trace(), "begun"));
            }
        }
    }

    private Emulator hosted(String board, Path program) throws Exception {
        return new Emulator.Scenario()
                .board("tested", "Station", Map.of("model", board, "firmware", program.toString(), "watch",
                        List.of(Map.of("pin", board.equals("uno") ? 8 : 26, "name", "begun"))))
                .unmodelled()
                .start(folder);
    }

    private static Board open(Emulator emulator, BlockingQueue<String> told) {
        return Board.open(SerialLink.opener(emulator.port("tested")), BoardConfig.create(), new BoardListener() {
            @Override
            public void warning(String what) {
                told.add(what);
            }
        });
    }

    private Path build(String board, int timer, String header, String option, boolean first) throws Exception {
        Path program = folder.resolve("program.elf");
        String said = compile(board, timer, header, option, first, "ROMA", program);
        assertTrue(Files.exists(program), said);
        return program;
    }

    private String refusal(String board, int timer, String header, String option, boolean first) throws Exception {
        Path program = folder.resolve("refused.elf");
        String said = compile(board, timer, header, option, first, "ROMA", program);
        assertFalse(Files.exists(program), "it was built");
        return said;
    }

    private static String compile(String board, int timer, String header, String option, boolean first, String address,
            Path program) throws Exception {
        List<String> options = new ArrayList<>(List.of("-DJAVINO_RADIO_TIMER=" + timer,
                "-DNEIGHBOUR_HEADER=\"" + header + "\"", "-DADDRESS=\"" + address + "\""));
        if (first) {
            options.add("-DNEIGHBOUR_FIRST");
        }
        if (option != null) {
            options.addAll(List.of(option.split(" ")));
        }
        String library = header.replace(".h", ".cpp");
        List<String> sources = Files.exists(SketchBuild.SOURCES.resolve(library)) ? List.of("sketch.cpp", library)
                : List.of("sketch.cpp");
        return SketchBuild.compile(board, options, sources, program);
    }

    /** Beside a Mega without a neighbour, and without hosts, as fast as it can. */
    private List<TraceEvent> emulate(String board, Path program) throws Exception {
        Path other = shared.resolve("other.elf");
        if (!Files.exists(other)) {
            String said = compile("mega", 1, FREE, "-DANSWERS", false, "SUPO", other);
            assertTrue(Files.exists(other), said);
        }
        int base = board.equals("uno") ? 0 : 1;
        List<Integer> pins = List.of(List.of(4, 7, 8), List.of(22, 24, 26)).get(base);
        return SketchBuild.emulate(folder, EMULATED_SECONDS, """
                {"boards": [{"name": "tested", "model": "%s", "firmware": "%s", "watch": [{"pin": %d, "name": "out"},
                    {"pin": %d, "name": "heard"}, {"pin": %d, "name": "begun"}]},
                  {"name": "other", "model": "mega", "firmware": "%s", "watch": [{"pin": 24, "name": "heard"}]}]}
                """.formatted(board, program, pins.get(0), pins.get(1), pins.get(2), other));
    }

    private static Stream<TraceEvent> pin(List<TraceEvent> trace, String board, String name) {
        return trace.stream().filter(event -> event.is("pin", board) && event.text("name").equals(name));
    }

    /** The last level of a pin, which is 0 at first. */
    private static int last(List<TraceEvent> trace, String name) {
        return pin(trace, "tested", name).reduce((before, after) -> after).map(event -> event.number("level"))
                .orElse(0);
    }

    /** All that was sent, but perhaps the last. */
    private static void assertHeard(List<TraceEvent> trace, String sender, String receiver) {
        long sent = trace.stream().filter(event -> event.is("rf-tx", sender)).count();
        long heard = pin(trace, receiver, "heard").count();
        assertTrue(sent >= 2 * EMULATED_SECONDS && heard >= sent - 1, receiver + " heard " + heard + " of " + sent);
    }
}
