package harness;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.logging.Logger;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.platform.engine.discovery.DiscoverySelectors;
import org.junit.platform.launcher.LauncherDiscoveryRequest;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;
import org.junit.platform.launcher.listeners.SummaryGeneratingListener;
import org.junit.platform.launcher.listeners.TestExecutionSummary;

/** What the runs of a class by one seed or several leave, and when they end. */
class SeededRunsTest {

    private static final Path FAILURES = Path.of("build/failures");
    private static final String BEGIN = "Subject.board_isGreeted-";
    private static final Logger LOGGER = Logger.getLogger("subject");
    private static final long NONE = 0;
    private static final List<Long> SEEDS = new ArrayList<>();

    private static long failing = NONE;
    private static boolean closing = true;

    /** A class of tests, launched by those below; by itself it does not fail. */
    @InEmulatedTime
    static class Subject {

        @Test
        void board_isGreeted(@TempDir Path folder) throws Exception {
            Emulator emulator = new Emulator.Scenario().board("station", "Station").start(folder);
            Host.of(emulator, "station").awaitOnline(1);
            long seed = EmulatedRun.current() == null ? NONE : EmulatedRun.current().seed();
            SEEDS.add(seed);
            LOGGER.info("greeted by seed " + seed);
            if (closing) {
                emulator.close();
            }
            assertNotEquals(failing, seed + (seed == NONE ? 1 : 0));
        }
    }

    @AfterEach
    void forget() throws IOException {
        failing = NONE;
        closing = true;
        SEEDS.clear();
        for (Path folder : left()) {
            try (Stream<Path> files = Files.list(folder)) {
                for (Path file : files.toList()) {
                    Files.delete(file);
                }
            }
            Files.delete(folder);
        }
    }

    private static List<Path> left() throws IOException {
        if (!Files.exists(FAILURES)) {
            return List.of();
        }
        try (Stream<Path> all = Files.list(FAILURES)) {
            return all.sorted().toList();
        }
    }

    /** Runs the subject with values as {@code -P} gives them; returns how it went, and writes what it prints. */
    private static TestExecutionSummary run(Map<String, String> values, ByteArrayOutputStream printed) {
        Map<String, String> all = new HashMap<>(Map.of("javino.seed", "1", "javino.seeds", "1", "javino.keep", "false",
                "javino.realTime", "false", "javino.suite", ":some:suite"));
        all.putAll(values);
        LauncherDiscoveryRequest request = LauncherDiscoveryRequestBuilder.request()
                .selectors(DiscoverySelectors.selectClass(Subject.class)).configurationParameters(all).build();
        SummaryGeneratingListener listener = new SummaryGeneratingListener();
        PrintStream before = System.out;
        System.setOut(new PrintStream(printed, true));
        try {
            LauncherFactory.create().execute(request, listener);
        } finally {
            System.setOut(before);
        }
        return listener.getSummary();
    }

    @Test
    void seeds_oneFails_isTheLastAndLeavesWhatRepeatsIt() throws Exception {
        failing = 4;
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        TestExecutionSummary summary = run(Map.of("javino.seed", "3", "javino.seeds", "4"), printed);

        assertEquals(List.of(3L, 4L), SEEDS);
        assertEquals(1, summary.getTestsFailedCount());
        assertEquals(1, summary.getTestsSucceededCount());
        Path folder = FAILURES.resolve(BEGIN + failing);
        assertEquals(List.of(folder), left());
        String again = "gradle :some:suite --tests 'Subject.board_isGreeted' -Pseed=4";
        assertTrue(printed.toString().contains(again), printed.toString());
        assertTrue(printed.toString().contains(folder.toAbsolutePath().toString()), printed.toString());
        assertEquals(again + "\n", Files.readString(folder.resolve("again")));
        assertTrue(Files.readString(folder.resolve("trace1.jsonl")).contains("\"seed\":4,"), "the seed of its trace");
        assertTrue(Files.readString(folder.resolve("log")).contains("greeted by seed 4"), "its log");
    }

    @Test
    void seeds_allPass_runAllAndLeaveNothing() throws Exception {
        TestExecutionSummary summary = run(Map.of("javino.seeds", "3"), new ByteArrayOutputStream());
        assertEquals(List.of(1L, 2L, 3L), SEEDS);
        assertEquals(3, summary.getTestsSucceededCount());
        assertEquals(List.of(), left());
    }

    @Test
    void keep_runThatPasses_leavesTheSameTraceEachTime() throws Exception {
        Path trace = FAILURES.resolve(BEGIN + 1).resolve("trace1.jsonl");
        run(Map.of("javino.keep", ""), new ByteArrayOutputStream());
        String first = Files.readString(trace);
        run(Map.of("javino.keep", ""), new ByteArrayOutputStream());
        assertEquals(first, Files.readString(trace));
        assertFalse(Files.exists(trace.resolveSibling("again")), "it has not failed");
    }

    @Test
    void emulator_leftOpen_failsTheRunAndNotTheNext() throws Exception {
        closing = false;
        TestExecutionSummary summary = run(Map.of("javino.seeds", "3"), new ByteArrayOutputStream());
        assertEquals(List.of(1L), SEEDS);
        assertEquals("the test has not closed its emulator", summary.getFailures().get(0).getException().getMessage());
        closing = true;
        assertEquals(1, run(Map.of(), new ByteArrayOutputStream()).getTestsSucceededCount());
    }

    @Test
    void realTime_hasOneRunWithoutASeed() throws Exception {
        run(Map.of("javino.realTime", "true", "javino.seeds", "3"), new ByteArrayOutputStream());
        assertEquals(LongStream.of(NONE).boxed().toList(), SEEDS);
        assertEquals(List.of(), left());
    }
}
