package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import javino.protocol.Bytes;
import javino.protocol.Counter;
import javino.protocol.Payload;

/** A board's frames: what its host wants to be sent, and what it has sealed, cut and promised to answer. */
final class BoardFrames {
    private static final int IDS = 64;
    private static final int NO_KEY = 255;
    private static final int COUNTER_BITS = 24;

    /** The messages that its host wants to be sent. */
    static final class Outgoing {
        /** Null where its host was not told the number. */
        final String destination;
        /** Null where that is not known. */
        final Bytes content;
        /** Whether the content is another device's frame, to be sent as it is. */
        final boolean isRelayed;
        boolean isTakenUp;
        /** How much was sealed before it, itself too; 0 if it is not sealed. */
        private int sealed;
        /** How much was cut before it. */
        private int cut;
        /** As its first packet shows it; null until that. */
        Frame frame;
        /** When that began, in seconds. */
        private double sentAt;
        /** Whether its receiver says that it cannot have had it before it lost its memory. */
        private boolean isNew;

        Outgoing(String destination, Bytes content, boolean isRelayed) {
            this.destination = destination;
            this.content = content;
            this.isRelayed = isRelayed;
        }
    }

    final String name;
    /** A second of its clock, in seconds. */
    final double second;
    final Set<String> ids = new HashSet<>();
    final Eeprom eeprom = new Eeprom();
    final Map<Integer, Outgoing> outgoing = new HashMap<>();
    boolean declares;
    /** When it has declared something first since the last reset, in seconds; negative until then. */
    double runsSince = -1;
    double resetAt;
    /** Whether somebody has told a floor, since when nonces may jump. */
    boolean wasStale;
    /** In which run() it has refused a whole for its tag last, and whether it answers such a one. */
    private double refusedAt = -1;
    boolean isRefused;
    private final int partLength;
    /** By key, the acknowledgements that it owes. */
    private final Map<Integer, Set<String>> owed = new HashMap<>();
    /** By how much was sealed, since the last reset; also those before the first of each epoch. */
    private final NavigableMap<Integer, Long> nonces = new TreeMap<>();
    private int sealed;
    private int cut;
    /** The id of the first frame that is cut; negative while that is not known. */
    private int firstId = -1;

    BoardFrames(String name, Header header) {
        this.name = name;
        second = header.second(name);
        partLength = header.isOfE32() ? Payload.E32_PART_LENGTH : Payload.PART_LENGTH;
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
        isRefused = point.run() == refusedAt;
        String kind = point.name().substring("OWE_".length()).toLowerCase(Locale.ROOT);
        Set<String> same = owed.computeIfAbsent(point.operand("key"), added -> new HashSet<>());
        same.removeIf(before -> !kind.equals(Acknowledgement.STALE) || !before.startsWith(kind));
        same.add(Acknowledgement.described(kind, point.operand("nonce")));
    }

    void count(Point point) {
        refusedAt = point.counter().equals(Optional.of(Counter.RADIO_BAD_TAG)) ? point.run() : refusedAt;
    }

    /** It sends an acknowledgement. How often it may, the model tells. */
    void pay(int key, Acknowledgement answer) throws RefusedException {
        Set<String> same = owed.getOrDefault(key, Set.of());
        require(same.contains(answer.toString()), name + " acknowledges " + answer, "what it owes: " + same);
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
        nonces.put(++sealed, (eeprom.epoch() << COUNTER_BITS) - 1);
    }

    /** A message is taken up, or sealed anew. */
    void seal(Point point) throws RefusedException {
        Outgoing message = outgoing.get(point.number());
        if (message == null || message.isTakenUp != point.is("RESEAL")) {
            message = new Outgoing(null, null, false);
            outgoing.put(point.number(), message);
        }
        require(!point.is("RESEAL") || message.isNew, name + " seals message " + point.number() + " anew",
                "that its receiver has been up for longer than it is on its way");
        message.isTakenUp = true;
        message.isNew = false;
        message.frame = null;
        message.sealed = point.operand("key") == NO_KEY ? 0 : ++sealed;
        require(message.sealed == 0 || !nonces.isEmpty(), name + " seals message " + point.number(),
                "that it stores an epoch before");
        message.cut = cut;
        if (message.content == null) {
            firstId = -1; // perhaps it is cut
        } else if (isCut(message)) {
            cut++;
        }
    }

    /** A floor above a message is heard (SPEC 7.3): by a sixteenth and 1 s more, since clocks differ. */
    void hearStale(Point point, double uptime) throws RefusedException {
        Outgoing message = message(point);
        double onItsWay = (point.run() - message.sentAt) / second;
        message.isNew = uptime > onItsWay + onItsWay / 16 + 1 - PhysicalLimits.MILLIS_STEP_SECONDS;
    }

    private static int length(Outgoing message) {
        return message.content.length() + (message.isRelayed ? 0 : Frame.around(message.destination));
    }

    private boolean isCut(Outgoing message) {
        return length(message) > Frame.HEADER + partLength;
    }

    /** A message's first packet is on the air. */
    void begin(Outgoing message, Transmission packet) throws RefusedException {
        Frame frame = new Frame(packet.payload());
        message.frame = frame;
        message.sentAt = packet.declared().run();
        String what = name + " sends a " + packet.payload().kind() + ", " + frame + ", of " + frame.length + " bytes";
        require(message.destination == null || frame.destination.equals(message.destination)
                && frame.origin.equals(packet.payload().origin()) && ids.contains(frame.origin),
                what, "one from " + ids + " to " + message.destination);
        if (message.content != null) {
            checkCut(message, what);
        }
        if (message.sealed > 0) {
            require(frame.nonce.length() != 0, name + " sends a message that it has sealed without a nonce", "a nonce");
            checkNonce(message);
        }
    }

    /** The length of a frame, that of its parts, and their id. */
    private void checkCut(Outgoing message, String what) throws RefusedException {
        Frame frame = message.frame;
        boolean isCut = isCut(message);
        int length = length(message);
        require(frame.length == length && frame.isCut() == isCut
                && frame.first().length() == (isCut ? partLength : length),
                what, length + " in " + (isCut ? "fragments of " + partLength : "one packet"));
        if (isCut) {
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
        boolean mayFollow = later == null ? nonce >> COUNTER_BITS == next >> COUNTER_BITS : nonce < later.getValue();
        require(nonce == next || wasStale && nonce > next && mayFollow,
                String.format("%s seals a message to %s under nonce %012x", name, message.frame.destination, nonce),
                String.format("%012x, the next one%s", next, wasStale ? " or one above a floor that it was told" : ""));
        nonces.put(message.sealed, nonce);
    }
}
