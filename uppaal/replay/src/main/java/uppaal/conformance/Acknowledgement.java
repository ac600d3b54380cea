package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javino.protocol.Bytes;
import javino.protocol.Payload;

/** The bytes of an acknowledgement (SPEC 7.3). */
record Acknowledgement(Payload payload, String kind) {
    static final String DELIVERED = "delivered";
    static final String FRAGMENTS = "fragments";
    static final String STALE = "stale";
    /** By the length of the message. */
    private static final Map<Integer, String> KINDS = Map.of(8, DELIVERED, 9, FRAGMENTS, 16, STALE);
    private static final Map<String, Integer> TYPES = Map.of(DELIVERED, 6, FRAGMENTS, 7, STALE, 8);
    private static final double UNIT = 0.1;
    private static final int MOST_UNITS = 0xFFFF;
    private static final int LOW_BYTE = 0xFF;

    static Optional<Acknowledgement> of(Payload payload) {
        return Optional.ofNullable(KINDS.get(payload.message().length()))
                .map(kind -> new Acknowledgement(payload, kind));
    }

    boolean is(String wanted) {
        return kind.equals(wanted);
    }

    /** Whether it may be about a frame to its origin; what is stale may also be for its group. */
    boolean mayMean(Frame frame) {
        boolean isForGroup = is(STALE) && !frame.isUnicast()
                && payload.origin().startsWith(frame.destination.substring(2));
        return frame.whole.hasNonce() && frame.whole.lastBits() == payload.answered()
                && (isForGroup || frame.destination.equals(payload.origin()));
    }

    /** Without keys it is believed. */
    boolean isProved(Frame frame, Keys keys) {
        return !keys.areKnown() || isProof(frame, keys, 0) || asksParity(frame, keys);
    }

    boolean asksParity(Frame frame, Keys keys) {
        return isProof(frame, keys, SharedKey.ASKS_PARITY);
    }

    private boolean isProof(Frame frame, Keys keys, int parity) {
        Bytes message = payload.message();
        int end = message.length() - Payload.TAG_LENGTH;
        return keys.of(frame).anyMatch(key -> message.from(end).equals(key.proof(TYPES.get(kind) | parity,
                frame.nonce, frame.origin + payload.origin(), message.slice(0, end))));
    }

    /** {@code delivered}, …, and of fragments also which. */
    String answer() {
        return is(FRAGMENTS) ? FRAGMENTS + payload.message().at(0) : kind;
    }

    /** Refuses an acknowledgement of a board of ours that says what is not so. */
    void check(BoardFrames board, double now, List<Frame> proved) throws RefusedException {
        if (is(FRAGMENTS)) {
            checkFragments(board, proved);
        } else if (is(STALE)) {
            checkStale(board, now, proved);
        }
    }

    /** Some fragments that have come, with the first. All would be delivered, unless their tag was wrong. */
    private void checkFragments(BoardFrames board, List<Frame> proved) throws RefusedException {
        int told = payload.message().at(0);
        Frame last = proved.get(proved.size() - 1);
        require(proved.stream().anyMatch(frame -> frame.mayHaveReached(board.name, told)
                && (board.isRefused || !frame.isAll(told))),
                String.format("%s answers that it has the fragments %02x of %s", board.name, told, last),
                String.format("%02x or fewer, with the first, and not all", last.reached.getOrDefault(board.name, 0)));
    }

    /** A floor is not below what is stale. How far above it may be, and which it is, tells the memory. */
    private void checkStale(BoardFrames board, double now, List<Frame> proved) throws RefusedException {
        long floor = payload.message().number(0, Payload.NONCE_LENGTH);
        require(proved.stream().anyMatch(frame -> floor >= frame.nonceNumber()), String.format(
                "%s tells the floor %012x for %s", board.name, floor, proved.get(proved.size() - 1)),
                "at least that nonce");
        double most = (now - board.resetAt) / board.second + UNIT;
        double least = Math.min((now - board.runsSince) / board.second, MOST_UNITS * UNIT) - UNIT;
        require(uptime() <= most && uptime() >= least, String.format(Locale.ROOT,
                "%s says that it has been up for %.1f s", board.name, uptime()),
                String.format(Locale.ROOT, "%.1f to %.1f s", least, most));
    }

    /** The uptime of its board that a stale one tells, in seconds. */
    double uptime() {
        return UNIT * payload.message().number(Payload.NONCE_LENGTH, Payload.NONCE_LENGTH + 2);
    }

    @Override
    public String toString() {
        return described(kind, payload.answered() & LOW_BYTE);
    }

    /** As the board that owes it tells it, by the nonce's last byte. */
    static String described(String kind, int nonce) {
        return String.format("%s of a nonce that ends in %02x", kind, nonce);
    }
}
