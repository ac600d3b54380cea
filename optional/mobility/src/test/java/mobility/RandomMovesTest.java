package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.LongStream;

import org.junit.jupiter.api.extension.AnnotatedElementContext;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.io.TempDirFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Moves to and fro, with whatever goes wrong: never two are awake, and in the end there is exactly one, unchanged. */
class RandomMovesTest {

    @TempDir(factory = InMemory.class)
    Path folder;

    /** The disk is flushed at each step, which takes long where it is one. */
    static final class InMemory implements TempDirFactory {

        private static final Path MEMORY = Path.of("/dev/shm");

        @Override
        public Path createTempDirectory(AnnotatedElementContext element, ExtensionContext test) throws IOException {
            return Files.isWritable(MEMORY) ? Files.createTempDirectory(MEMORY, "javino")
                    : Files.createTempDirectory("javino");
        }
    }

    static LongStream seeds() {
        return LongStream.rangeClosed(1, 10);
    }

    static LongStream moreSeeds() {
        return LongStream.rangeClosed(11, 40);
    }

    static LongStream manySeeds() {
        return LongStream.rangeClosed(41, Long.getLong("seeds", 300));
    }

    @ParameterizedTest
    @MethodSource("moreSeeds")
    @Tag("verify")
    void moves_moreOfThem_neverTwoAwakeAndOneInTheEnd(long seed) throws IOException {
        moves_killsLossesAndSilence_neverTwoAwakeAndOneInTheEnd(seed);
    }

    @ParameterizedTest
    @MethodSource("manySeeds")
    @Tag("soak")
    void moves_manyOfThem_neverTwoAwakeAndOneInTheEnd(long seed) throws IOException {
        moves_killsLossesAndSilence_neverTwoAwakeAndOneInTheEnd(seed);
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void moves_killsLossesAndSilence_neverTwoAwakeAndOneInTheEnd(long seed) throws IOException {
        RandomMoves.Tally tally = RandomMoves.run(seed, folder);

        assertEquals(List.of(), tally.wrong());
        assertEquals(List.of(), tally.both());
        assertEquals(0, tally.lostAgents(), () -> String.join("\n", tally.told()));
        assertEquals(0, tally.doubled(), () -> String.join("\n", tally.told()));
        assertEquals(0, tally.changed());
        assertEquals(0, tally.unasked(), "came unasked");
        assertEquals(0, tally.unended(), "nobody waits for ever");
    }
}
