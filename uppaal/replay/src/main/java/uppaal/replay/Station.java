package uppaal.replay;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javino.protocol.Payload;

/** A board: who it is, what its host has it send, and what it has handed to its host. */
final class Station {
    /** Packets on the air at one time are few; so many of a board are never waited for. */
    private static final int PACKETS = 8;
    private static final int LAST_NUMBER = 255;
    /** How far apart the starts of a packet may lie that its sender and a receiver see, in seconds. */
    private static final double LATENESS = 0.005;
    /** A host has looked lately if it has got something since then, in seconds: little comes in that time. */
    private static final double LOOKS = 3;
    /** A broadcast of the same content is a repeat for 400 ms; far less than this, in seconds. */
    private static final double REPEATED = 2;
    /** A Mega keeps more short messages than these. */
    private static final int FEW = 5;
    private static final String MEGA = "mega";
    private static final int PLACES = 2;
    private static final int SESSION_KEYS = 8;
    /** So many partners of a Mega take turns. */
    private static final int PARTNERS = 4;

    private final String name;
    private final Set<String> ids = new HashSet<>();
    private final Deque<Packet> packets = new ArrayDeque<>();
    /** Transmissions of which nothing was on the air yet, in the order in which its host gave them. */
    private final Deque<Transmission> waiting = new ArrayDeque<>();
    /** By their numbers, the oldest first. */
    private final Map<Integer, Transmission> numbered = new LinkedHashMap<>();
    /** Messages that the host has not taken, by their numbers, in the order in which they were handed over. */
    final Map<Integer, Message> handed = new LinkedHashMap<>();
    /** The highest nonce that the host has taken, for each origin and destination. */
    final Map<String, String> highest = new HashMap<>();
    /** What it has sent last, for each partner. */
    private final Map<String, Transmission> current = new HashMap<>();
    /** What it has cut last, by the ids of pieces. */
    private final Map<Integer, Message> cut = new HashMap<>();
    /** Numbers of all messages that it has handed over. */
    private final Set<Integer> numbers = new HashSet<>();
    /** What its host has said and it has not confirmed. */
    private final Deque<Taking> taking = new ArrayDeque<>();
    /** The number of the last transmission; the first one has 0. */
    private int last = LAST_NUMBER;
    private String id = "";
    /** Whether it has no power. */
    private boolean off;
    /** Whether its host has opened its radio, and since when it surely runs: in seconds. */
    private boolean open;
    private double openSince;
    /** The check values of the keys that its host has set and not touched since, by address. */
    private final Map<String, String> checks = new HashMap<>();
    /** The devices of those of them that are session keys, the one that was set last at the end. */
    private final Set<String> sessions = new LinkedHashSet<>();
    /** Session keys that it knows to have had, whatever became of them; the last is the one that was set last. */
    private final Deque<String> had = new ArrayDeque<>();
    /** What has come since it has last told its host something; null stands for what nobody knows. */
    private final Set<Message> came = new HashSet<>();
    /** What came undamaged and is to be handed over, and when. */
    private final Map<Message, Double> expected = new LinkedHashMap<>();
    /** When a broadcast came last, by its origin. */
    private final Map<String, Double> broadcasts = new Recent<>();
    /** When a piece came last, by whose it was and the id of the whole. */
    private final Map<String, Double> pieces = new Recent<>();
    /** Messages in pieces that it can put together at one time. */
    private int places;
    /** Session keys that it has place for, at the least. */
    private int sessionPlaces;
    /** When it has told its host something, the last time and the time before. */
    private double reply = Double.NEGATIVE_INFINITY;
    private double replyBefore = Double.NEGATIVE_INFINITY;

    /** When its host has said that it has taken a message. */
    private record Taking(int number, double seconds) {}

    /** What it hears. */
    final Ear ear;
    /** What it is to answer. */
    final Questions questions = new Questions();
    /** What it may send as a relay. */
    final Copies copies;

    Station(String name, Ear ear) {
        this.name = name;
        this.ear = ear;
        copies = new Copies(name, ids);
    }

    /** Its transmissions that have not been told to have ended. */
    Stream<Transmission> open() {
        return numbered.values().stream().filter(transmission -> transmission.outcome.isEmpty());
    }

    String name() {
        return name;
    }

    void name(String newId) {
        id = newId;
        ids.add(newId);
    }

    boolean isNamed() {
        return !id.isEmpty();
    }

    /** Whether this is its id, or was. */
    boolean hasBeen(String address) {
        return ids.contains(address);
    }

    boolean isConcernedBy(String destination) {
        return ids.stream().anyMatch(own -> Frame.concerns(destination, own));
    }

    /** What it sent at that time, as far as that is known. */
    Optional<Packet> sentAt(double start) {
        return packets.stream().filter(packet -> Math.abs(packet.start() - start) < LATENESS).findFirst();
    }

    /** When the last packet ended that it has sent. */
    double lastEnd() {
        return packets.isEmpty() ? Double.NEGATIVE_INFINITY : packets.getLast().end();
    }

    void send(Packet packet) {
        packets.add(packet);
        if (packets.size() > PACKETS) {
            packets.remove();
        }
    }

    /** It has taken something over from its host to send. */
    void transmit(Transmission transmission) throws RefusedException {
        last = last + 1 & LAST_NUMBER;
        if (transmission.number != last) {
            throw new RefusedException(
                    name + " takes over transmission " + transmission.number + "; expected " + last);
        }
        transmission.check = checks.get(transmission.destination);
        transmission.mayFail =
                !transmission.destination.equals(Frame.ALL) && !checks.containsKey(transmission.destination);
        waiting.add(transmission);
        numbered.remove(transmission.number);
        numbered.put(transmission.number, transmission);
    }

    /** Messages to a partner are under way one after the other; all that goes to many has one turn together. */
    private static String partner(String destination) {
        return destination.startsWith("//") ? "//" : destination;
    }

    /** The oldest that has not been told to have ended, of those to the like of this one; itself where it is that. */
    Transmission oldest(Transmission transmission) {
        return open().filter(each -> partner(each.destination).equals(partner(transmission.destination))).findFirst()
                .orElse(transmission);
    }

    /** What it has sent last to a destination, or to its like. */
    Optional<Transmission> current(String destination) {
        return Optional.ofNullable(current.get(partner(destination)));
    }

    /** It sends the first piece of a message. */
    void begin(int fragmentId, Message message) {
        cut.put(fragmentId, message);
    }

    /** The message whose pieces have this id. */
    Optional<Message> cut(int fragmentId) {
        return Optional.ofNullable(cut.get(fragmentId));
    }

    void open(boolean now, double seconds) {
        openSince = open ? openSince : seconds;
        open = now;
    }

    /** Its host has done something with a key; what only setting leaves is known. */
    void key(String address, String check) {
        if (sessions.remove(address)) {
            had.clear(); // it may remember another one instead
        }
        checks.remove(address);
        waiting.forEach(transmission -> transmission.mayFail = true);
        mayHaveLost(address);
        if (!check.isEmpty()) {
            checks.put(address, check);
        }
    }

    /** What has been on the air of messages to a device that have not ended. */
    List<Message> underWay(String address) {
        return open().filter(transmission -> transmission.destination.equals(address) && transmission.message != null)
                .map(transmission -> transmission.message).toList();
    }

    private void mayHaveLost(String address) {
        open().filter(transmission -> transmission.destination.equals(address))
                .forEach(transmission -> transmission.keyMayBeGone = true);
    }

    /**
     * Its host has set a session key. It sets none where it has another sort of key, nor one that it had before. Where
     * it has not enough places, it is not known which one goes; those that go may be all but this.
     */
    void session(String device, String check) throws RefusedException {
        boolean isAgain = sessions.contains(device) && check.equals(checks.get(device));
        if (!isAgain && had.contains(check) || checks.containsKey(device) && !sessions.contains(device)) {
            throw new RefusedException(name + " sets a session key for " + device + ", check value " + check
                    + "; expected that it refuses it: " + (had.contains(check) ? "it had that one before"
                            : "it has a stored key for that device"));
        }
        if (isAgain) {
            return;
        }
        List<String> before = List.copyOf(had);
        key(device, check);
        had.addAll(before);
        sessions.add(device);
        had.add(check);
        if (had.size() > sessionPlaces) {
            had.remove();
        }
        if (sessions.size() > sessionPlaces) {
            Set<String> others = Set.copyOf(sessions);
            others.stream().filter(each -> !each.equals(device)).forEach(each -> {
                checks.remove(each);
                mayHaveLost(each);
            });
            sessions.retainAll(Set.of(device));
        }
    }

    /** Whether it must hear what another one seals for it, and open it. */
    boolean listensTo(Station other, String from, String to) {
        return open && checks.containsKey(from) && checks.get(from).equals(other.checks.get(to));
    }

    /** The check value of its key for an address; null where it has none, or none that is known. */
    String check(String address) {
        return checks.get(address);
    }

    /** The oldest transmission of which nothing was on the air. */
    Optional<Transmission> waiting() {
        return waiting.stream().findFirst();
    }

    /** It hands a message to its host. */
    void hand(int number, Message message) {
        handed.put(number, message);
        numbers.add(number);
    }

    /** When it has last told its host something before this time, at which it tells more. */
    double lastReply(double seconds) {
        if (seconds > reply) {
            replyBefore = reply;
            reply = seconds;
            came.clear();
        }
        return replyBefore;
    }

    /** Its host says that it has taken a message. */
    void take(int number, double seconds) throws RefusedException {
        if (!numbers.contains(number)) {
            throw new RefusedException(name + " is told that its host has taken message " + number
                    + "; expected one that it has handed over");
        }
        // It says so again where the reply to its poll comes late, and is told once.
        taking.removeIf(each -> each.number == number);
        taking.add(new Taking(number, seconds));
        ear.busy(true);
    }

    /** It confirms that, in the order in which its host has said so; returns false where that has not. */
    boolean confirm(int number) {
        if (taking.stream().noneMatch(each -> each.number == number)) {
            return false;
        }
        while (taking.remove().number != number) {
            // What its host has said before, in a request that it did not get.
        }
        ear.busy(!taking.isEmpty());
        return true;
    }

    /** A Mega has two places for messages in pieces, and a small chip none. */
    void isOfModel(String model) {
        places = model.equals(MEGA) ? PLACES : 0;
        sessionPlaces = model.equals(MEGA) ? SESSION_KEYS : 1;
    }

    /** A packet comes to it, perhaps damaged, of a message that it may be for; of a strange piece nobody knows. */
    void comes(Message message, Payload payload, double seconds) {
        came.add(message);
        if (payload.isFragment()) {
            pieces.put(payload.origin() + payload.fragmentId(), seconds);
        }
    }

    /**
     * Whether it can keep what has just come. Of pieces: whether there is a place for them. Of a whole: whether its
     * host has looked lately, and there is little else that it may not have taken.
     */
    boolean hasRoom(Message message, Payload payload, double seconds) {
        if (handed.containsValue(message)) {
            return false;
        }
        if (payload.isFragment()) {
            return pieces.values().stream().filter(last -> last > seconds - Message.FORGOTTEN).count() <= places;
        }
        int all = came.size() + handed.size();
        boolean areShort = Stream.concat(came.stream(), handed.values().stream())
                .allMatch(each -> each != null && !each.isInPieces());
        return all <= (areShort && places > 0 ? FEW : 1) && reply > seconds - LOOKS;
    }

    /** Whether it listened when a packet began: a board that boots hears none. */
    boolean wasOpen(double start) {
        return open && openSince < start;
    }

    boolean isOpen() {
        return open;
    }

    /** A message has come that it can keep; but soon after a broadcast another may be taken for its repeat. */
    void expects(Message message, double seconds) {
        Double before = message.isBroadcast() ? broadcasts.put(message.origin, seconds) : null;
        if (before == null || before < seconds - REPEATED) {
            expected.put(message, seconds);
        }
    }

    /** It hands over what it was to, or answers. @return what that was */
    List<Message> met(Predicate<Message> handedOver) {
        List<Message> met = expected.keySet().stream().filter(handedOver).toList();
        expected.keySet().removeAll(met);
        return met;
    }

    /** Nothing waits for its host. @return what came before that moment, and it has not handed over */
    List<Message> missed(double before) {
        List<Message> missed = expected.keySet().stream().filter(message -> expected.get(message) < before).toList();
        expected.keySet().removeAll(missed);
        return missed;
    }

    void forgetExpected() {
        expected.clear();
        questions.clear();
    }

    /** Whether it has told its host something since then. */
    boolean hasTold(double since) {
        return reply > since;
    }

    /** What its host has said before that moment to have taken, and it has not confirmed. */
    OptionalInt taking(double before) {
        return taking.stream().filter(each -> each.seconds < before).mapToInt(Taking::number).findFirst();
    }

    Optional<Transmission> numbered(int number) {
        return Optional.ofNullable(numbered.get(number));
    }

    /** The next transmission to a destination is sent; those to its like before it could not be sealed. */
    Optional<Transmission> takeUp(String destination) {
        List<Transmission> like =
                waiting.stream().filter(each -> partner(each.destination).equals(partner(destination))).toList();
        Optional<Transmission> next =
                like.stream().filter(each -> each.relayed.isEmpty() && each.destination.equals(destination))
                        .findFirst();
        next.ifPresent(transmission -> {
            waiting.removeAll(like.subList(0, like.indexOf(transmission) + 1));
            current.put(partner(destination), transmission);
        });
        return next;
    }

    /**
     * It sends a message once more. Those to partners to which nothing is under way have had their turn before that,
     * as long as there is a place for them.
     *
     * @return one that was passed over so often that it must have had it
     */
    Optional<Transmission> passesOver() {
        Set<String> underWay = new HashSet<>();
        open().filter(each -> each.message != null).forEach(each -> underWay.add(partner(each.destination)));
        if (places == 0 || underWay.size() >= PARTNERS) {
            return Optional.empty();
        }
        int most = RadioCell.LOST + underWay.size();
        // Of those to one partner only the first has a turn.
        return waiting.stream().filter(each -> each.relayed.isEmpty() && underWay.add(partner(each.destination)))
                .filter(each -> !each.mayFail)
                .filter(each -> ++each.passedOver > most).findFirst();
    }

    /** It sends a packet of another device, whether its host has asked for that or not. */
    Optional<Transmission> relays(String payload) {
        Optional<Transmission> asked =
                waiting.stream().filter(transmission -> transmission.relayed.equals(payload)).findFirst();
        asked.ifPresent(transmission -> {
            waiting.remove(transmission);
            transmission.wasRelayed = true;
        });
        return asked;
    }

    /** It will not send this. */
    void giveUp(Transmission transmission) {
        waiting.remove(transmission);
    }

    /** Its power goes or comes. @return whether it had none */
    boolean turns(boolean nowOff) {
        boolean before = off;
        off = nowOff;
        return before;
    }

    /** It begins anew: what it was to send, what it has not handed over and its session keys are gone. */
    void reset() {
        sessions.forEach(checks::remove);
        sessions.clear();
        had.clear();
        open = false;
        copies.reset();
        last = LAST_NUMBER;
        came.clear();
        taking.clear();
        ear.busy(false);
        numbers.clear();
        waiting.clear();
        numbered.clear();
        handed.clear();
        current.clear();
        cut.clear();
    }
}
