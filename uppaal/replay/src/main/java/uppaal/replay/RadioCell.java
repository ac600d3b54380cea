package uppaal.replay;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Predicate;
import javino.protocol.Payload;
import trace.TraceEvent;

/**
 * All boards, and all messages of which something was on the air. Tells the messages' automata what boards do. Their
 * packets are those that {@link Bytes} has let pass.
 */
final class RadioCell {
    private static final Map<String, String> COMES =
            Map.of("ack", "ack_comes", "fragments", "fragments_come", "stale", "stale_comes");
    private static final Map<Integer, String> ANSWERS = Map.of(8, "ack", 9, "fragments", 16, "stale");
    /** How exactly starts and ends of packets are known, in seconds: some bits. */
    static final double DISORDER = 0.002;
    /** How much later than it could a board may tell its host of what has ended, in seconds. */
    private static final double LATE = 0.5;
    /** And how much later that it knows what its host has taken: what it has just said may have been on its way. */
    private static final double UNCONFIRMED = 2;

    /** So long a board may wait before it sends something, in seconds: 300 slots at 240 bit/s. */
    private static final double LONGEST_WAIT = 20;
    /** What a board tells only where no message waits for its host. */
    static final Set<String> NOTHING_WAITS = Set.of("percepts", "host-nothing");
    /** So often what comes undamaged may be lost: to an interrupt that was late, or a full queue. */
    static final int LOST = 2;
    /** So long a sender waits at least once it has heard a copy of its message, in seconds; and some less. */
    private static final double WITH_RELAY = 2.9;
    private static final String COPIED = "copied";

    private final Map<String, Station> boards = new LinkedHashMap<>();
    private final Map<String, Message> messages = new Recent<>();
    private final Map<String, Message> byPayload = new Recent<>();
    private final Map<String, List<Message>> answers = new Recent<>();
    private final Disturbances disturbances;
    private final Scenes scenes;
    /** How many of a sort in a row came undamaged and were not handed over. */
    private final Map<String, Integer> missed = new HashMap<>();
    private long broadcasts;

    RadioCell(Disturbances disturbances, Scenes scenes) {
        this.disturbances = disturbances;
        this.scenes = scenes;
    }

    private Station board(String name) {
        return boards.computeIfAbsent(name, added -> new Station(added, new Ear(disturbances)));
    }

    private boolean isOurs(String address) {
        return boards.values().stream().anyMatch(board -> board.hasBeen(address));
    }

    /** The boards and what they are. */
    void begin(Iterable<JsonElement> all) {
        for (JsonElement each : all) {
            if (each instanceof JsonObject about && about.get("name") instanceof JsonPrimitive name
                    && about.get("model") instanceof JsonPrimitive model) {
                board(name.getAsString()).isOfModel(model.getAsString());
            }
        }
    }

    /**
     * A board loses its power, or begins anew, with its RAM as it was or without.
     *
     * @param power whether it loses its RAM
     */
    void reset(TraceEvent event, boolean power) throws RefusedException {
        Station board = board(event.board());
        boolean wasOff = board.turns(event.name().equals("fault"));
        if (board.lastEnd() > event.seconds() + DISORDER + board.ear.slot()) {
            throw new RefusedException(board.name() + " sends on after a reset; expected that its packet breaks off");
        }
        String receiver = power ? "receiver_power" : "receiver_reset";
        board.reset();
        for (Message message : messages.values()) {
            boolean isHere = message.concerns(board) && message.hasReached(board);
            if (board.hasBeen(message.origin)) {
                message.sender(event.seconds(), "sender_reset");
            } else if (isHere && (!wasOff || message.mayDo(event.seconds(), board, receiver))) {
                message.receiver(event.seconds(), board, receiver);
                if (!power) {
                    // It may come while the board writes down there what its host has taken (SPEC 5.1).
                    message.perhaps(event.seconds(), board, "receiver_power");
                }
            }
            message.forgetPieces(board);
        }
        forgetHeard(board);
    }

    /** What a board, or what it sends, has heard counts no more. */
    private void forgetHeard(Station board) {
        messages.values().stream()
                .filter(message -> board.hasBeen(message.origin) || board.hasBeen(message.destination))
                .forEach(Message::forgetHeard);
        board.forgetExpected();
    }

    /** A host has its board's radio opened or blocked. */
    void radio(TraceEvent event) {
        Station board = board(event.board());
        board.open(event.text("radio").equals("open"), event.seconds());
        forgetHeard(board);
    }

    /** A board tells whether it is a relay. */
    void relaying(TraceEvent event) {
        board(event.board()).copies.set(event.text("relaying").equals("on"));
    }

    /** A host asks for something with a key: until the reply, that may end what was sealed with it. */
    void asks(TraceEvent event, double seconds) throws RefusedException {
        for (Message message : board(event.board()).underWay(event.text("address"))) {
            message.perhaps(seconds, "sender_reset");
        }
    }

    /** A host has done something with a key. */
    void key(TraceEvent event) throws RefusedException {
        Station board = board(event.board());
        String step = event.text("step");
        String address = event.text("address");
        String before = board.check(address);
        if (step.equals("session")) {
            board.session(address, event.text("check"));
        } else {
            board.key(address, step.equals("set") ? event.text("check") : "");
        }
        if (before == null || !before.equals(board.check(address))) {
            // Only a known key is surely the same. With another, what was to be answered may be gone, as at a boot.
            for (Message message : messages.values()) {
                if (message.isUnicast() && message.origin.equals(address) && message.hasReached(board)) {
                    message.perhaps(event.seconds(), board, "receiver_reset");
                }
            }
        }
        forgetHeard(board);
    }

    /** The run is over: up to now a board has done all that was due. */
    void over(TraceEvent event) throws RefusedException {
        Station board = board(event.board());
        for (Message message : messages.values()) {
            message.await(event.seconds(), board);
        }
        checkWaiting(event.seconds(), board);
    }

    /** What its host has given a board goes on the air, once that sends nothing else and the air is quiet. */
    private static void checkWaiting(double seconds, Station board) throws RefusedException {
        Transmission first = board.waiting().orElse(null);
        if (first == null) {
            return;
        }
        double idle = Math.max(first.asked, board.ear.quietSince());
        for (Transmission other : board.open().toList()) {
            End sender = other.message == null ? null : other.message.sender();
            idle = sender == null ? idle : Math.max(idle, sender.ended());
        }
        if (idle + LONGEST_WAIT < seconds && board.ear.isSure(idle, seconds)) {
            throw new RefusedException(String.format(Locale.ROOT,
                    "%s does not send what its host has asked at %.3f s to be sent to %s, though the air is quiet",
                    board.name(), first.asked, first.destination));
        }
    }

    void named(TraceEvent event) {
        board(event.board()).name(event.text("id"));
    }

    void transmit(TraceEvent event) throws RefusedException {
        Station board = board(event.board());
        board.transmit(new Transmission(event.number("number"), event.text("destination"),
                event.real("asked")));
        crowd(event.real("asked"), board);
    }

    /** A host has given its board a packet of another device to send. */
    void relay(TraceEvent event) throws RefusedException {
        Transmission relayed =
                new Transmission(event.number("number"), Frame.ALL, event.real("asked"));
        relayed.relayed = event.text("payload");
        board(event.board()).transmit(relayed);
    }

    /** Tells what its board sends whether that has other messages to send. */
    private static void crowd(double seconds, Station board) throws RefusedException {
        List<Transmission> open = board.open().toList();
        for (Transmission transmission : open) {
            if (transmission.message != null) {
                transmission.message.sender(seconds, open.size() > 1 ? "crowd" : "alone");
            }
        }
    }

    /** A board, or somebody's transmitter, begins to send. */
    void begin(TraceEvent event, Payload payload) throws RefusedException {
        Station board = board(event.board());
        double start = event.real("start");
        if (start < board.lastEnd() - DISORDER) {
            throw new RefusedException(
                    board.name() + " begins to send; expected that its last packet ends first");
        }
        boolean relayed = !board.hasBeen(payload.origin()) && board.relays(payload.hex()).isPresent();
        boolean copy = !relayed && !board.hasBeen(payload.origin()) && (board.isNamed() || board.copies.isOn());
        boolean own = board.isNamed() && !relayed && !copy;
        if (copy) {
            board.copies.sends(event, payload, board.ear);
        } else if (own && event.hops() != 0) {
            throw new RefusedException(
                    board.name() + " sends its own packet with " + event.hops() + " hops behind it; expected none");
        }
        AirtimeCheck.check(event, payload, board);
        if (event.has("radio")) {
            board.ear.useModule();
        } else {
            board.ear.learn(event.real("bits"), start, event.real("end"));
        }
        Message message = null;
        List<Message> answered = List.of();
        String answer = "";
        End owner = null;
        if (payload.isData()) {
            message = own ? own(start, board, payload) : strange(payload);
            owner = own ? message.sender() : null;
            if (message != null) {
                message.send(payload);
            }
        } else if (payload.isAcknowledgement()) {
            answer = ANSWERS.getOrDefault(payload.message().length(), "");
            answered = own ? acknowledge(start, board, payload, answer)
                    : answers.getOrDefault(payload.hex(), List.of());
            owner = own && answered.size() == 1 ? answered.get(0).receiver(board) : null;
        } else if (own) {
            throw new RefusedException(
                    board.name() + " sends a packet of no known kind; expected a message or an acknowledgement");
        }
        board.questions.pass(start, board.ear);
        board.ear.begin(start, payload.isData() && !copy ? "own_message" : "own_answer", owner);
        board.send(
                new Packet(board.name(), payload, start, event.real("end"), event.real("bits"), message, answered,
                        answer, event.hops(), owner));
    }

    /** It has ended to send. */
    void end(TraceEvent event) throws RefusedException {
        Station board = board(event.board());
        board.ear.end(event.real("end"), "own_end",
                board.sentAt(event.real("start")).map(Packet::owner).orElse(null));
    }

    /** A board may hear somebody else from now on. */
    void carrier(TraceEvent event, double seconds) throws RefusedException {
        Station board = board(event.board());
        board.questions.pass(seconds, board.ear);
        board.ear.begin(seconds, "carrier", null);
    }

    /** And no longer. */
    void silence(TraceEvent event, double seconds) throws RefusedException {
        board(event.board()).ear.end(seconds, "silence", null);
    }

    /**
     * A board tells its host something: before that, all that has ended. It tells several outcomes in one reply, so
     * that what one reply lacks is known with the next.
     */
    void tell(TraceEvent event) throws RefusedException {
        Station board = board(event.board());
        boolean outcome = event.name().equals("host-outcome");
        double before = board.lastReply(event.seconds());
        double reply = outcome ? before : event.seconds();
        OptionalInt unconfirmed = board.taking(event.seconds() - UNCONFIRMED);
        if (unconfirmed.isPresent()) {
            throw new RefusedException(board.name() + " tells its host something, and not that it has taken message "
                    + unconfirmed.getAsInt());
        }
        checkWaiting(event.seconds(), board);
        board.questions.pass(event.seconds(), board.ear);
        boolean nothing = NOTHING_WAITS.contains(event.name());
        checkAnswered(board, board.questions.unanswered((nothing ? event.seconds() : before) - LATE));
        if (nothing) {
            for (Message message : board.missed(event.seconds() - LATE)) {
                if (missed.merge(message.sort(), 1, Integer::sum) > LOST) {
                    throw new RefusedException(board.name() + " has nothing to tell; expected a message (" + message
                            + "): of the last " + (LOST + 1)
                            + " of its sort that came undamaged no board has heard one");
                }
            }
        }
        for (Transmission transmission : board.open().toList()) {
            boolean told = outcome && transmission.number == event.real("number");
            End sender = told || transmission.message == null ? null : transmission.message.sender();
            if (sender != null && sender.ended() < reply - LATE) {
                throw new RefusedException(board.name() + " tells its host something, and not how a message has ended ("
                        + transmission.message + ")");
            }
        }
    }

    /** What came undamaged is answered, or handed over, nearly always. */
    private void checkAnswered(Station board, Map<String, Message> unanswered) throws RefusedException {
        for (Map.Entry<String, Message> each : unanswered.entrySet()) {
            if (missed.merge(each.getKey(), 1, Integer::sum) > LOST) {
                throw new RefusedException(board.name() + " does not answer (" + each.getValue()
                        + "); expected an answer: of the last " + (LOST + 1) + " times that " + each.getKey()
                        + " came undamaged no board has answered one");
            }
        }
    }

    /** What a board of ours sends of its own. */
    private Message own(double start, Station board, Payload payload) throws RefusedException {
        Message message = known(board, payload);
        boolean isNew = message == null;
        if (isNew) {
            message = begun(start, board, payload);
        }
        byPayload.put(payload.identity(), message);
        if (payload.isFragment() && payload.index() == 0) {
            board.begin(payload.fragmentId(), message);
        }
        if (message.confirmed() > LOST) {
            throw new RefusedException(board.name() + " sends again what was acknowledged " + message.confirmed()
                    + " times: " + message + "; expected: delivered");
        }
        if (message.isUnicast() && message.stale() > LOST) {
            throw new RefusedException(board.name() + " sends again what was said to be stale " + message.stale()
                    + " times: " + message + "; expected that it is sealed anew or undelivered");
        }
        if (payload.isFragment() && message.told(payload) > LOST) {
            throw new RefusedException(board.name() + " sends again a fragment that has come, though it was told "
                    + (LOST + 1) + " times that others have not: " + message);
        }
        checkPatience(start, board, message);
        boolean attempt = message.isUnicast() ? payload.asks() : payload.index() == 0;
        boolean inTurn = attempt && message.attempts();
        if (attempt && !isNew && !inTurn) {
            checkTurns(board, message);
        }
        message.sender(start, attempt ? "send" : "part");
        return message;
    }

    /** Messages to several partners take turns. */
    private static void checkTurns(Station board, Message message) throws RefusedException {
        Transmission passed = board.passesOver().orElse(null);
        if (passed != null) {
            throw new RefusedException(String.format(Locale.ROOT,
                    "%s sends a message once more (%s); expected that what its host has asked at %.3f s to be sent to "
                            + "%s has its turn",
                    board.name(), message, passed.asked, passed.destination));
        }
    }

    /** A sender that has heard a copy of its only message waits for the relays. */
    private void checkPatience(double seconds, Station board, Message message) throws RefusedException {
        if (message == null || !message.wasCopied()) {
            return;
        }
        if (message.copied() < seconds - WITH_RELAY) {
            missed.remove(COPIED);
        } else if (board.open().count() == 1 && board.ear.isTimed() && missed.merge(COPIED, 1, Integer::sum) > LOST) {
            throw new RefusedException(board.name() + " does not wait for a relay (" + message + "); expected 3 s: of "
                    + "the last " + (LOST + 1) + " times that a copy came undamaged no board has waited");
        }
        message.copied(Double.NEGATIVE_INFINITY);
    }

    /** The message that this is, or is a piece of; null where it is a new one. */
    private Message known(Station board, Payload payload) {
        if (payload.index() == 0) {
            Payload whole = payload.whole();
            if (whole.kind() != Payload.Kind.BROADCAST) {
                return messages.get(key(whole));
            }
            return board.current(whole.destination()).map(transmission -> transmission.message)
                    .filter(message -> payload.isFragment() && message == byPayload.get(payload.identity()))
                    .orElse(null);
        }
        return board.cut(payload.fragmentId()).orElseThrow();
    }

    private static String key(Payload whole) {
        return whole.origin() + whole.destination() + whole.nonce();
    }

    private Message entered(double start, Payload payload, String prefix) throws RefusedException {
        Payload whole = payload.whole();
        String content = payload.isFragment() ? "" : payload.message().hex();
        Message message = new Message(whole, Frame.pieces(payload), content, scenes);
        messages.put(message.isBroadcast() ? "broadcast " + broadcasts++ : prefix + key(whole), message);
        for (Station board : boards.values()) {
            String highest = board.highest.get(message.origin + message.destination);
            if (!message.isBroadcast() && message.concerns(board) && highest != null
                    && highest.compareTo(message.nonce) > 0) {
                message.perhaps(start, board, "newer");
            }
        }
        return message;
    }

    private Message begun(double start, Station board, Payload payload) throws RefusedException {
        Payload whole = payload.whole();
        Transmission current = board.current(whole.destination()).orElse(null);
        boolean anew = current != null && current.message != null && current.before == null && current.outcome.isEmpty()
                && current.destination.equals(whole.destination()) && current.message.mayDo(start, "reseal");
        if (anew) {
            current.message.perhaps(start, "reseal");
            current.before = current.message;
        } else {
            if (current != null && current.message != null) {
                current.message.sender(start, "next");
            }
            current = board.takeUp(whole.destination())
                    .orElseThrow(() -> new RefusedException(board.name() + " sends a message to "
                            + whole.destination() + "; expected that its host asks for it first"));
        }
        current.message = entered(start, payload, "");
        current.message.sentBy(board, current);
        crowd(start, board);
        return current.message;
    }

    /** What somebody sends who is no board of ours: again what was sent before, something of its own, or a forgery. */
    private Message strange(Payload payload) throws RefusedException {
        Payload whole = payload.whole();
        if (byPayload.containsKey(payload.identity()) && whole.kind() != Payload.Kind.BROADCAST) {
            return byPayload.get(payload.identity());
        }
        boolean broadcast = whole.kind() == Payload.Kind.BROADCAST;
        boolean honest = broadcast || !isOurs(payload.origin());
        boolean begins = payload.index() == 0 && whole.isData() && (broadcast || !whole.nonce().isEmpty());
        if (!begins || !honest && !payload.isFragment()) {
            return honest && payload.isFragment() ? later(payload) : null;
        }
        // A nonce that an attacker makes up may be that of a later message.
        String prefix = honest ? "" : "forged ";
        Message known = broadcast ? null : messages.get(prefix + key(whole));
        Message message = known == null ? entered(0, payload, prefix) : known;
        if (!message.isSame(payload)) {
            return null;
        }
        if (!honest) {
            message.forge();
        }
        byPayload.put(payload.identity(), message);
        return message;
    }

    /** A later piece of a stranger belongs to the last that it has begun. */
    private Message later(Payload payload) {
        Message last = null;
        for (Message message : messages.values()) {
            last = message.origin.equals(payload.origin()) ? message : last;
        }
        return last != null && last.isSame(payload) ? last : null;
    }

    /**
     * A board of ours answers. Twelve bits of a nonce may be those of several messages: then any of them may be meant.
     */
    private List<Message> acknowledge(double start, Station board, Payload payload, String answer)
            throws RefusedException {
        List<Message> meant = answers.getOrDefault(payload.hex(),
                messages.values().stream().filter(message -> isAnswered(message, board, payload, answer)).toList());
        List<Message> able = new ArrayList<>();
        for (Message message : meant) {
            if (!answer.isEmpty() && message.mayDo(start, board, answer)) {
                able.add(message);
            }
        }
        if (able.isEmpty()) {
            if (!meant.isEmpty() && !answer.isEmpty()) {
                Message last = meant.get(meant.size() - 1);
                throw last.refusal(answer, board.name(), last.receiver(board));
            }
            throw new RefusedException(board.name()
                    + " acknowledges; expected that a message for it is on its way with this nonce");
        }
        for (Message message : able) {
            if (able.size() == 1) {
                message.receiver(start, board, answer);
            } else {
                message.receiver(board).perhapsSends(start, answer);
            }
        }
        if (answer.equals("fragments") && able.size() == 1) {
            checkAnswered(board, board.questions.unanswered(able.get(0)));
        }
        able.forEach(message -> heed(board, message));
        meet(board, able::contains);
        if (answer.equals("fragments") && able.size() == 1
                && able.get(0).missed(payload.message().at(0), start) > LOST) {
            throw new RefusedException(board.name() + " answers " + (LOST + 1)
                    + " times in a row without a fragment that came undamaged: " + able.get(0));
        }
        if (answer.equals("stale")) {
            board.forgetExpected();
        }
        answers.put(payload.hex(), able);
        return able;
    }

    private static boolean isAnswered(Message message, Station board, Payload acknowledgement, String answer) {
        boolean kind = message.isUnicast() || message.kind.equals("multicast") && answer.equals("stale");
        return kind && board.isConcernedBy(message.destination)
                && Frame.lastBits(message.nonce) == acknowledgement.answered();
    }

    /** A packet has come to a board undamaged; or so that it may have mended it. */
    void reach(TraceEvent event, double seconds) throws RefusedException {
        Station board = board(event.board());
        Packet packet = source(event).orElseThrow(() -> new RefusedException(board.name()
                + " hears a packet; expected that a board has sent it"));
        if (event.has("payload") && !packet.payload().hex().equals(event.text("payload"))) {
            throw new RefusedException(board.name() + " hears a packet that is not as it was sent");
        }
        if (event.has("payload") && event.hops() != packet.hops()) {
            throw new RefusedException(board.name() + " hears a packet with " + event.hops()
                    + " hops behind it; expected " + packet.hops() + ", as it was sent");
        }
        AirtimeCheck.checkArrival(event, packet);
        if (packet.board().equals(board.name()) || !packet.reached().add(board.name())) {
            throw new RefusedException(board.name()
                    + " hears a packet again or from itself; expected that each comes once to each other board");
        }
        boolean undamaged = event.has("payload") && board.lastEnd() < packet.start()
                && board.ear.isSure(packet.start(), event.real("end") - DISORDER);
        hear(packet, board, undamaged, seconds);
        board.copies.hears(packet, undamaged, seconds);
        copied(packet, board, undamaged, seconds);
        if (packet.message() != null && packet.message().concerns(board)) {
            for (String step : packet.message().arrivals(board, packet.payload())) {
                packet.message().perhaps(seconds, board, step);
            }
        }
        for (Message message : forged(packet)) {
            message.doubtPieces(seconds);
            if (packet.payload().asks() && message.hasReached(board)) {
                for (String step : message.arrivals(board)) {
                    message.perhaps(seconds, board, step);
                }
            }
        }
        for (Message message : packet.answered()) {
            if (board.hasBeen(message.origin)) {
                message.perhaps(seconds, COMES.get(packet.answer()));
                if (packet.answer().equals("fragments")) {
                    message.goesOn();
                }
            }
        }
    }

    /** A sender may hear a copy of what it has sent itself: a relay carries it. */
    private void copied(Packet packet, Station board, boolean undamaged, double seconds) throws RefusedException {
        Payload payload = packet.payload();
        Message message = payload.kind() == Payload.Kind.UNICAST ? messages.get(key(payload)) : null;
        if (message != null && board.hasBeen(message.origin) && message.sender() != null) {
            message.perhaps(seconds, "copy_comes");
            message.copied(undamaged ? seconds : Double.NEGATIVE_INFINITY);
        }
    }

    /** Of what messages somebody else's packet seems to be a piece. */
    private List<Message> forged(Packet packet) {
        Payload payload = packet.payload();
        return !payload.isFragment() ? List.of()
                : boards.values().stream().filter(board -> board.hasBeen(payload.origin()))
                        .flatMap(board -> board.cut(payload.fragmentId()).stream())
                        .filter(message -> message != packet.message()).toList();
    }

    /** What comes undamaged to a board that does not send is heard, nearly always. */
    private void hear(Packet packet, Station board, boolean undamaged, double seconds) {
        Message message = packet.message();
        Payload payload = packet.payload();
        if (message == null ? payload.isFragment() : message.concerns(board)) {
            board.comes(message, payload, seconds);
        }
        if (message != null && message.concerns(board) && board.isConcernedBy(message.destination)) {
            boolean isKept = undamaged && board.wasOpen(packet.start()) && canOpen(board, packet)
                    && board.hasRoom(message, payload, seconds);
            boolean isNew = message.comes(payload.index(), isKept, seconds);
            ask(message, payload, board, isKept, isNew, seconds);
            if (isKept && message.becomesWhole(board, seconds)) {
                board.expects(message, seconds);
            }
        }
        if (undamaged && packet.answered().size() == 1 && board.hasBeen(packet.answered().get(0).origin)
                && !packet.answered().get(0).mayHaveLostItsKey(board)) {
            if (packet.answer().equals("ack")) {
                packet.answered().get(0).confirm();
            } else if (packet.answer().equals("stale")) {
                packet.answered().get(0).outdate();
            } else if (packet.answer().equals("fragments")) {
                packet.answered().get(0).told(payload.message().at(0));
            }
        }
    }

    /**
     * Its receiver is to answer a unicast, once its host has taken it; and a piece that asks, if it has the first one.
     *
     * @param surely whether it comes undamaged to who can take it
     * @param isNew whether the piece is surely new there
     */
    private static void ask(Message message, Payload payload, Station board, boolean surely, boolean isNew,
            double seconds) {
        if (!message.isUnicast() || payload.isFragment() && !payload.asks()) {
            return;
        }
        if (!surely || payload.isFragment() && payload.index() > 0 && !message.hasFirst(seconds)) {
            board.questions.doubt(message);
            return;
        }
        message.comes(seconds);
        if (!message.isDoubted()) {
            board.questions.come(message, !payload.isFragment() ? "a unicast"
                    : !isNew ? "a fragment that asks, which may be there,"
                            : payload.index() == 0 ? "a new first fragment that asks"
                                    : "another new fragment that asks",
                    seconds);
        }
    }

    /** Whether a board listens and has the key of what somebody else has sent. */
    private boolean canOpen(Station board, Packet packet) {
        Message message = packet.message();
        String own = message.isUnicast() ? message.origin : message.destination;
        return message.isBroadcast() ? board.isOpen()
                : message.isSealedFor(board)
                        && board.listensTo(board(packet.board()), own, message.destination);
    }

    /** What came so often undamaged to a board that listens and has key and room, that hands it on or answers. */
    private void checkUndelivered(Station board, Message message) throws RefusedException {
        if (message == null || message.came().size() <= LOST) {
            return;
        }
        double last = message.came().get(message.came().size() - 1);
        for (Station receiver : boards.values()) {
            if (receiver.hasBeen(message.destination) && receiver.hasTold(last)) {
                throw new RefusedException(
                        board.name() + " reports undelivered what came undamaged to " + receiver.name()
                                + " " + message.came().size() + " times: " + message + "; expected an acknowledgement");
            }
        }
    }

    /** The packet that somebody hears; nothing where the trace has not told who sends it. */
    Optional<Packet> source(TraceEvent event) {
        double start = event.real("start");
        Collection<Station> from = event.has("from") ? List.of(board(event.text("from"))) : boards.values();
        return from.stream().flatMap(board -> board.sentAt(start).stream()).findFirst();
    }

    /** A board has handed a message to its host. */
    void hand(TraceEvent event) throws RefusedException {
        Station board = board(event.board());
        int number = event.number("number");
        Message before = board.handed.get(number);
        if (before != null && isHanded(before, event)) {
            before.receiver(event.seconds(), board, "hand_again");
            return;
        }
        List<Message> sent = messages.values().stream().filter(message -> isHanded(message, event)).toList();
        if (before != null || sent.isEmpty()) {
            throw new RefusedException(board.name() + " hands its host a message that nobody has sent; expected: "
                    + (before == null ? "nothing" : before.toString()));
        }
        Message message = sent.get(sent.size() - 1);
        for (int i = sent.size() - 1; i >= 0; i--) {
            message = sent.get(i).mayDo(event.seconds(), board, "hand") ? sent.get(i) : message;
        }
        message.receiver(event.seconds(), board, "hand");
        heed(board, message);
        board.hand(number, message);
        meet(board, each -> isHanded(each, event));
    }

    private void heed(Station board, Message message) {
        message.heed();
        board.questions.answer(message).ifPresent(missed::remove);
    }

    /** A board hands over what it was to, or answers. */
    private void meet(Station board, Predicate<Message> which) {
        board.met(which).forEach(message -> missed.remove(message.sort()));
    }

    private static boolean isHanded(Message message, TraceEvent event) {
        if (!message.origin.equals(event.text("origin")) || !message.destination.equals(event.text("destination"))) {
            return false;
        }
        if (message.isBroadcast()) {
            String content = HexFormat.of().formatHex(event.textOrEmpty("content").getBytes(StandardCharsets.UTF_8));
            return message.content.isEmpty() || content.isEmpty() || content.equals(message.content);
        }
        return event.text("id").equals(Frame.id(message.nonce));
    }

    /** A host says that it has taken a message and those before it; or the board confirms that. */
    void take(TraceEvent event, String step) throws RefusedException {
        Station board = board(event.board());
        int number = event.number("number");
        if (step.equals("taking")) {
            board.take(number, event.seconds());
        } else if (!board.confirm(number)) {
            throw new RefusedException(board.name() + " confirms that its host has taken message " + number
                    + "; expected that its host says so first");
        }
        if (!board.handed.containsKey(number)) {
            return; // it is confirmed already
        }
        Map<Integer, Message> taken = new LinkedHashMap<>();
        for (Map.Entry<Integer, Message> each : board.handed.entrySet()) {
            taken.put(each.getKey(), each.getValue());
            if (each.getKey() == number) {
                break;
            }
        }
        for (Map.Entry<Integer, Message> each : taken.entrySet()) {
            if (step.equals("taking")) {
                each.getValue().receiver(board).take(event.seconds());
                overtake(event.seconds(), board, each.getValue(), false);
            } else {
                each.getValue().receiver(event.seconds(), board, step);
                board.handed.remove(each.getKey());
                overtake(event.seconds(), board, each.getValue(), true);
            }
        }
    }

    /**
     * What is older than what the host has taken of the same sender, under the same key, is no longer accepted.
     *
     * @param confirmed whether the board has said that it knows of that; it may know before
     */
    private void overtake(double seconds, Station board, Message taken, boolean confirmed) throws RefusedException {
        if (taken.isBroadcast()) {
            return;
        }
        if (confirmed) {
            board.highest.merge(taken.origin + taken.destination, taken.nonce, (a, b) -> a.compareTo(b) > 0 ? a : b);
        }
        for (Message message : messages.values()) {
            boolean older = message.origin.equals(taken.origin) && message.destination.equals(taken.destination)
                    && message.nonce.compareTo(taken.nonce) < 0;
            if (older && message.concerns(board) && message.hasReached(board)) {
                if (confirmed) {
                    message.receiver(seconds, board, "newer");
                } else {
                    message.perhaps(seconds, board, "newer");
                }
            }
        }
    }

    /** A board tells its host how a transmission ended. */
    void outcome(TraceEvent event) throws RefusedException {
        Station board = board(event.board());
        String outcome = event.text("outcome");
        Transmission transmission =
                board.numbered(event.number("number")).orElseThrow(() -> new RefusedException(board.name()
                        + " reports " + outcome + " for a message that its host has not given it"));
        if (!transmission.outcome.isEmpty()) {
            if (!transmission.outcome.equals(outcome)) {
                throw new RefusedException(board.name() + " reports " + outcome
                        + "; expected what it had reported: " + transmission.outcome);
            }
            return; // a host that comes is told again
        }
        Transmission oldest = board.oldest(transmission);
        if (transmission.message != null && oldest != transmission) {
            throw new RefusedException(board.name() + " reports " + outcome + " for message " + transmission.number
                    + "; expected what has become of message " + oldest.number + ", which was before it");
        }
        transmission.outcome = outcome;
        if (transmission.wasRelayed) {
            if (!outcome.equals("sent")) {
                throw new RefusedException(
                        board.name() + " reports " + outcome + " for what it has relayed; expected: sent");
            }
            return;
        }
        if (outcome.equals("undelivered") && transmission.message != null && transmission.keyMayBeGone
                && !transmission.message.mayDo(event.seconds(), outcome)) {
            // As at a reset: nothing that comes can acknowledge it any more.
            transmission.message.sender(event.seconds(), "sender_reset");
            crowd(event.seconds(), board);
            return;
        }
        if (outcome.equals("undelivered")) {
            checkUndelivered(board, transmission.message);
            checkPatience(event.seconds(), board, transmission.message);
        }
        if (transmission.message == null) {
            unsent(board, transmission);
        } else if (transmission.before != null && !transmission.message.mayDo(event.seconds(), outcome)
                && transmission.before.mayDo(event.seconds(), outcome)) {
                    split(event.seconds(), board, transmission, outcome);
                } else {
                    transmission.message.sender(event.seconds(), outcome);
                }
        crowd(event.seconds(), board);
    }

    private static void unsent(Station board, Transmission transmission) throws RefusedException {
        if (!transmission.outcome.equals("undelivered")) {
            throw new RefusedException(board.name() + " reports " + transmission.outcome
                    + " for a message that was never on the air; expected: undelivered");
        }
        if (!transmission.mayFail) {
            throw new RefusedException(board.name() + " reports undelivered what was never on the air, to "
                    + transmission.destination + "; expected that it is sent");
        }
        board.giveUp(transmission);
    }

    /** What was taken for the same message under a new nonce was the next one to the same device. */
    private static void split(double seconds, Station board, Transmission ended, String outcome)
            throws RefusedException {
        ended.before.sender(seconds, outcome);
        Transmission next = board.takeUp(ended.destination)
                .orElseThrow(() -> new RefusedException(board.name() + " reports " + outcome
                        + " while it sends the message anew"));
        next.message = ended.message;
    }
}
