package keyagreement;

import java.security.SecureRandom;
import java.util.Arrays;
import java.util.List;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;
import keyagreement.edhoc.Initiator;
import simulation.SimulatedChannel;

/** An attacker with a radio in a {@link Simulation}: he says in the name of devices, to others, what proves nothing. */
final class Forger {

    private static final int LONGEST = 100;
    private static final long GAP_MILLIS = 200;

    private final Simulation simulation;
    private final Identity any;
    private final List<Address> names;

    /** @param any an identity whose certificate does not matter, as nobody sees it in a message 1. */
    Forger(Simulation simulation, Identity any, List<Address> names) {
        this.simulation = simulation;
        this.any = any;
        this.names = names;
    }

    /**
     * Says some words of handshakes in all names again and again.
     *
     * @param kinds each that of a host's word; or {@code SEALED} for what its board cannot open, or {@code OTHERS} for
     *              words to somebody else.
     * @param share its share of the air.
     * @param until so long, in ms.
     */
    void send(String[] kinds, double share, long until) {
        double once = names.size() * Arrays.stream(kinds).flatMap(kind -> packets(kind, names.get(0)).stream())
                .mapToDouble(packet -> packet.bits() / SimulatedChannel.BITS_A_MILLI).sum();
        long period = (long) (once / share);
        for (long at = simulation.random.nextLong(period); at < until; at += period) {
            simulation.after(at, () -> {
                // One after the other, as two at once would meet.
                long wait = 0;
                for (String kind : kinds) {
                    for (Address name : names) {
                        for (SimulatedChannel.Packet packet : packets(kind, name)) {
                            simulation.after(wait, () -> simulation.air.send(packet));
                            wait += (long) (packet.bits() / SimulatedChannel.BITS_A_MILLI) + GAP_MILLIS;
                        }
                    }
                }
            });
        }
    }

    /** One word in a device's name to the next one. */
    private List<SimulatedChannel.Packet> packets(String kind, Address name) {
        boolean others = kind.equals("OTHERS");
        Address to = others ? any.certificate().address() : names.get((names.indexOf(name) + 1) % names.size());
        byte[] noise = new byte[LONGEST];
        simulation.random.nextBytes(noise);
        if (kind.equals("SEALED")) {
            return List.of(new SimulatedChannel.Packet(name, to, Bytes.copyOf(noise).slice(0, 16),
                    Simulation.anyKey(simulation.random), 0, null));
        }
        Kind forged = others ? Kind.WANT : Kind.valueOf(kind);
        if (forged == Kind.WANT) {
            // Only messages 1 to 3 are wanted, each of two fragments at most.
            noise[0] = (byte) Kind.values()[simulation.random.nextInt(Kind.RENEWAL_3.ordinal() + 1)].first();
            noise[1] = (byte) simulation.random.nextInt(2);
        }
        // A message 1 proves nothing, so a forged one is like any other.
        Bytes message = forged == Kind.MESSAGE_1
                ? new Initiator(any.with(to), new SecureRandom()).opening()
                : Bytes.copyOf(noise).slice(0, forged.length());
        return HostMessage.fragments(forged, to, message).stream()
                .map(word -> new SimulatedChannel.Packet(name, Address.BROADCAST, word.encode(), null, 0, null))
                .toList();
    }
}
