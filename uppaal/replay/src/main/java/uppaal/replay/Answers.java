package uppaal.replay;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import javino.protocol.Payload;

/** The bytes of acknowledgements (SPEC 7.3). */
final class Answers {
    static final int DELIVERED = 8;
    static final int PIECES = 9;
    static final int STALE = 16;
    /** The proof's type for each length of the message. */
    private static final Map<Integer, Integer> TYPES = Map.of(DELIVERED, 6, PIECES, 7, STALE, 8);
    /** How much older than a frame its pieces may be, in seconds: a forged one waits 5 s for new ones. */
    private static final double KEPT = 6;
    /** How far a floor is above what it was written for. */
    private static final int MOST_ABOVE = 31;
    private static final int UNITS_A_SECOND = 10;
    private static final int MOST_UNITS = 0xFFFF;
    /** How much a board's clock may be fast or slow; a boot may take some more. */
    private static final double DRIFT = 0.1;

    private Answers() {
    }

    /** What stands for a piece at a receiver. */
    static String place(String origin, int id, int index) {
        return origin + id + "/" + index;
    }

    /** Whether an acknowledgement may answer a frame. */
    static boolean mayMean(Payload payload, Frame frame) {
        return frame.isSealed() && (frame.isUnicast() || payload.message().length() == STALE)
                && Frame.lastBits(frame.nonceHex) == payload.answered()
                && Frame.concerns(frame.destination, payload.origin());
    }

    static boolean isProof(SharedKey key, Payload payload, Frame frame) {
        Integer type = TYPES.get(payload.message().length());
        return type != null
                && key.isProof(type, frame.nonce(), frame.origin, payload.origin(), payload.message().toArray());
    }

    static boolean asksParity(SharedKey key, Payload payload, Frame frame) {
        return key.asksParity(TYPES.get(payload.message().length()), frame.nonce(), frame.origin, payload.origin(),
                payload.message().toArray());
    }

    /**
     * @param meant the frames with such last bits in their nonces
     * @param proved those that are proved, or without keys all
     */
    static void check(Desk desk, Payload payload, double now, List<Frame> meant, List<Frame> proved)
            throws RefusedException {
        if (!TYPES.containsKey(payload.message().length())) {
            throw new RefusedException(desk.name + " acknowledges with " + payload.message().length()
                    + " bytes; expected 8, 9 or 16");
        }
        if (meant.isEmpty()) {
            throw new RefusedException(desk.name + " acknowledges a nonce that ends in "
                    + String.format("%03x", payload.answered()) + "; expected that of a message to it");
        }
        if (proved.isEmpty()) {
            throw new RefusedException(desk.name + " acknowledges with a wrong proof; expected that of "
                    + meant.get(meant.size() - 1));
        }
        if (payload.message().length() == PIECES) {
            checkPieces(desk, payload, proved);
        } else if (payload.message().length() == STALE) {
            checkUptime(desk, payload, now);
        }
    }

    private static void checkPieces(Desk desk, Payload payload, List<Frame> proved) throws RefusedException {
        int told = payload.message().at(0);
        int possible = 0;
        for (Frame frame : proved) {
            int come = come(desk, frame);
            boolean wasWhole = come == (1 << frame.pieces()) - 1;
            if (frame.fragmentId >= 0 && (told & ~come) == 0 && ((told & 1) != 0 || wasWhole)) {
                return;
            }
            possible |= come;
        }
        throw new RefusedException(
                String.format("%s answers that it has the fragments %02x of %s; expected %02x or fewer, "
                        + "with the first", desk.name, told, proved.get(proved.size() - 1), possible));
    }

    /** The pieces of a frame that have come to a board, so that it may have them. */
    private static int come(Desk desk, Frame frame) {
        int come = 0;
        for (int index = 0; index < frame.pieces(); index++) {
            Double last = desk.pieces.get(place(frame.origin, frame.fragmentId, index));
            come |= last != null && last >= frame.begun - KEPT ? 1 << index : 0;
        }
        return come;
    }

    private static void checkUptime(Desk desk, Payload payload, double now) throws RefusedException {
        int told = (int) payload.message().number(Payload.NONCE_LENGTH, Payload.NONCE_LENGTH + 2);
        double most = UNITS_A_SECOND * (1 + (now - desk.resetAt) * (1 + DRIFT));
        double least = desk.greetedAt < 0 ? 0 : UNITS_A_SECOND * ((now - desk.greetedAt) * (1 - DRIFT) - 1);
        if (told > most || told < Math.min(least, MOST_UNITS)) {
            throw new RefusedException(String.format("%s says that it has been up for %.1f s; expected %.1f to %.1f s",
                    desk.name, told / (double) UNITS_A_SECOND, Math.max(0, least) / UNITS_A_SECOND,
                    most / UNITS_A_SECOND));
        }
        if (told < desk.uptime) {
            throw new RefusedException(String.format("%s says that it has been up for %.1f s; expected no less than "
                    + "the %.1f s of before", desk.name, told / (double) UNITS_A_SECOND,
                    desk.uptime / (double) UNITS_A_SECOND));
        }
        desk.uptime = told;
    }

    /** A floor is not below what is stale, and at most 31 above what the board can have had of this origin and key. */
    static void checkFloor(Desk desk, Payload payload, List<Frame> proved, Collection<Frame> ours)
            throws RefusedException {
        long floor = payload.message().number(0, Payload.NONCE_LENGTH);
        for (Frame frame : proved) {
            long highest = ours.stream().filter(each -> each.isSealed() && each.origin.equals(frame.origin)
                    && each.destination.equals(frame.destination)).mapToLong(Frame::nonceNumber).max()
                    .orElse(Long.MAX_VALUE - MOST_ABOVE);
            if (floor >= frame.nonceNumber() && floor <= highest + MOST_ABOVE) {
                return;
            }
        }
        throw new RefusedException(
                String.format("%s tells the floor %012x for %s; expected at least that nonce, and at "
                        + "most 31 more than the highest", desk.name, floor, proved.get(proved.size() - 1)));
    }
}
