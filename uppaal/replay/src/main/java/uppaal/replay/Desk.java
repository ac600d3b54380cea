package uppaal.replay;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javino.protocol.Payload;

/** What is known of a board: what its host wants to be sent, what it has sealed and cut, which pieces it may have. */
final class Desk {
    private static final int IDS = 64;
    private static final int COUNTER_BITS = 24;
    /** An epoch of which no nonce is given. */
    private static final long NONE_LEFT = 0xFFFFFF;
    /** In the place of an epoch: the board has keys and none. */
    private static final long LOST = 0;

    /** What its host wants to be sent. */
    static final class Asked {
        final int number;
        final String destination;
        final byte[] content;
        /** What was sent of it last. */
        Frame frame;
        boolean isAnew;

        Asked(int number, String destination, byte[] content) {
            this.number = number;
            this.destination = destination;
            this.content = content;
        }
    }

    final String name;
    final Set<String> ids = new LinkedHashSet<>();
    final Map<Integer, Frame> cut = new HashMap<>();
    /** When pieces have come last, in seconds, by origin, id and index. */
    final Map<String, Double> pieces = new Recent<>();
    Frame lastBroadcast;
    double resetAt;
    /** When it said hello since then; negative where it has not. */
    double greetedAt = -1;
    /** What it has told last of its uptime since then, as a notice has it. */
    int uptime;
    private final List<Asked> waiting = new ArrayList<>();
    private final Map<String, Asked> current = new HashMap<>();
    private long highest = -1;
    private long epoch = -1;
    /** As its host knows it since the last reset; negative where that does not. */
    private long told = -1;
    private long leastEpoch = 1;
    private int lastId = -1;
    private boolean wasStale;

    /** Of its radio, in bytes. */
    int pieceLength = Payload.PART_LENGTH;

    Desk(String name) {
        this.name = name;
    }

    /** @param name of its serial module; empty where it has none */
    void useRadio(String name) {
        pieceLength = name.equals("e32") ? Payload.E32_PART_LENGTH : Payload.PART_LENGTH;
    }

    /** It begins anew, with another epoch. */
    void reset(double seconds) {
        leastEpoch = epoch < 0 || epoch == NONE_LEFT ? leastEpoch : epoch + 1;
        resetAt = seconds;
        greetedAt = -1;
        uptime = 0;
        told = -1;
        lastId = -1;
        lastBroadcast = null;
        waiting.clear();
        current.clear();
        cut.clear();
        pieces.clear();
        wasStale = false;
    }

    void ask(Asked asked) {
        waiting.add(asked);
    }

    /** It has told what became of this; if it has not sent it, it will not. */
    void end(int number) {
        waiting.removeIf(asked -> asked.number == number);
    }

    /** What a new frame to this destination may be of: the message that has to be sealed anew, or those that wait. */
    List<Asked> askedFor(String destination) {
        List<Asked> able = new ArrayList<>();
        Asked last = current.get(destination);
        if (last != null && !last.isAnew && last.frame.isStale) {
            able.add(last);
        }
        waiting.stream().filter(asked -> asked.destination.equals(destination)).forEach(able::add);
        return able;
    }

    /** This is sent. Those to the same destination that have waited for longer could not be sealed. */
    void take(Asked asked, Frame frame) {
        asked.isAnew = asked.frame != null;
        asked.frame = frame;
        int at = waiting.indexOf(asked);
        for (int i = at; i >= 0; i--) {
            if (waiting.get(i).destination.equals(asked.destination)) {
                waiting.remove(i);
            }
        }
        current.put(asked.destination, asked);
        if (frame.fragmentId >= 0) {
            lastId = frame.fragmentId;
            cut.put(frame.fragmentId, frame);
        }
    }

    /**
     * What it has sent there last, if a notice may have come that something is stale: without keys nobody can tell
     * which message that was about, nor which of them was sealed anew. Else null.
     */
    Frame lastTo(String destination) {
        return wasStale && current.containsKey(destination) ? current.get(destination).frame : null;
    }

    /** One of its frames is known to be stale. It seals that anew, and then perhaps sends others before. */
    void goOnAbove(Frame frame) {
        frame.isStale = true;
        wasStale = true;
    }

    /** Its host knows its epoch: another one after each boot; or that it has lost it, and then it seals nothing. */
    void told(long now) throws RefusedException {
        boolean maybeLost = told < 0 || told == LOST;
        if (now != LOST || !maybeLost) {
            checkEpoch(now, "says that it has");
        }
        told = now;
    }

    private void checkEpoch(long now, String what) throws RefusedException {
        if (now < leastEpoch) {
            throw new RefusedException(String.format("%s %s epoch %06x; expected %06x or a later one, since %s", name,
                    what, now, leastEpoch, leastEpoch > epoch ? "it was reset" : "it has had that"));
        }
        epoch = now;
        leastEpoch = now;
    }

    /** A new frame has the next nonce of this board, whatever its destination; one that is sealed anew a later one. */
    void checkNonce(Frame frame, Frame before) throws RefusedException {
        long least = before == null ? highest : before.nonceNumber();
        long nonce = frame.nonceNumber();
        if (nonce <= least) {
            throw new RefusedException(String.format("%s seals a message to %s under nonce %012x; expected one above "
                    + "%012x, which it has used", name, frame.destination, nonce, least));
        }
        checkEpoch(nonce >> COUNTER_BITS, "seals under");
        if (told >= 0 && nonce >> COUNTER_BITS != told) {
            throw new RefusedException(
                    String.format("%s seals under epoch %06x; expected %06x, as it has told its host",
                            name, nonce >> COUNTER_BITS, told));
        }
        highest = Math.max(highest, nonce);
    }

    /** Each frame that is cut has the next id. */
    void checkId(Frame frame) throws RefusedException {
        if (lastId >= 0 && !wasStale && frame.fragmentId != (lastId + 1) % IDS) {
            throw new RefusedException(name + " cuts a frame into fragments with id " + frame.fragmentId + "; expected "
                    + (lastId + 1) % IDS);
        }
    }
}
