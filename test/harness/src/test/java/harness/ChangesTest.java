package harness;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import lockstep.Simulation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Waits of tests, in real and in emulated time. */
class ChangesTest {

    private static final Duration LONGEST = Duration.ofSeconds(20);

    private final List<String> things = new ArrayList<>();

    private String await(Changes changes, Duration longest) throws InterruptedException {
        return changes.await(() -> "nothing is here", longest,
                () -> things.isEmpty() ? null : String.join(" and ", things));
    }

    @Test
    void await_somethingIsThere_isTakenAtOnce() throws Exception {
        things.add("one");
        assertEquals("one", await(new Changes(), Duration.ZERO));
    }

    @Test
    void await_nothingComes_failsWithWhatIsLacking() {
        Changes changes = new Changes();
        AssertionError lacking = assertThrows(AssertionError.class, () -> await(changes, Duration.ofMillis(1)));
        assertEquals("nothing is here", lacking.getMessage());
    }

    @Test
    void await_anotherThreadChanges_isToldAndSeesNothingHalfway() throws Exception {
        Changes changes = new Changes();
        CompletableFuture<String> seen = new CompletableFuture<>();
        Thread waiting = new Thread(() -> {
            try {
                seen.complete(await(changes, LONGEST));
            } catch (InterruptedException | AssertionError failed) {
                seen.completeExceptionally(failed);
            }
        });
        changes.change(() -> {
            things.add("one");
            waiting.start();
            while (waiting.getState() != Thread.State.BLOCKED && !seen.isDone()) {
                Thread.onSpinWait();
            }
            things.add("two");
        });
        assertEquals("one and two", seen.get());
        waiting.join();
    }

    @Test
    void await_inEmulatedTime_passesIt(@TempDir Path folder) throws Exception {
        Emulator.Scenario scenario = new Emulator.Scenario().board("station", "Station").inEmulatedTime();
        try (Emulator emulator = scenario.start(folder)) {
            Changes changes = new Changes();
            Simulation simulation = (Simulation) changes.time();
            long begin = simulation.nanos();
            assertThrows(AssertionError.class, () -> await(changes, LONGEST));
            assertEquals(begin + LONGEST.toNanos(), simulation.nanos());

            simulation.at(begin + 2 * LONGEST.toNanos(), () -> changes.change(() -> things.add("one")));
            assertEquals("one", await(changes, LONGEST.multipliedBy(2)));
            assertEquals(begin + 2 * LONGEST.toNanos(), simulation.nanos());
            assertTrue(emulator.refusal().isEmpty(), "the model's");
        }
    }
}
