package keyagreement;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import javino.JavinoException;
import simulation.Network;

/** Two or three hosts that meet, with whatever goes wrong, and then quiet air, in which all must be in order again. */
public final class RandomRuns {

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

    private RandomRuns() {
    }

    /** Runs with the seeds from the first on. @param folder where an authority certifies the hosts. */
    public static List<Tally> run(long first, int runs, Path folder) throws IOException, JavinoException {
        TestAuthority authority = new TestAuthority(folder);
        List<Identity> identities =
                List.of(authority.certified("ROMA"), authority.certified("SUPO"), authority.certified("SUBB"));
        List<Tally> all = new ArrayList<>();
        for (long seed = first; seed < first + runs; seed++) {
            all.add(run(seed, identities));
        }
        return all;
    }

    private static Tally run(long seed, List<Identity> identities) {
        Simulation simulation = new Simulation(seed);
        Random random = simulation.random;
        List<CertifiedHost> hosts = new ArrayList<>();
        for (int i = 0, count = 2 + random.nextInt(2); i < count; i++) {
            hosts.add(simulation.add(identities.get(i)));
        }
        simulation.air.errors = ERRORS[random.nextInt(ERRORS.length)];
        simulation.twice = random.nextInt(3) * 0.2;
        simulation.late = random.nextInt(3) * 0.1;
        List<Letter> letters = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            CertifiedHost from = hosts.get(random.nextInt(hosts.size()));
            CertifiedHost to = hosts.get(random.nextInt(hosts.size()));
            if (from != to) {
                // Often both begin at once.
                long when = random.nextInt(4) * 10_000 + random.nextInt(3) * 200;
                simulation.after(when, () -> letters.add(from.send(to.address)));
            }
        }
        for (int i = random.nextInt(4); i > 0; i--) {
            simulation.after(random.nextInt(40_000), () -> {
                simulation.victim = hosts.get(random.nextInt(hosts.size())).address;
                simulation.fault = Network.Fault.values()[random.nextInt(Network.Fault.values().length)];
                simulation.faultAfter = random.nextInt(12);
            });
        }
        simulation.run(STORM_MILLIS);
        simulation.calm();
        simulation.run(CALM_MILLIS);

        List<Integer> keys = hosts.stream().map(host -> host.keysSet).toList();
        List<Letter> last = new ArrayList<>();
        for (CertifiedHost from : hosts) {
            for (CertifiedHost to : hosts) {
                if (from != to) {
                    last.add(from.send(to.address));
                }
            }
        }
        last.forEach(letter -> simulation.runUntilEnd(letter, PATIENCE_MILLIS));
        // One may be undelivered: by that its host learns that the other side has the key no more.
        last.replaceAll(letter -> letter.isDelivered() ? letter : simulation.host(letter.from).send(letter.to));
        last.forEach(letter -> simulation.runUntilEnd(letter, PATIENCE_MILLIS));
        int agreements = 0;
        for (int i = 0; i < hosts.size(); i++) {
            agreements = Math.max(agreements, (hosts.get(i).keysSet - keys.get(i)) / (hosts.size() - 1));
        }
        letters.addAll(last);
        boolean killed = hosts.stream().anyMatch(host -> host.killedAt >= 0);
        List<Letter> whole = killed ? List.of() : letters;
        return new Tally(seed, simulation.wrong, whole.stream().filter(l -> l.isDelivered() && !l.isReceived()).count(),
                whole.stream().filter(l -> l.end.isEmpty()).count(),
                agreements, last.stream().filter(l -> !l.isDelivered()).count(),
                last.stream().mapToLong(l -> l.endedAt - l.at).max().orElse(0),
                letters.stream().filter(Letter::isDelivered).count() / (double) letters.size(),
                simulation.faults);
    }
}
