package diffuser.board;

import java.util.Collection;
import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;

import diffuser.gate.Cast;
import diffuser.gate.Gate;
import diffuser.gate.Policy;
import diffuser.gate.Provenance;
import diffuser.gate.TrustLevel;

import javino.protocol.Address;
import javino.protocol.HostMessage;

/**
 * Hands messages of other hosts to the libraries that they are for, if {@link Policy} lets them come by that cast and
 * under that key. For any thread.
 */
public final class HostMessages {

    private final Map<HostMessage.Use, HostService> services = new EnumMap<>(HostMessage.Use.class);
    private final Consumer<String> warn;
    private final AtomicLong refused = new AtomicLong();

    /**
     * @param services no two for one use.
     * @param warn     is told why a message was dropped.
     */
    public HostMessages(Collection<? extends HostService> services, Consumer<String> warn) {
        this.warn = warn;
        services.forEach(service -> service.uses().forEach(use -> this.services.put(use, service)));
    }

    /**
     * Takes a message, or drops and counts it.
     *
     * @param to   this device, or all.
     * @param peer the trust level of the sender; of a broadcast, that of the device in whose name it came.
     */
    public void receive(Address from, Address to, TrustLevel peer, HostMessage message) {
        try {
            HostMessage.Use use = message.kind().use();
            Gate.permit(Policy.Act.of(use), Provenance.of(from, Cast.of(to), peer));
            if (!services.containsKey(use)) {
                throw new Gate.RefusedException("the library for it is not there");
            }
            services.get(use).received(from, message);
        } catch (Gate.RefusedException e) {
            refused.incrementAndGet();
            // Broadcasts, which anybody can send in any name, are only counted.
            if (Cast.of(to) != Cast.BROADCAST) {
                warn.accept("dropped a " + message + " from " + from + ": " + e.getMessage());
            }
        }
    }

    /** How many messages were dropped. */
    public long refused() {
        return refused.get();
    }
}
