package campaign;

import harness.TraceEvent;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;
import java.util.TreeMap;

/**
 * Watches the air for nonces that seal two different things. It remembers the highest thousand of each origin; one
 * below all of them counts as a repeat too.
 */
final class Nonces {

    private static final int REMEMBERED = 1024;
    private static final int ORIGIN = 4;
    private static final int MESSAGE = 10;
    private static final int NONCE_LENGTH = 6;
    /** Nonce and tag: no sealed message is shorter. */
    private static final int OVERHEAD = 14;

    private final Map<String, TreeMap<Long, Integer>> seen = new HashMap<>();
    private long sealed;
    private long repeated;

    /** Takes notice of an event of the trace. */
    synchronized void see(TraceEvent event) {
        if (!event.name().equals("rf-tx")) {
            return;
        }
        byte[] payload = HexFormat.of().parseHex(event.text("payload"));
        if (payload.length < MESSAGE) {
            return;
        }
        // The first fragment holds the header and the nonce of the whole; of the others the first tells nothing new.
        if (isFirstFragment(payload)) {
            payload = Arrays.copyOfRange(payload, MESSAGE, payload.length);
        }
        if (payload.length < MESSAGE + OVERHEAD || payload[0] == '+'
                || payload[0] == '/' && payload[2] == '/' && payload[3] == '/') {
            return;
        }
        enter(payload);
    }

    private static boolean isFirstFragment(byte[] payload) {
        return payload[0] == '+' && payload[1] == 'F' && (payload[3] == 'A' || payload[3] == 'I');
    }

    private void enter(byte[] frame) {
        String origin = new String(frame, ORIGIN, ORIGIN, java.nio.charset.StandardCharsets.US_ASCII);
        TreeMap<Long, Integer> nonces = seen.computeIfAbsent(origin, any -> new TreeMap<>());
        long nonce = 0;
        for (int i = 0; i < NONCE_LENGTH; i++) {
            nonce = nonce << 8 | frame[MESSAGE + i] & 0xff;
        }
        boolean forgotten = nonces.size() == REMEMBERED && nonce < nonces.firstKey();
        Integer before = nonces.putIfAbsent(nonce, Arrays.hashCode(frame));
        if (before == null) {
            sealed++;
        }
        if (forgotten || before != null && before != Arrays.hashCode(frame)) {
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
