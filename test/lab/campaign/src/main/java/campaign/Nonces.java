package campaign;

import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import javino.protocol.Bytes;
import javino.protocol.Payload;
import trace.TraceEvent;

/**
 * Watches the air for nonces that seal two different things. It remembers the highest thousand of each origin; one
 * below all of them counts as a repeat too.
 */
final class Nonces {

    private static final int REMEMBERED = 1024;

    private final Map<String, TreeMap<Long, Integer>> seen = new HashMap<>();
    private long sealed;
    private long repeated;

    /** Takes notice of an event of the trace. */
    synchronized void see(TraceEvent event) {
        if (event.is("rf-tx")) {
            // The first fragment holds the header and the nonce of the whole; the first of the others tells no more.
            Payload whole = Payload.of(Bytes.copyOf(event.bytes("payload"))).whole();
            if (whole.hasNonce() && !whole.nonce().isEmpty()) {
                enter(whole);
            }
        }
    }

    private void enter(Payload frame) {
        TreeMap<Long, Integer> nonces = seen.computeIfAbsent(frame.origin(), any -> new TreeMap<>());
        long nonce = Long.parseLong(frame.nonce(), 16);
        boolean forgotten = nonces.size() == REMEMBERED && nonce < nonces.firstKey();
        Integer before = nonces.putIfAbsent(nonce, frame.bytes().hashCode());
        if (before == null) {
            sealed++;
        }
        if (forgotten || before != null && before != frame.bytes().hashCode()) {
            repeated++;
        }
        if (nonces.size() > REMEMBERED) {
            nonces.pollFirstEntry();
        }
    }

    /** How many different nonces were seen. */
    synchronized long sealed() {
        return sealed;
    }

    /** How many packets had a nonce that another message had had. */
    synchronized long repeated() {
        return repeated;
    }
}
