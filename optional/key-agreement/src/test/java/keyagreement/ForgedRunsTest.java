package keyagreement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import javino.JavinoException;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** An attacker on the air forges what proves nothing: devices agree all the same, and each message has an end. */
class ForgedRunsTest {

    private static final long MINUTE = 60_000;
    private static final long STORM_MILLIS = 3 * MINUTE;
    private static final List<String> FORGED = List.of("MESSAGE_1", "MESSAGE_2", "MESSAGE_3", "RENEWAL_1", "RENEWAL_2",
            "RENEWAL_3", "WANT", "GROUP", "OTHERS", "SEALED");
    private static final double[] SHARES = {0.04, 0.1, 0.3, 0.9};
    /** Outcomes between devices with certificates, whatever an attacker says. */
    private static final Set<Ending> ENDINGS =
            Set.of(Ending.DELIVERED, Ending.UNDELIVERED, Ending.NO_ANSWER, Ending.NOT_SENT);

    @TempDir
    static Path folder;
    private static List<Identity> identities;

    private Simulation simulation;
    private CertifiedHost roma;
    private CertifiedHost supo;

    @BeforeAll
    static void certify() throws IOException, JavinoException {
        TestAuthority authority = new TestAuthority(folder);
        identities = List.of(authority.certified("ROMA"), authority.certified("SUPO"), authority.certified("SUBB"));
    }

    private void start(long seed) {
        simulation = new Simulation(seed);
        roma = simulation.add(identities.get(0));
        supo = simulation.add(identities.get(1));
    }

    private Forger forger() {
        return new Forger(simulation, identities.get(2), List.of(roma.address, supo.address));
    }

    /** The attacker's messages in each device's name to the other, and the share of the air that he takes for them. */
    static Stream<Arguments> attacks() {
        return Stream.of("MESSAGE_1", "MESSAGE_2", "MESSAGE_3", "RENEWAL_1", "RENEWAL_2", "WANT", "OTHERS", "SEALED",
                "MESSAGE_1 MESSAGE_2", "MESSAGE_1 SEALED", "SEALED WANT RENEWAL_1 MESSAGE_3 MESSAGE_1")
                .flatMap(kinds -> Stream.of(0.04, 0.1, 0.2).map(share -> Arguments.of(kinds, share)));
    }

    @ParameterizedTest
    @MethodSource("attacks")
    void send_whileRunsAreForged_isDelivered(String kinds, double share) {
        forge(kinds, share, 0, 4);
    }

    @ParameterizedTest
    @MethodSource("attacks")
    @Tag("soak")
    void send_whileMoreRunsAreForged_isDelivered(String kinds, double share) {
        forge(kinds, share, 2, 100);
    }

    /** With a fifth of the air forged, one pair of 25 may need longer than three messages; with less, none. */
    private void forge(String kinds, double share, int from, int to) {
        List<String> late = new ArrayList<>();
        for (int seed = from; seed < to; seed++) {
            start(seed);
            forger().send(kinds.split(" "), share, 4 * MINUTE);
            simulation.run(simulation.random.nextInt((int) MINUTE / 2));
            late.addAll(late("seed " + seed, roma, supo));
        }
        assertTrue(late.size() <= (share > SHARES[1] ? (to - from) / 25 : 0), late::toString);
    }

    private void assertArrives(String what, CertifiedHost one, CertifiedHost other) {
        assertEquals(List.of(), late(what, one, other));
    }

    /**
     * Both say something at once. If that is not delivered, it has an end in time, and one of the next two is.
     *
     * @return the pairs of which none was.
     */
    private List<String> late(String what, CertifiedHost one, CertifiedHost other) {
        List<String> late = new ArrayList<>();
        for (Simulation.Letter letter : List.of(one.send(other.address), other.send(one.address))) {
            Simulation.Letter last = letter;
            List<String> ends = new ArrayList<>();
            for (int more = 2; !isDelivered(what, last, ends) && more > 0; more--) {
                last = simulation.host(letter.from).send(letter.to);
            }
            if (!last.isDelivered()) {
                late.add(what + ", " + letter.from + ": " + ends);
            }
        }
        assertEquals(List.of(), simulation.wrong);
        return late;
    }

    private boolean isDelivered(String what, Simulation.Letter letter, List<String> ends) {
        simulation.runUntilEnd(letter, 2 * MINUTE);
        assertInTime(what, letter);
        ends.add(letter.end.toString());
        return letter.isDelivered();
    }

    private static void assertInTime(String what, Simulation.Letter letter) {
        assertTrue(letter.end.isPresent() && letter.endedAt - letter.at <= MessageQueue.MOST_MILLIS, () -> what + ": "
                + letter.from + " learned " + letter.end + " after " + (letter.endedAt - letter.at));
    }

    /** Attackers, damage, copies, kills, resets, boards that say nothing, and agents that never stop to send. */
    private void storm(long seed) {
        start(seed);
        simulation.add(identities.get(2));
        List<CertifiedHost> hosts = List.copyOf(simulation.hosts.values());
        simulation.air.errors = simulation.random.nextInt(3) * 1e-3;
        simulation.twice = simulation.random.nextInt(3) * 0.2;
        simulation.late = simulation.random.nextInt(3) * 0.1;
        List<String> kinds = new ArrayList<>(FORGED);
        Collections.shuffle(kinds, simulation.random);
        forger().send(kinds.subList(0, 1 + simulation.random.nextInt(3)).toArray(String[]::new),
                SHARES[simulation.random
                        .nextInt(SHARES.length)],
                STORM_MILLIS);
        List<Simulation.Letter> letters = new ArrayList<>();
        int period = 500 + simulation.random.nextInt(8000);
        for (long at = 0; at < STORM_MILLIS; at += simulation.random.nextInt(2 * period)) {
            simulation.after(at, () -> {
                CertifiedHost from = hosts.get(simulation.random.nextInt(hosts.size()));
                CertifiedHost to = hosts.get(simulation.random.nextInt(hosts.size()));
                if (from != to && from.on) {
                    letters.add(from.send(to.address));
                }
            });
        }
        for (int i = simulation.random.nextInt(5); i > 0; i--) {
            simulation.after(simulation.random.nextLong(STORM_MILLIS), () -> {
                CertifiedHost victim = hosts.get(simulation.random.nextInt(hosts.size()));
                switch (simulation.random.nextInt(3)) {
                    case 0 -> victim.crash();
                    case 1 -> victim.board.reset();
                    default -> victim.board.lose();
                }
            });
        }
        simulation.run(STORM_MILLIS + MessageQueue.MOST_MILLIS);
        letters.removeIf(letter -> letter.isRefused || simulation.host(letter.from).killedAt >= letter.at);
        for (Simulation.Letter letter : letters) {
            assertInTime("seed " + seed, letter);
            assertTrue(ENDINGS.contains(letter.end.orElseThrow()), () -> "seed " + seed + ": " + letter.end);
        }
        assertEquals(List.of(), simulation.wrong, () -> "seed " + seed);
    }

    @Test
    void send_whateverHappens_endsWithinAMinute() {
        LongStream.range(0, 6).forEach(this::storm);
    }

    @Test
    @Tag("soak")
    void send_whateverElseHappens_endsWithinAMinute() {
        LongStream.range(6, 300).forEach(this::storm);
    }
}
