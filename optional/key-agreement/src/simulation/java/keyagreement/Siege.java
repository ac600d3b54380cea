package keyagreement;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import javino.JavinoException;
import javino.protocol.Address;
import javino.protocol.Key;
import simulation.Attacker;

/**
 * What came of an attack on hosts that have keys with each other.
 *
 * @param sent      messages of the attacker.
 * @param wrong     what was accepted, or is otherwise not as it must be.
 * @param lost      hosts with other keys than before.
 * @param keysSet   keys that boards were given.
 * @param eeprom    writes to EEPROM.
 * @param delivered whether a message afterwards needed no further key, and came.
 */
public record Siege(int sent, List<String> wrong, long lost, int keysSet, int eeprom, boolean delivered) {

    private static final long PATIENCE_MILLIS = 60_000;
    /** As many packets as the air takes. */
    private static final long EVERY_MILLIS = 300;

    /** Lays siege to two hosts that have agreed on a key by certificates, and once more by a renewal. */
    public static Siege of(long seed, int messages, Path folder) throws IOException, JavinoException {
        TestAuthority authority = new TestAuthority(folder);
        Simulation simulation = new Simulation(seed);
        CertifiedHost roma = simulation.add(authority.certified("ROMA"));
        CertifiedHost supo = simulation.add(authority.certified("SUPO"));
        Attacker attacker = new Attacker(simulation.random, List.of(roma.address, supo.address), simulation.voice());
        simulation.listener = packet -> attacker.hear(packet.from, packet.message);
        simulation.runUntilEnd(roma.send(supo.address), PATIENCE_MILLIS);
        simulation.run(PATIENCE_MILLIS);
        roma.board.reset();
        simulation.run(PATIENCE_MILLIS);
        simulation.runUntilEnd(roma.send(supo.address), PATIENCE_MILLIS);
        simulation.run(PATIENCE_MILLIS);
        List<CertifiedHost> hosts = List.of(roma, supo);
        List<Map<Address, Key>> keys = hosts.stream().map(host -> Map.copyOf(host.board.keys)).toList();
        int before = roma.keysSet + supo.keysSet;
        for (int i = 0; i < messages; i++) {
            attacker.act();
            simulation.run(EVERY_MILLIS);
        }
        long lost = IntStream.range(0, hosts.size())
                .filter(i -> keys.get(i).isEmpty() || !keys.get(i).equals(hosts.get(i).board.keys)).count();
        Letter after = roma.send(supo.address);
        simulation.runUntilEnd(after, PATIENCE_MILLIS);
        return new Siege(messages, simulation.wrong, lost, roma.keysSet + supo.keysSet - before,
                roma.board.eepromWrites + supo.board.eepromWrites, after.isDelivered());
    }
}
