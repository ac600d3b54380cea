package fuzz;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** A short, fixed run of each target: its kept corpus, then new inputs from one seed. */
class TargetsTest {

    private static final int RUNS = 3000;
    private static final Path CORPUS = Path.of(System.getProperty("javino.root"), "test", "fuzz", "corpus");

    static List<Target> decoders() {
        return Target.ofJava();
    }

    @ParameterizedTest
    @MethodSource("decoders")
    void decoder_anyBytes_noFault(Target target, @TempDir Path folder) throws Exception {
        Run run = Run.of(target, CORPUS.resolve(target.name()), folder.resolve("found"), "-seed=1", "-runs=" + RUNS);

        assertEquals("", run.failure());
        assertTrue(run.executed() >= RUNS, run + " has tried too little");
        assertTrue(run.covered() > 0, run + " has not seen the code");
    }

    @Test
    void faultyDecoder_isFound(@TempDir Path folder) throws Exception {
        Target target = new Target("faulty", Target.jazzer(FaultyTarget.class));

        Run run = Run.of(target, CORPUS.resolve("ContentTarget"), folder.resolve("found"), "-seed=1", "-runs=" + RUNS);

        assertTrue(run.failure().contains("ArithmeticException"), run.failure());
    }
}
