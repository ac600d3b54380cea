package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import javino.protocol.Payload;

/** A board's frames: what its host wants to be sent, and what it has sealed, cut and promised to answer. */
final class BoardFrames {
    private static final int IDS = 64;
    private static final int NO_KEY = 255;
    private static final int LOW_BYTE = 0xFF;
    private static final int MOST_TAKEN = 256;

    /** What its host wants to be sent. */
    static final class Outgoing {
        /** Null until its host was told the number. */
        String destination;
        byte[] content;
        /** Whether the content is another device's frame, to be sent as it is. */
        boolean isRelayed;
        boolean isTakenUp;
        boolean isSealed;
        /** How many epochs were stored before it was sealed, and how much was sealed since. */
        private int boot;
        private int counter;
        /** As its first packet shows it; null until that. */
        Frame frame;

        boolean isOf(Payload relayed) {
            return Arrays.equals(relayed.bytes().toArray(), content);
        }

        /** Of its frame; 0 where that is not known. */
        private int length() {
            return content == null ? 0 : content.length + (isRelayed ? 0
                    : destination.equals(Frame.ALL) ? Frame.HEADER : Frame.CONTENT_AT + Payload.TAG_LENGTH);
        }
    }

    final String name;
    final double second;
    final Set<String> ids = new LinkedHashSet<>();
    /** Key and nonce's last byte of each acknowledgement that it owes, and what that says. */
    private final List<String> owed = new ArrayList<>();
    /** What its radio has taken, and is not yet on the air; null where there is nothing. */
    Point declared;
    boolean declares;
    /** When its program began since the last reset, in seconds; negative until then. */
    double runsSince = -1;
    double resetAt;
    /** What it has told last of its uptime since then. */
    int uptime;
    /** Whether somebody has told a floor, since when nonces may jump. */
    boolean wasStale;
    int fragmentLength = Payload.PART_LENGTH;
    private final Map<Integer, Outgoing> outgoing = new HashMap<>();
    private final List<Outgoing> taken = new ArrayList<>();
    private int boot;
    private int counter;
    /** The last byte of the epoch; negative while none is stored since the last reset. */
    private int stored = -1;
    /** The last epoch that was seen, and in which boot. */
    private long epoch;
    private int epochBoot = -1;

    /** @param second of its clock, in seconds */
    BoardFrames(String name, double second) {
        this.name = name;
        this.second = second;
    }

    void reset(double seconds) {
        resetAt = seconds;
        runsSince = -1;
        uptime = 0;
        stored = -1;
        declared = null;
        wasStale = false;
        owed.clear();
        outgoing.clear();
        taken.clear();
    }

    /** An acknowledgement replaces the one before to the same sender; with a group's key two may owe a floor each. */
    void owe(Point point) {
        String place = place(point.operand("key"), point.operand("nonce"));
        if (!point.is("OWE_STALE")) {
            owed.removeIf(answer -> answer.startsWith(place));
        }
        owed.add(place + point.name().substring("OWE_".length()).toLowerCase(Locale.ROOT));
    }

    private static String place(int key, int nonce) {
        return key + "/" + nonce + " ";
    }

    /** The last one is to be sent twice. */
    void oweTwice() {
        owed.stream().reduce((before, last) -> last).ifPresent(owed::add);
    }

    /** Whether it owed such an acknowledgement, which it sends now. */
    boolean pays(int key, int nonce, String kind) {
        return owed.remove(place(key, nonce) + kind);
    }

    /** What it owes else about this nonce, in words. */
    String owes(int key, int nonce) {
        String place = place(key, nonce);
        return owed.stream().filter(answer -> answer.startsWith(place)).findFirst()
                .map(answer -> "'" + answer.substring(place.length()) + "'")
                .orElse("nothing, as it owes no answer to that");
    }

    /** The message of a number that its host is told now. */
    Outgoing accept(int number) {
        return outgoing.compute(number,
                (key, known) -> known == null || known.destination != null ? new Outgoing() : known);
    }

    boolean isRelayed(Point point) {
        return outgoing.containsKey(point.number()) && outgoing.get(point.number()).isRelayed;
    }

    /** The message of a point, which must have been taken up. */
    Outgoing message(Point point) throws RefusedException {
        Outgoing message = outgoing.get(point.number());
        require(message != null && message.isTakenUp,
                name + " declares " + point.name() + " of message " + point.number(), "TAKE_UP first");
        return message;
    }

    void storeEpoch(int lastByte) {
        boot++;
        counter = 0;
        stored = lastByte;
    }

    /** A message is taken up, or sealed anew. */
    void seal(Point point) throws RefusedException {
        Outgoing before = outgoing.getOrDefault(point.number(), new Outgoing());
        Outgoing message = before.isTakenUp ? new Outgoing() : before;
        if (point.is("RESEAL")) {
            message.destination = before.destination;
            message.content = before.content;
        }
        message.isTakenUp = true;
        message.isSealed = point.operand("key") != NO_KEY;
        require(!message.isSealed || stored >= 0, name + " seals message " + point.number(),
                "that it stores an epoch before");
        message.boot = boot;
        message.counter = message.isSealed ? counter++ : counter;
        outgoing.put(point.number(), message);
        if (taken.size() == MOST_TAKEN) {
            taken.subList(0, MOST_TAKEN / 2).clear();
        }
        taken.add(message);
    }

    /** Its host is told its epoch, 0 for none. */
    void tellEpoch(long told) throws RefusedException {
        require(told == 0 ? stored < 0 : (told & LOW_BYTE) == stored,
                String.format("%s says that it has epoch %06x", name, told),
                stored < 0 ? "none, as it has stored none" : String.format("one that ends in %02x, as stored", stored));
        if (told != 0) {
            checkEpoch(told, boot, "says that it has");
        }
    }

    private void checkEpoch(long now, int ofBoot, String what) throws RefusedException {
        require(ofBoot < epochBoot || (ofBoot == epochBoot ? now == epoch : now > epoch),
                String.format("%s %s epoch %06x", name, what, now), ofBoot == epochBoot
                        ? String.format("%06x, as before", epoch)
                        : String.format("%06x or a later one, since it was reset", epoch + 1));
        epoch = ofBoot < epochBoot ? epoch : now;
        epochBoot = Math.max(epochBoot, ofBoot);
    }

    /** The nonce of a frame: the next one of this board, whatever its destination; perhaps above a floor. */
    void checkNonce(Outgoing message) throws RefusedException {
        long nonce = message.frame.nonceNumber();
        checkEpoch(nonce >> Frame.COUNTER_BITS, message.boot, "seals under");
        long next = (nonce >> Frame.COUNTER_BITS << Frame.COUNTER_BITS) + message.counter;
        boolean rises = taken.stream().filter(other -> other != message && other.boot == message.boot && other.isSealed
                && other.frame != null)
                .allMatch(other -> other.counter < message.counter == other.frame.nonceNumber() < nonce);
        require(rises && (nonce == next || wasStale && nonce > next),
                String.format("%s seals a message to %s under nonce %012x", name, message.frame.destination, nonce),
                String.format("%012x, as it has sealed %d before with this epoch%s", next, message.counter,
                        wasStale ? ", or one above a floor that it was told" : ""));
    }

    /** Each frame that is cut has the next id. */
    void checkId(Outgoing message) throws RefusedException {
        int cut = 1;
        for (int i = taken.indexOf(message) - 1; i >= 0; i--) {
            Outgoing before = taken.get(i);
            if (before.frame != null && before.frame.fragmentId != Frame.NO_ID) {
                int next = (before.frame.fragmentId + cut) % IDS;
                require(message.frame.fragmentId == next, name + " cuts a frame into fragments with id "
                        + message.frame.fragmentId, "" + next);
                return;
            }
            if (before.frame == null && before.length() == 0) {
                return; // perhaps it was cut
            }
            cut += before.frame == null && before.length() > Frame.HEADER + fragmentLength ? 1 : 0;
        }
    }
}
