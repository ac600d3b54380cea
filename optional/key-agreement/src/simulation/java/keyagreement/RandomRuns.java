package keyagreement;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import javino.protocol.Address;
import javino.protocol.Key;
import simulation.Attacker;
import simulation.Network;

/** Two or three hosts that meet, with whatever goes wrong, and then quiet air, in which all must be in order again. */
public final class RandomRuns {

    private static final long STORM_MILLIS = 60_000;
    private static final long CALM_MILLIS = 30_000;
    private static final long PATIENCE_MILLIS = 90_000;
    private static final long MINUTE = 60_000;
    /** As many packets of an attacker as the air takes. */
    private static final long EVERY_MILLIS = 300;
    private static final double[] ERRORS = {0, 1e-4, 1e-3, 2e-3};

    /**
     * The results of a run.
     *
     * @param wrong      violations: contents accepted from the wrong device or twice, keys set twice.
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

    /**
     * The results of an attack on hosts that have keys with each other.
     *
     * @param wrong     violations, such as a forged content that was accepted.
     * @param lost      hosts with other keys than before.
     * @param delivered whether a message afterwards needed no further key, and came.
     */
    public record Siege(int sent, List<String> wrong, long lost, int keysSet, int eeprom, boolean delivered) {
    }

    private RandomRuns() {
    }

    /** Runs with the seeds from the first on. @param folder the folder of the authority that certifies the hosts. */
    public static List<Tally> run(long first, int runs, Path folder) {
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
        List<Simulation.Letter> letters = new ArrayList<>();
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
        List<Simulation.Letter> last = new ArrayList<>();
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
        List<Simulation.Letter> whole = killed ? List.of() : letters;
        return new Tally(seed, simulation.wrong, whole.stream().filter(l -> l.isDelivered() && !l.isReceived()).count(),
                whole.stream().filter(l -> l.end.isEmpty()).count(),
                agreements, last.stream().filter(l -> !l.isDelivered()).count(),
                last.stream().mapToLong(l -> l.endedAt - l.at).max().orElse(0),
                letters.stream().filter(Simulation.Letter::isDelivered).count() / (double) letters.size(),
                simulation.faults);
    }

    /** Lays siege to two hosts that have agreed on a key by certificates, and once more by a renewal. */
    public static Siege siege(long seed, int messages, Path folder) {
        TestAuthority authority = new TestAuthority(folder);
        Simulation simulation = new Simulation(seed);
        CertifiedHost roma = simulation.add(authority.certified("ROMA"));
        CertifiedHost supo = simulation.add(authority.certified("SUPO"));
        Attacker attacker = simulation.attacker(List.of(roma.address, supo.address));
        simulation.runUntilEnd(roma.send(supo.address), MINUTE);
        simulation.run(MINUTE);
        roma.board.reset();
        simulation.run(MINUTE);
        simulation.runUntilEnd(roma.send(supo.address), MINUTE);
        simulation.run(MINUTE);
        List<CertifiedHost> hosts = List.of(roma, supo);
        List<Map<Address, Key>> keys = hosts.stream().map(host -> Map.copyOf(host.board.keys)).toList();
        int before = roma.keysSet + supo.keysSet;
        for (int i = 0; i < messages; i++) {
            attacker.act();
            simulation.run(EVERY_MILLIS);
        }
        long lost = IntStream.range(0, hosts.size())
                .filter(i -> keys.get(i).isEmpty() || !keys.get(i).equals(hosts.get(i).board.keys)).count();
        Simulation.Letter after = roma.send(supo.address);
        simulation.runUntilEnd(after, MINUTE);
        return new Siege(messages, simulation.wrong, lost, roma.keysSet + supo.keysSet - before,
                roma.board.eepromWrites + supo.board.eepromWrites, after.isDelivered());
    }
}
