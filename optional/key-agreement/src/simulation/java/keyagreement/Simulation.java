package keyagreement;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javino.protocol.Address;
import simulation.Network;

/** Hosts with certificates, whose agents say something. */
final class Simulation extends Network<CertifiedHost> {

    /** A message of an agent, and what became of it. */
    static final class Letter {

        final Address from;
        final Address to;
        final long at;
        final Set<String> receivedBy = new HashSet<>();
        Optional<Ending> end = Optional.empty();
        long endedAt;
        /** Too many waited; nothing more becomes of it. */
        boolean isRefused;

        Letter(Address from, Address to, long at) {
            this.from = from;
            this.to = to;
            this.at = at;
        }

        boolean isReceived() {
            return !receivedBy.isEmpty();
        }

        boolean isDelivered() {
            return end.filter(Ending.DELIVERED::equals).isPresent();
        }
    }

    private final Map<String, Letter> said = new HashMap<>();

    Simulation(long seed) {
        super(seed);
    }

    CertifiedHost add(Identity identity) {
        CertifiedHost host = new CertifiedHost(this, identity, said);
        hosts.put(host.address, host);
        host.start();
        return host;
    }

    /** Runs until it has ended, or for a time. */
    void runUntilEnd(Letter letter, long millis) {
        long end = millis() + millis;
        while (letter.end.isEmpty() && millis() < end) {
            run(Math.min(10, end - millis()));
        }
    }
}
