package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.DamagedLink;
import harness.AvrBoard;
import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.SketchBoard;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.regex.Pattern;
import javino.JavinoException;
import javino.board.SessionCounter;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A bad cable between host and board. */
@InEmulatedTime
class SerialDamageTest {

    private static final int ACTIONS = 200;
    private static final double DAMAGED_BYTES = 0.005;
    private static final Pattern PERCEPT = Pattern.compile("(performed|repeated|last)\\((\\d+)\\)");

    @TempDir
    private Path folder;

    /** Starts the sketch Counter on a board that the opening of its port does not reset. */
    SketchBoard start(Path where) throws Exception {
        return new AvrBoard(new Emulator.Scenario().board("counter", "Counter", Map.of("resetOnOpen", false))
                .start(where), "counter");
    }

    @Test
    @Tag("verify")
    void requests_completeOrFailClearlyAndNoneIsPerformedTwice() throws Exception {
        try (SketchBoard board = start(folder)) {
            List<String> failures = new ArrayList<>();
            try (Host host =
                    Host.atUsualTimes(DamagedLink.opener(Host.link(board.port()), 4711, DAMAGED_BYTES))) {
                host.board.percepts(true);
                for (int number = 1; number <= ACTIONS; number++) {
                    note(host, number, failures);
                }
                assertTrue(host.board.counters().get(SessionCounter.REPEATS) > 0, "nothing was damaged");
                host.perceptsSoFar().forEach(SerialDamageTest::assertWhole);
            }
            assertCounts(board, failures);
        }
    }

    private static void note(Host host, int number, List<String> failures) throws Exception {
        CompletableFuture<OptionalInt> action = host.board.act("note(" + number + ")");
        try {
            assertEquals(OptionalInt.of(~number), Host.await(action));
        } catch (ExecutionException failed) {
            assertTrue(failed.getCause() instanceof JavinoException, failed.toString());
            failures.add(failed.getCause().getMessage());
        }
    }

    private static void assertWhole(List<String> percepts) {
        percepts.forEach(percept -> assertTrue(PERCEPT.matcher(percept).matches(), percept));
    }

    /** Asks over a good cable. */
    private static void assertCounts(SketchBoard board, List<String> failures) throws Exception {
        try (Host host = board.host()) {
            host.board.percepts(true);
            Map<String, Integer> counts = new java.util.HashMap<>();
            for (String percept : host.percepts(all -> all.size() == 3)) {
                var parts = PERCEPT.matcher(percept);
                assertTrue(parts.matches(), percept);
                counts.put(parts.group(1), Integer.valueOf(parts.group(2)));
            }
            assertEquals(0, counts.get("repeated"));
            assertTrue(counts.get("performed") <= ACTIONS);
            assertTrue(counts.get("performed") >= ACTIONS - failures.size(), failures.toString());
        }
    }
}
