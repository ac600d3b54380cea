package keyagreement;

import java.util.Collection;
import simulation.Network;

/** Hosts with certificates, whose agents say something. */
final class Simulation extends Network<CertifiedHost> {

    Simulation(long seed) {
        super(seed);
    }

    CertifiedHost add(Identity identity) {
        CertifiedHost host = new CertifiedHost(this, identity);
        hosts.put(host.address, host);
        host.start();
        return host;
    }

    Collection<CertifiedHost> hosts() {
        return hosts.values();
    }

    /** Runs until it has ended, or for a time. */
    void runUntilEnd(Letter letter, long millis) {
        long end = millis() + millis;
        while (letter.end.isEmpty() && millis() < end) {
            run(Math.min(10, end - millis()));
        }
    }
}
