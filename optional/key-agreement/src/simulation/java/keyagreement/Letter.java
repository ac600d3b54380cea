package keyagreement;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import javino.protocol.Address;

/** A message of an agent, and what became of it. */
final class Letter {

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
