package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Set;
import java.util.TreeMap;
import javino.protocol.Bytes;
import javino.protocol.Payload;

/** A board's frames: what its host wants to be sent, and what it has sealed, cut and promised to answer. */
final class BoardFrames {
    private static final int IDS = 64;
    private static final int NO_KEY = 255;
    private static final int COUNTER_BITS = 24;

    /** What its host wants to be sent. */
    static final class Outgoing {
        /** Null until its host was told the number. */
        String destination;
        /** Null where that is not known. */
        Bytes content;
        /** Whether the content is another device's frame, to be sent as it is. */
        boolean isRelayed;
        boolean isTakenUp;
        boolean isSealed;
        /** How much was sealed, and how much was cut before it. */
        private int sealed;
        private int cut;
        /** As its first packet shows it; null until that. */
        Frame frame;

        private boolean isLongerThan(int length) {
            int around = isRelayed ? 0
                    : destination.equals(Frame.ALL) ? Frame.HEADER : Frame.CONTENT_AT + Payload.TAG_LENGTH;
            return content.length() + around > length;
        }
    }

    /** An acknowledgement that it owes. */
    private record Owed(String kind, int key, int nonce) {
        @Override
        public String toString() {
            return String.format("'%s' about a nonce that ends in %02x, under key %d", kind, nonce, key);
        }
    }

    final String name;
    /** Of its clock, in seconds. */
    final double second;
    final Set<String> ids = new LinkedHashSet<>();
    final Eeprom eeprom = new Eeprom();
    /** What its radio has taken last; null before that. */
    Point declared;
    boolean declares;
    /** When it has declared something first since the last reset, in seconds; negative until then. */
    double runsSince = -1;
    double resetAt;
    /** Whether somebody has told a floor, since when nonces may jump. */
    boolean wasStale;
    private final int fragmentLength;
    private final List<Owed> owed = new ArrayList<>();
    private final Map<Integer, Outgoing> outgoing = new HashMap<>();
    /** By how much was sealed before, since the last reset; also those before the first of each epoch. */
    private final NavigableMap<Integer, Long> nonces = new TreeMap<>();
    private int sealed;
    private int cut;
    /** The id of the first frame that is cut; negative while that is not known. */
    private int firstId;

    BoardFrames(String name, Header header) {
        this.name = name;
        second = header.second(name);
        fragmentLength = header.isOfE32() ? Payload.E32_PART_LENGTH : Payload.PART_LENGTH;
    }

    void reset(double seconds) {
        resetAt = seconds;
        runsSince = -1;
        firstId = -1;
        wasStale = false;
        owed.clear();
        outgoing.clear();
        nonces.clear();
    }

    /** An acknowledgement replaces the one before to the same sender; with a group's key two may owe a floor each. */
    void owe(Point point) {
        Owed added = new Owed(point.name().substring("OWE_".length()).toLowerCase(Locale.ROOT),
                point.operand("key"), point.operand("nonce"));
        owed.removeIf(before -> before.key == added.key && before.nonce == added.nonce
                && !added.kind.equals(Acknowledgement.STALE));
        owed.add(added);
    }

    /** The last one is to be sent twice. */
    void oweTwice() {
        owed.stream().reduce((before, last) -> last).ifPresent(owed::add);
    }

    /** It sends an acknowledgement. */
    void pay(String kind, int key, int nonce) throws RefusedException {
        Owed paid = new Owed(kind, key, nonce);
        require(owed.remove(paid), name + " sends " + paid, owed.isEmpty() ? "none, as it owes none" : "one of " + owed);
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

    /** Nonces begin anew with each epoch. */
    void storeEpoch() {
        nonces.put(sealed++, (eeprom.epoch() << COUNTER_BITS) - 1);
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
        require(!message.isSealed || !nonces.isEmpty(), name + " seals message " + point.number(),
                "that it stores an epoch before");
        message.sealed = message.isSealed ? sealed++ : sealed;
        message.cut = cut;
        if (message.content == null) {
            firstId = -1; // perhaps it is cut
        } else if (message.isLongerThan(Frame.HEADER + fragmentLength)) {
            cut++;
        }
        outgoing.put(point.number(), message);
    }

    /** A message's first packet is on the air. */
    void begin(Outgoing message, Payload packet) throws RefusedException {
        Frame frame = new Frame(packet);
        String wrong = message.destination != null && !ids.contains(frame.origin) ? "the origin " + frame.origin
                : frame.wrongForm(packet, fragmentLength);
        require(wrong.isEmpty(), name + " sends a " + packet.kind() + " with " + wrong, "a frame as in SPEC 2 and 7.1");
        message.frame = frame;
        if (message.isSealed) {
            require(frame.isSealed(), name + " sends a message to many that it has sealed", "an address for that");
            checkNonce(message);
        }
        if (frame.isCut() && message.content != null) {
            int first = Math.floorMod(frame.fragmentId - message.cut, IDS);
            firstId = firstId < 0 ? first : firstId;
            require(first == firstId, name + " cuts a frame into fragments with id " + frame.fragmentId,
                    "" + (firstId + message.cut) % IDS);
        }
    }

    /** The nonce of a frame: the next one of this board, whatever its destination; perhaps above a floor. */
    private void checkNonce(Outgoing message) throws RefusedException {
        long nonce = message.frame.nonceNumber();
        Map.Entry<Integer, Long> before = nonces.lowerEntry(message.sealed);
        Map.Entry<Integer, Long> later = nonces.higherEntry(message.sealed);
        long next = before.getValue() + message.sealed - before.getKey();
        require(nonce == next || wasStale && nonce > next && (later == null || nonce < later.getValue()),
                String.format("%s seals a message to %s under nonce %012x", name, message.frame.destination, nonce),
                String.format("%012x, the next one%s", next, wasStale ? " or one above a floor that it was told" : ""));
        nonces.put(message.sealed, nonce);
    }
}
