package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javino.protocol.Payload;

/** The bytes of an acknowledgement (SPEC 7.3). */
record Acknowledgement(Payload payload, String kind) {
    static final String DELIVERED = "delivered";
    static final String FRAGMENTS = "fragments";
    static final String STALE = "stale";
    /** By the length of the message. */
    private static final Map<Integer, String> KINDS = Map.of(8, DELIVERED, 9, FRAGMENTS, 16, STALE);
    private static final int UNITS_A_SECOND = 10;
    private static final int MOST_UNITS = 0xFFFF;
    private static final Map<String, Integer> TYPES = Map.of(DELIVERED, 6, FRAGMENTS, 7, STALE, 8);

    static Optional<String> kind(Payload payload) {
        return Optional.ofNullable(KINDS.get(payload.message().length()));
    }

    static Optional<Acknowledgement> of(Payload payload) {
        return kind(payload).map(kind -> new Acknowledgement(payload, kind));
    }

    boolean is(String wanted) {
        return kind.equals(wanted);
    }

    /** Whether it may be about a frame. */
    boolean mayMean(Frame frame) {
        return frame.mayBeMeant(payload, tellsFloor());
    }

    boolean isProved(Frame frame, List<SharedKey> keys) {
        return isProof(frame, keys, 0) || asksParity(frame, keys);
    }

    boolean asksParity(Frame frame, List<SharedKey> keys) {
        return isProof(frame, keys, SharedKey.ASKS_PARITY);
    }

    private boolean isProof(Frame frame, List<SharedKey> keys, int parity) {
        return keys.stream().anyMatch(key -> key.isProof(TYPES.get(kind) | parity, frame.nonceBytes(),
                frame.origin + payload.origin(), payload.message().toArray()));
    }

    /** Bit k for fragment k. */
    int fragments() {
        return payload.message().at(0);
    }

    long floor() {
        return payload.message().number(0, Payload.NONCE_LENGTH);
    }

    boolean tellsFloor() {
        return is(STALE);
    }

    /** In tenths of a second. */
    int uptime() {
        return (int) payload.message().number(Payload.NONCE_LENGTH, Payload.NONCE_LENGTH + 2);
    }

    /** As {@link Frame#answers} has it. */
    String answer() {
        return is(FRAGMENTS) ? FRAGMENTS + fragments() : kind;
    }

    /** A floor is not below what is stale. How far above it may be, and which it is, tells the memory. */
    void checkStale(BoardFrames board, double now, List<Frame> meant) throws RefusedException {
        require(meant.stream().anyMatch(frame -> floor() >= frame.nonceNumber()), String.format(
                "%s tells the floor %012x for %s", board.name, floor(), meant.get(meant.size() - 1)),
                "at least that nonce");
        double most = UNITS_A_SECOND * (now - board.resetAt) / board.second + 1;
        double since = board.runsSince < 0 ? 0
                : UNITS_A_SECOND * (now - board.runsSince) / board.second - 1;
        double least = Math.max(board.uptime, Math.min(since, MOST_UNITS));
        require(uptime() <= most && uptime() >= least, String.format(Locale.ROOT,
                "%s says that it has been up for %.1f s", board.name, uptime() / (double) UNITS_A_SECOND),
                String.format(Locale.ROOT, "%.1f to %.1f s", least / UNITS_A_SECOND, most / UNITS_A_SECOND));
        board.uptime = uptime();
    }
}
