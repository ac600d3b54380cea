package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.LongStream;

import org.junit.jupiter.api.extension.AnnotatedElementContext;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.io.TempDirFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import javino.protocol.Bytes;

/** Moves to and fro, with whatever goes wrong: never two are awake, and in the end there is exactly one, unchanged. */
class RandomMovesTest {

    private static final String AGENT = "inspector";
    private static final int MOVES = 40;

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
        return LongStream.rangeClosed(1, Long.getLong("seeds", 300));
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void moves_killsLossesAndSilence_neverTwoAwakeAndOneInTheEnd(long seed) throws IOException {
        World world = new World(seed, folder);
        List<Bytes> texts = List.of(Bytes.ofText("+!p(" + seed + ") <- a(X); b(X).\n".repeat(5)),
                Bytes.ofText("x".repeat(world.random.nextInt(2000)) + seed));
        world.side(World.STATION).program.put(AGENT, texts);
        world.watched = AGENT;
        world.side(World.STATION).start();
        world.side(World.BUS).start();
        for (int i = 0; i < MOVES; i++) {
            world.lost = world.random.nextDouble() * 0.3;
            world.untold = world.random.nextDouble() * 0.2;
            world.twice = world.random.nextDouble() * 0.2;
            world.victim = world.random.nextBoolean() ? World.STATION : World.BUS;
            world.killAfter = world.random.nextInt(30) - 5;
            for (World.Side side : List.of(world.side(World.STATION), world.side(World.BUS))) {
                if (side.on && side.awake.containsKey(AGENT)) {
                    side.depart(AGENT, world.random.nextBoolean() ? Protocol.MUTUALISM : Protocol.INQUILINISM,
                            side.address.equals(World.STATION) ? World.BUS : World.STATION);
                    break;
                }
            }
            world.runUntil(world.millis() + world.random.nextInt(20_000));
            world.contact = world.random.nextInt(4) > 0;
            world.runUntil(world.millis() + world.random.nextInt(100_000));
        }
        world.lost = 0;
        world.untold = 0;
        world.contact = true;
        world.killAfter = -1;
        world.runUntil(world.millis() + 600_000);
        assertEquals(1, world.awake(AGENT), () -> world.side(World.STATION).told + "\n" + world.side(World.BUS).told);
        for (World.Side side : List.of(world.side(World.STATION), world.side(World.BUS))) {
            assertEquals(List.of(), side.open(), "nobody waits for ever");
            if (side.awake.containsKey(AGENT)) {
                assertEquals(texts, side.awake.get(AGENT));
            }
        }
    }
}
