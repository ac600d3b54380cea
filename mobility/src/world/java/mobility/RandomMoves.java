package mobility;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

import javino.protocol.Bytes;

/** Moves of one agent to and fro in a {@link World}, with whatever goes wrong, and what came of them. */
public final class RandomMoves {

    /** So many moves are tried in one run. */
    public static final int MOVES = 40;

    private static final String AGENT = "inspector";

    /**
     * What came of a run.
     *
     * @param begun     moves that were begun.
     * @param arrived   moves at whose end the agent woke elsewhere.
     * @param refusing  moves begun to a MAS that admitted nobody then.
     * @param messages  that were said.
     * @param lost      messages that did not arrive.
     * @param kills     how often a program was killed, by what it was about to do or had just done.
     * @param both      times at which two were awake, with what was known.
     * @param atTheEnd  agents awake when contact had been back for ten minutes; one is right.
     * @param changed   agents awake then that were not as they had been.
     * @param unasked   arrivals that no plan had admitted.
     * @param unended   records of moves then that had not ended.
     * @param told      what both programs said.
     */
    public record Tally(long begun, long arrived, long refusing, long messages, long lost,
            Map<String, Integer> kills, List<String> both, int atTheEnd, long changed, long unasked, int unended,
            List<String> told) {
    }

    private RandomMoves() {
    }

    /** @param folder for the records of both; empty. */
    public static Tally run(long seed, Path folder) throws IOException {
        World world = new World(seed, folder);
        List<Bytes> texts = List.of(Bytes.ofText("+!p(" + seed + ") <- a(X); b(X).\n".repeat(5)),
                Bytes.ofText("x".repeat(world.random.nextInt(2000)) + seed));
        Set<List<Bytes>> known = new HashSet<>(Set.of(texts));
        world.lived = old -> {
            // Its state is another at each move, so that something of it travels each time.
            byte[] state = new byte[100 + world.random.nextInt(1500)];
            world.random.nextBytes(state);
            List<Bytes> now = List.of(old.get(0), Bytes.ofText(Bytes.copyOf(state).hex()));
            known.add(now);
            return now;
        };
        List<World.Side> sides = List.of(world.side(World.STATION), world.side(World.BUS));
        sides.get(0).program.put(AGENT, texts);
        world.watched = AGENT;
        sides.forEach(World.Side::start);
        long begun = 0;
        long refusing = 0;
        for (int i = 0; i < MOVES; i++) {
            disturb(world);
            sides.forEach(side -> side.admits = world.random.nextInt(8) > 0);
            World.Side other = sides.get(1);
            for (World.Side side : sides) {
                if (side.on && side.awake.containsKey(AGENT)) {
                    begun++;
                    refusing += other.admits ? 0 : 1;
                    side.depart(AGENT, world.random.nextBoolean() ? Protocol.MUTUALISM : Protocol.INQUILINISM,
                            other.address);
                    break;
                }
                other = side;
            }
            world.runUntil(world.millis() + world.random.nextInt(20_000));
            world.contact = world.random.nextInt(4) > 0;
            world.runUntil(world.millis() + world.random.nextInt(100_000));
        }
        calm(world);
        world.runUntil(world.millis() + 600_000);
        List<String> told = new ArrayList<>();
        sides.forEach(side -> told.addAll(side.told));
        return new Tally(begun, world.arrivals, refusing, world.messages, world.lostMessages, world.kills, world.both,
                world.awake(AGENT),
                sides.stream().filter(side -> side.awake.containsKey(AGENT))
                        .filter(side -> !known.contains(side.awake.get(AGENT))).count(),
                world.unasked, sides.stream().mapToInt(side -> side.open().size()).sum(), told);
    }

    private static void disturb(World world) {
        world.lost = world.random.nextDouble() * 0.3;
        world.untold = world.random.nextDouble() * 0.2;
        world.twice = world.random.nextDouble() * 0.2;
        world.victim = world.random.nextBoolean() ? World.STATION : World.BUS;
        world.killAfter = world.random.nextInt(30) - 5;
    }

    private static void calm(World world) {
        world.lost = 0;
        world.untold = 0;
        world.contact = true;
        world.killAfter = -1;
    }
}
