package javino.fake;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Capability;
import javino.protocol.Counter;
import javino.protocol.Frame;
import javino.protocol.Outcome;
import javino.protocol.Request;
import javino.protocol.Status;

/** A board in memory that performs requests as SPEC 4.2 and 4.3 want it, or as its script says, and logs them. */
public final class FakeBoard {

    /** Requests that change and send nothing, which are not logged. */
    private static final Set<String> READS = Set.of("list actions", "list keys", "statistics");

    private static final String RADIOS = letters(Request.Command::needsRadio);
    private static final String WHOLE_RADIOS = letters(Request.Command::needsWholeRadio);

    public final FakePort port;
    public final PacketLine line = new PacketLine(this);
    public final Mailbox mail = new Mailbox(line::changed);
    public final Keys keys = new Keys();
    final Percepts percepts = new Percepts();
    /** All other requests: {@code act stop}, {@code radio 1}, {@code ROMA tell;help} for a message. */
    public final BlockingQueue<String> requests = new LinkedBlockingQueue<>();

    /** The refusals that wait, by the requests' beginnings. */
    private final Map<String, Refusal> refusals = new ConcurrentHashMap<>();
    private final Map<String, List<Bytes>> effects = new ConcurrentHashMap<>();
    private final Map<String, Integer> transmissions = new ConcurrentHashMap<>();
    private final Map<Counter, Long> counters = new ConcurrentSkipListMap<>();
    private final Map<Counter, Long> rises = new ConcurrentHashMap<>();
    private final AtomicInteger messageIds = new AtomicInteger();
    private final Map<String, Integer> numbers = new ConcurrentHashMap<>();
    private volatile List<String> actions = List.of();
    private volatile int actionBytesInAReply = 500;
    private volatile String stallsAt;
    private volatile String swallows;
    private volatile Outcome everyOutcome;
    private volatile String rfId = Address.SERIAL.toString();
    private volatile int version = 1;
    private volatile String firmware = "fake";
    private volatile Set<Capability> capabilities =
            EnumSet.of(Capability.RADIO, Capability.MEMORY, Capability.SAYS_TAKEN);
    private volatile int pollFlags;
    private volatile boolean greeted;
    private volatile int transmissionCount;
    private volatile FakeAir air;
    private volatile boolean radioOpen;
    /** The numbers of transmissions that have not ended. */
    private final Set<Integer> underWay = ConcurrentHashMap.newKeySet();
    private int relays;

    /** The content of its EEPROM. */
    public record Eeprom(String rfId, Keys.Image keys) {

        /** The check values of its keys. */
        public Set<Bytes> checks() {
            return keys.checks();
        }
    }

    private record Refusal(Status status, AtomicInteger times) {
    }

    public FakeBoard() {
        this("fake");
    }

    public FakeBoard(String name) {
        port = new FakePort(name, 0, line);
    }

    private static String letters(Predicate<Request.Command> which) {
        return Stream.of(Request.Command.values()).filter(which).map(each -> String.valueOf(each.letter()))
                .collect(Collectors.joining());
    }

    // Requests, one at a time.

    /** The reply's message; null for a poll, whose reply may be held. */
    Bytes perform(Frame frame) {
        Bytes message = frame.message();
        boolean isCommand = frame.destination().equals(Address.SERIAL) && message.length() > 0;
        int command = isCommand ? message.at(0) : 0;
        if (command == 'H') {
            return greet();
        }
        if (!greeted) {
            return status(Status.NOT_GREETED);
        }
        if (command == 'P') {
            prepare(new Poll(message));
            if ("poll".equals(stallsAt)) {
                line.stall();
            }
            return null;
        }
        if (!capabilities.contains(Capability.RADIO) && (!isCommand || RADIOS.indexOf(command) >= 0)) {
            requests.add("of a radio");
            return status(Status.NO_RADIO);
        }
        if (capabilities.contains(Capability.UNICASTS_ONLY) && (isCommand ? WHOLE_RADIOS.indexOf(command) >= 0
                : frame.destination().kind() != Address.Kind.DEVICE)) {
            requests.add("of a whole radio");
            return status(Status.UNICASTS_ONLY);
        }
        String request = isCommand ? describe(command, message) : frame.destination() + " " + contentOf(message);
        if (!isCommand) {
            // The count is there before others can see the request, and end it.
            transmissions.put(request, transmissionCount);
        }
        Status refusal = log(request);
        if (refusal != Status.OK) {
            return status(refusal);
        }
        return frame.destination().equals(Address.SERIAL) ? perform(command, message)
                : frame.origin().toString().equals(rfId) ? transmit(frame) : status(Status.WRONG_ORIGIN);
    }

    private static String describe(int command, Bytes message) {
        String address = Keys.addressIn(message);
        return switch (command) {
            case 'A' -> "act " + textOf(message.from(1));
            case 'C' -> "list actions";
            case 'D' -> "delete key " + address;
            case 'E' -> "epoch " + message.number(1, 4);
            case 'F' -> "finish renewal " + address;
            case 'I' -> "id " + address;
            case 'K' -> "key " + address;
            case 'L' -> "list keys";
            case 'N' -> "renew key " + address;
            case 'O' -> "overhear " + message.at(1);
            case 'R' -> "radio " + message.at(1);
            case 'S' -> "statistics";
            case 'U' -> "use key " + address;
            case 'V' -> "session key " + address;
            case 'W' -> "relaying" + (message.length() > 1 ? " " + message.at(1) : "");
            case 'Y' -> "relay " + message.from(1).hex();
            default -> "unknown";
        };
    }

    private Status log(String request) {
        if (!READS.contains(request)) {
            requests.add(request);
        }
        if (request.equals(swallows)) {
            line.setSilent(true);
        }
        // Conversations have a random id.
        String stalling = stallsAt;
        if (stalling != null && request.replaceFirst("#...;", ";").startsWith(stalling)) {
            line.stall();
        }
        if (effects.containsKey(request)) {
            percepts.set(effects.get(request));
        }
        return refusals.entrySet().stream()
                .filter(each -> request.startsWith(each.getKey()) && each.getValue().times.getAndDecrement() > 0)
                .map(each -> each.getValue().status).findFirst().orElse(Status.OK);
    }

    private Bytes perform(int command, Bytes message) {
        return switch (command) {
            case 'A' -> act(textOf(message.from(1)));
            case 'C' -> listActions((int) message.number(1, 3));
            case 'E' -> underWay.isEmpty() ? keys.perform(command, "", message) : status(Status.BUSY);
            case 'I' -> setId(Keys.addressIn(message));
            case 'O' -> ok();
            case 'R' -> {
                radioOpen = message.at(1) == 1;
                yield ok();
            }
            case 'S' -> statistics();
            case 'W' -> relaying(message.from(1));
            case 'Y' -> transmit();
            default -> {
                Bytes reply = keys.perform(command, Keys.addressIn(message), message);
                yield reply == null ? status(Status.UNKNOWN_COMMAND) : reply;
            }
        };
    }

    private Bytes greet() {
        mail.hostArrived();
        percepts.forgetReading();
        greeted = true;
        boolean remembers = capabilities.contains(Capability.MEMORY);
        return Bytes.join(Bytes.of(0, version), Bytes.ofText(rfId), Bytes.ofNumber(remembers ? keys.epoch() : 0, 3),
                saysTaken() ? Bytes.of(Capability.encode(capabilities)) : Bytes.EMPTY, Bytes.ofText(firmware));
    }

    /** Whether it sends a 0x00 for each request that it has taken. */
    boolean saysTaken() {
        return capabilities.contains(Capability.SAYS_TAKEN);
    }

    private void prepare(Poll poll) {
        mail.take(poll);
        if (poll.lostReply() || !poll.wantsPercepts()) {
            percepts.forgetReading();
        }
    }

    /** The reply's message to a poll; null if it is to be held. */
    Bytes answer(Poll poll, boolean over) {
        int flags = pollFlags;
        if (mail.isWaiting()) {
            return mail.tell(flags);
        }
        if (percepts.nanosUntilReading(poll) == 0) {
            return percepts.tell(flags);
        }
        return over ? Bytes.of(0, flags) : null;
    }

    private Bytes act(String action) {
        boolean known = actions.isEmpty() || actions.contains(action.split("\\(")[0]);
        Integer number = numbers.get(action);
        return !known ? status(Status.UNKNOWN_ACTION)
                : number == null ? ok() : ok(Bytes.ofNumber(number & 0xFFFFFF, 3));
    }

    private Bytes listActions(int offset) {
        Bytes names = Bytes.ofText(String.join("", actions.stream().map(name -> name + "\0").toList()));
        int end = Math.min(names.length(), offset + actionBytesInAReply);
        return Bytes.join(Bytes.of(0, actions.size()), names.slice(Math.min(offset, end), end));
    }

    private Bytes setId(String id) {
        rfId = id;
        return ok();
    }

    private Bytes relaying(Bytes wish) {
        relays = wish.length() == 0 ? relays : wish.at(0);
        return ok(Bytes.of(relays));
    }

    private Bytes transmit(Frame frame) {
        if (air == null) {
            return transmit();
        }
        int number = transmissionCount;
        Status status = air.send(this, frame.destination(), frame.message(), outcome -> mail.end(number, outcome));
        transmissionCount = status == Status.OK ? number + 1 & 0xFF : number;
        return status == Status.OK ? ok(Bytes.of(number)) : status(status);
    }

    private Bytes transmit() {
        int number = transmissionCount;
        transmissionCount = number + 1 & 0xFF;
        underWay.add(number);
        if (everyOutcome != null) {
            end(number, everyOutcome);
        }
        return ok(Bytes.of(number));
    }

    private Bytes statistics() {
        rises.forEach((counter, by) -> counters.merge(counter, by, Long::sum));
        return ok(counters.entrySet().stream()
                .map(each -> Bytes.join(Bytes.of(each.getKey().number()), Bytes.ofNumber(each.getValue(), 4)))
                .toArray(Bytes[]::new));
    }

    static Bytes ok(Bytes... body) {
        return Bytes.join(Stream.concat(Stream.of(status(Status.OK)), Arrays.stream(body)).toArray(Bytes[]::new));
    }

    static Bytes status(Status status) {
        return Bytes.of(status.ordinal());
    }

    private static String textOf(Bytes bytes) {
        return new String(bytes.toArray(), StandardCharsets.UTF_8);
    }

    private static String contentOf(Bytes message) {
        boolean isHostMessage = message.length() > 0 && message.at(0) >= 0x80;
        return isHostMessage ? message.hex() : textOf(message);
    }

    // The air.

    /** Shares this air with others from now on: what it transmits comes to them, as far as they have its key. */
    public FakeBoard join(FakeAir shared) {
        air = shared;
        shared.join(this);
        return this;
    }

    /** Is on that air no more. */
    public void leave() {
        air.leave(this);
    }

    void hear(Address origin, Bytes content) {
        if (radioOpen) {
            mail.receive(Address.BROADCAST.toString(), origin.toString(), 0, content);
        }
    }

    Keys.Heard hear(FakeAir.Sealed message) {
        if (!radioOpen || rfId.equals(Address.SERIAL.toString())) {
            return Keys.Heard.REFUSED;
        }
        String origin = message.origin().toString();
        String destination = message.destination().toString();
        Keys.Heard heard = keys.hear(message, Address.parse(rfId));
        if (heard == Keys.Heard.TAKEN) {
            int id = (int) (message.nonce() >> 8 & 0xFF0000 | message.nonce() & 0xFFFF);
            mail.receive(destination, origin, id, message.content());
        } else if (heard == Keys.Heard.NO_KEY) {
            mail.receiveWithoutKey(destination, origin);
        }
        return heard;
    }

    /** The content of its EEPROM, to be {@link #load}ed later, perhaps by another board. */
    public Eeprom eeprom() {
        return new Eeprom(rfId, keys.image());
    }

    /** Loses power, and boots with this in its EEPROM. */
    public void load(Eeprom eeprom) {
        synchronized (line) {
            rfId = eeprom.rfId;
            keys.load(eeprom.keys);
            reset();
        }
    }

    // The script, at any time.

    public FakeBoard unplug() {
        port.unplug();
        return this;
    }

    /** Perceives these literals from now on. */
    public FakeBoard perceive(String... literals) {
        return perceiveBytes(Arrays.stream(literals).map(Bytes::ofText).toArray(Bytes[]::new));
    }

    /** Perceives these literals, which need be no text. */
    public FakeBoard perceiveBytes(Bytes... literals) {
        percepts.set(List.of(literals));
        line.changed();
        return this;
    }

    /** Perceives these literals from this request on. */
    public FakeBoard perceiveAfter(String request, String... literals) {
        effects.put(request, Arrays.stream(literals).map(Bytes::ofText).toList());
        return this;
    }

    /** Has these actions and no others; without names, all actions and no list of them. */
    public FakeBoard setActions(String... names) {
        actions = List.of(names);
        return this;
    }

    /** Tells so many bytes of the names of actions in a reply. */
    public void setActionBytesInAReply(int most) {
        actionBytesInAReply = most;
    }

    /** Refuses each request that begins so. */
    public FakeBoard refuse(String beginning, Status status) {
        return refuse(beginning, status, Integer.MAX_VALUE);
    }

    /** Refuses the next requests that begin so. */
    public FakeBoard refuse(String beginning, Status status, int times) {
        refusals.put(beginning, new Refusal(status, new AtomicInteger(times)));
        return this;
    }

    /** Refuses each action of these arguments, and prints why. */
    public FakeBoard refuseAction(String action, String reason) {
        line.setSays(action, reason);
        return refuse("act " + action, Status.ACTION_FAILED);
    }

    /** Returns this number from that action. */
    public FakeBoard returns(String action, int number) {
        numbers.put(action, number);
        return this;
    }

    /** Falls silent at this request. */
    public void swallow(String request) {
        swallows = request;
    }

    /** Stalls at each request that begins so, or at each {@code poll}, until {@link #resume}. */
    public void stallAt(String beginning) {
        stallsAt = beginning;
    }

    /** Answers the request at which the board stalls, and stalls no more. */
    public void resume() {
        stallsAt = null;
        line.resume();
    }

    /** Ends each transmission at once. */
    public FakeBoard endAll(Outcome outcome) {
        everyOutcome = outcome;
        return this;
    }

    /** Ends the last transmission of this message. */
    public void end(String request, Outcome outcome) {
        end(transmissions.get(request), outcome);
    }

    /** Ends the last transmission. */
    public void endLast(Outcome outcome) {
        end(transmissionCount - 1 & 0xFF, outcome);
    }

    /** Ends the transmission of this number, even if there is none. */
    public void end(int number, Outcome outcome) {
        underWay.remove(number);
        mail.end(number, outcome);
    }

    /** Receives a broadcast of ROMA. */
    public void receive(String content) {
        receive("////", "ROMA", content);
    }

    /** Receives a message, with an id of its own if it is no broadcast. */
    public void receive(String destination, String origin, String content) {
        receive(destination, origin, destination.equals("////") ? 0 : messageIds.incrementAndGet(), content);
    }

    public void receive(String destination, String origin, int id, String content) {
        mail.receive(destination, origin, id, Bytes.ofText(content));
    }

    /** Receives the bytes of a plain host message of ROMA. */
    public void receiveHostMessage(Bytes message) {
        mail.receive("////", "ROMA", 0, message);
    }

    /** Boots anew: it must be greeted, and offers again the messages that were not taken. */
    public void reset() {
        synchronized (line) {
            greeted = false;
            radioOpen = false;
            transmissionCount = 0;
            underWay.clear();
            keys.boot();
            mail.boot();
            percepts.forgetReading();
            line.boot();
        }
    }

    /** Loses RF id and keys, and counts its boots anew. */
    public void eraseEeprom() {
        keys.erase();
        rfId = Address.SERIAL.toString();
    }

    public FakeBoard setRfId(String id) {
        rfId = id;
        return this;
    }

    public String rfId() {
        return rfId;
    }

    /** Is another board: one of an earlier library, say, or without a radio. */
    public FakeBoard setCapabilities(Capability... all) {
        capabilities = Set.of(all);
        return this;
    }

    public void setFirmware(String name) {
        firmware = name;
    }

    public void setVersion(int newVersion) {
        version = newVersion;
    }

    /** Reports that the memory of nonces did not hold. */
    public void setDamaged() {
        pollFlags |= Poll.DAMAGED;
    }

    /** Reports that another part of the sketch uses the radio's timer, 0…5. */
    public void setTakenTimer(int timer) {
        pollFlags |= timer + 1 << Poll.TAKEN_TIMER_SHIFT;
    }

    public FakeBoard setCounter(Counter counter, long value) {
        counters.put(counter, value);
        return this;
    }

    /** Raises a counter by so much before each time that it is asked for. */
    public void setRise(Counter counter, long by) {
        rises.put(counter, by);
    }
}
