package keyagreement;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import javino.JavinoException;

/** Two or three hosts that meet, with whatever goes wrong, and then quiet air, in which all must be in order again. */
public final class RandomMeetings {

    private static final long STORM_MILLIS = 60_000;
    private static final long CALM_MILLIS = 30_000;
    private static final long PATIENCE_MILLIS = 90_000;
    private static final double[] ERRORS = {0, 1e-4, 1e-3, 2e-3};

    /**
     * What came of a run.
     *
     * @param seed       of the run.
     * @param wrong      what is not as it must be: accepted, doubled, set twice.
     * @param untrue     messages that were told delivered and never came.
     * @param open       messages of hosts that were not killed, and never ended.
     * @param agreements the most keys that a host got in quiet air until the last messages were delivered.
     * @param late       last messages that were not delivered, and neither was another one after them.
     * @param longest    until the last of these was, in ms.
     * @param delivered  share of the messages in the storm.
     * @param faults     by what the host was about to do.
     */
    public record Tally(long seed, List<String> wrong, long untrue, long open, int agreements, long late, long longest,
            double delivered,
            Map<String, Integer> faults) {
    }

    private RandomMeetings() {
    }

    /** Runs with the seeds from the first on. @param folder where an authority certifies the hosts. */
    public static List<Tally> run(long first, int runs, Path folder) throws IOException, JavinoException {
        Town town = new Town(folder);
        List<Identity> identities = List.of(town.certified("ROMA"), town.certified("SUPO"), town.certified("SUBB"));
        List<Tally> all = new ArrayList<>();
        for (long seed = first; seed < first + runs; seed++) {
            all.add(run(seed, identities));
        }
        return all;
    }

    private static Tally run(long seed, List<Identity> identities) {
        World world = new World(seed);
        Random random = world.random;
        List<World.Host> hosts = new ArrayList<>();
        for (int i = 0, count = 2 + random.nextInt(2); i < count; i++) {
            hosts.add(world.add(identities.get(i)));
        }
        world.air.errors = ERRORS[random.nextInt(ERRORS.length)];
        world.twice = random.nextInt(3) * 0.2;
        world.late = random.nextInt(3) * 0.1;
        List<World.Letter> letters = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            World.Host from = hosts.get(random.nextInt(hosts.size()));
            World.Host to = hosts.get(random.nextInt(hosts.size()));
            if (from != to) {
                // Often both begin at once.
                long when = random.nextInt(4) * 10_000 + random.nextInt(3) * 200;
                world.after(when, () -> letters.add(from.send(to.address)));
            }
        }
        for (int i = random.nextInt(4); i > 0; i--) {
            world.after(random.nextInt(40_000), () -> {
                world.victim = hosts.get(random.nextInt(hosts.size())).address;
                world.fault = World.Fault.values()[random.nextInt(World.Fault.values().length)];
                world.faultAfter = random.nextInt(12);
            });
        }
        world.run(STORM_MILLIS);
        world.faultAfter = -1;
        world.air.errors = 0;
        world.twice = 0;
        world.late = 0;
        world.run(CALM_MILLIS);

        List<Integer> keys = hosts.stream().map(World.Host::keysSet).toList();
        List<World.Letter> last = new ArrayList<>();
        for (World.Host from : hosts) {
            for (World.Host to : hosts) {
                if (from != to) {
                    last.add(from.send(to.address));
                }
            }
        }
        last.forEach(letter -> world.runUntilEnd(letter, PATIENCE_MILLIS));
        // One may be undelivered: by that its host learns that the other side has the key no more.
        last.replaceAll(letter -> letter.isDelivered() ? letter : world.host(letter.from).send(letter.to));
        last.forEach(letter -> world.runUntilEnd(letter, PATIENCE_MILLIS));
        int agreements = 0;
        for (int i = 0; i < hosts.size(); i++) {
            agreements = Math.max(agreements, (hosts.get(i).keysSet() - keys.get(i)) / (hosts.size() - 1));
        }
        letters.addAll(last);
        boolean killed = world.faults.keySet().stream().anyMatch(fault -> fault.startsWith("KILL"));
        List<World.Letter> whole = killed ? List.of() : letters;
        return new Tally(seed, world.wrong, whole.stream().filter(l -> l.isDelivered() && !l.isReceived()).count(),
                whole.stream().filter(l -> l.end.isEmpty()).count(),
                agreements, last.stream().filter(l -> !l.isDelivered()).count(),
                last.stream().mapToLong(l -> l.endedAt - l.at).max().orElse(0),
                letters.stream().filter(World.Letter::isDelivered).count() / (double) letters.size(), world.faults);
    }
}
