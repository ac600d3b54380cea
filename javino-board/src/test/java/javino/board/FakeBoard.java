package javino.board;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import javino.link.InMemoryLink;
import javino.link.LinkException;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Counter;
import javino.protocol.Frame;
import javino.protocol.Key;
import javino.protocol.Outcome;
import javino.protocol.SerialPacket;
import javino.protocol.PacketDecoder;
import javino.protocol.PollReply;
import javino.protocol.Status;
import javino.protocol.HostMessage;

/**
 * A board as SPEC 4.2 and 4.3 want it, at the far end of an in-memory link, with faults to order.
 * It answers on a thread of its own, which ends with the link, and holds its replies to polls.
 */
public final class FakeBoard {

    private static final Bytes ACCEPTED = Bytes.of(0);
    /** A board that was booted so often stays there (SPEC 5.1). */
    private static final int MAX_BOOT_EPOCH = 0xFFFFFF;

    /**
     * What ends a Mega's boot loader: start, sequence 1, length 1, token, CMD_LEAVE_PROGMODE_ISP, exclusive or of all.
     */
    private static final String LEAVE_PROGRAMMING = "1b" + "01" + "0001" + "0e" + "11" + "04";

    /** What the boot loader answers to that: length 2, CMD_LEAVE_PROGMODE_ISP, STATUS_CMD_OK. */
    private static final Bytes PROGRAMMING_LEFT = Bytes.of(0x1B, 0x01, 0x00, 0x02, 0x0E, 0x11, 0x00, 0x07);

    /** How often it looks whether it has something to tell, while nobody says so. */
    private static final Duration TICK = Duration.ofMillis(10);

    private final List<String> performed = new ArrayList<>();

    private final List<String> percepts = new ArrayList<>();
    private final List<String> requests = new ArrayList<>();
    private final List<String> actions = new ArrayList<>();
    private int actionBytesInAReply = 500;
    private Status listing = Status.OK;
    private final FakeMail mail = new FakeMail();
    private final Set<String> doubted = new HashSet<>();
    private final Map<Counter, Long> counters = new EnumMap<>(Map.of(Counter.SERIAL_REQUESTS, 9L));
    private final Map<Counter, Long> rises = new EnumMap<>(Counter.class);
    private int transmissions;
    private int relays;
    private Outcome ends;
    private Status refusal;
    private String rfId = "++++";
    private int version = 1;
    private String firmware = "fake";
    private int bootEpoch = 1;
    private boolean greeted;
    private boolean silent;
    private boolean loading;
    private boolean corruptsKeys;
    private boolean badPolls;
    private int busy;
    private final Map<String, StoredKeys> keys = new LinkedHashMap<>(Map.of("SUPO", new StoredKeys(Bytes.of(1, 2, 3))));
    /** The check values of all session keys since the boot. */
    private final Set<Bytes> sessionKeys = new HashSet<>();
    private int hellos;
    private int polls;
    private Fault fault = reply -> reply;
    private Predicate<Bytes> loses = message -> false;
    private Bytes lastRequest = Bytes.EMPTY;
    private Bytes lastReply = Bytes.EMPTY;
    private SerialPacket held;
    private long heldSince;
    private int deaf;
    private boolean haltsReadings;
    /** The end of a reading: its last byte waits for the host's next one. */
    private Bytes rest = Bytes.EMPTY;
    private boolean booted;

    /** Changes the bytes of a reply on their way. */
    interface Fault {
        Bytes apply(Bytes reply);
    }

    /** Serves the board's end of a link until it is closed. */
    void serve(InMemoryLink link) {
        Thread thread = new Thread(() -> run(link), "fake board");
        thread.setDaemon(true);
        thread.start();
    }

    private void run(InMemoryLink link) {
        PacketDecoder decoder = new PacketDecoder();
        byte[] buffer = new byte[1024];
        try {
            while (true) {
                int count = link.read(buffer, TICK);
                if (isDeaf(count)) {
                    continue;
                }
                announce(count > 0, link);
                answerHeld(count > 0, link);
                if (isLoading(buffer, count, link)) {
                    continue;
                }
                for (PacketDecoder.Result result : decoder.feed(buffer, count)) {
                    answerHeld(true, link);
                    if (result instanceof PacketDecoder.Found found) {
                        answer(found.packet(), link);
                    }
                }
            }
        } catch (LinkException e) {
            // The link's end is the board's.
            return;
        }
    }

    private synchronized boolean isDeaf(int count) {
        boolean lost = count > 0 && deaf > 0;
        deaf -= lost ? 1 : 0;
        return lost;
    }

    /** The zero of a board that has booted, or the rest of a reading. */
    private synchronized void announce(boolean byteCame, InMemoryLink link) throws LinkException {
        if (booted) {
            booted = false;
            link.write(new byte[1]);
        }
        if (byteCame || rest.length() > 1) {
            int end = byteCame ? rest.length() : 1;
            link.write(rest.slice(0, end).toArray());
            rest = rest.from(end);
        }
    }

    /** Answers the poll that is held, if there is one and it is time. */
    private synchronized void answerHeld(boolean byteCame, InMemoryLink link) throws LinkException {
        if (held == null) {
            return;
        }
        FakeMail.Poll poll = FakeMail.Poll.of(held.frame().message());
        boolean over = byteCame || System.nanoTime() - heldSince >= poll.hold() * 1_000_000L;
        Bytes message = mail.answer(poll, percepts.stream()
                .map(percept -> Bytes.copyOf(percept.getBytes(StandardCharsets.ISO_8859_1))).toList(), over);
        if (message != null) {
            reply(held, message, link);
            held = null;
        }
    }

    /** Whether this is for the boot loader: what comes in one piece with its end is lost with it. */
    private synchronized boolean isLoading(byte[] buffer, int count, InMemoryLink link) throws LinkException {
        boolean wasLoading = loading;
        loading = loading && !Bytes.copyOf(buffer).slice(0, count).hex().contains(LEAVE_PROGRAMMING);
        if (wasLoading && !loading) {
            link.write(PROGRAMMING_LEFT.toArray());
        }
        return wasLoading;
    }

    private synchronized void answer(SerialPacket request, InMemoryLink link) throws LinkException {
        if (silent || loses.test(request.frame().message())) {
            return;
        }
        if (!request.encode().equals(lastRequest)) {
            requests.add(request.frame().message().hex());
            Bytes message = perform(request.frame());
            if (message == null) {
                held = request;
                heldSince = System.nanoTime();
                notifyAll();
                answerHeld(false, link);
            } else {
                reply(request, message, link);
            }
            return;
        }
        link.write(fault.apply(lastReply).toArray());
    }

    private void reply(SerialPacket request, Bytes message, InMemoryLink link) throws LinkException {
        lastReply = new SerialPacket(request.sequence(), new Frame(Address.SERIAL, Address.SERIAL, message)).encode();
        lastRequest = request.encode();
        Bytes bytes = fault.apply(lastReply);
        boolean halts = haltsReadings && isHolding(request.frame().message())
                && PollReply.isReading(request.sequence(), begun(bytes));
        int end = halts ? bytes.length() - 4 : bytes.length();
        rest = bytes.from(end);
        link.write(bytes.slice(0, end).toArray());
    }

    private static boolean isHolding(Bytes request) {
        return request.at(0) == 'P' && FakeMail.Poll.of(request).hold() > 0;
    }

    private static Bytes begun(Bytes reply) {
        PacketDecoder decoder = new PacketDecoder();
        decoder.feed(reply.toArray(), reply.length() - 1);
        return decoder.begun(PollReply.FLAGS_END);
    }

    /** The reply; null where it is held. */
    private Bytes perform(Frame frame) {
        Bytes message = frame.message();
        if (!frame.destination().equals(Address.SERIAL)) {
            return greeted ? transmit(frame) : status(Status.NOT_GREETED);
        }
        int command = message.at(0);
        if (command == 'H') {
            mail.hostArrived();
            greeted = true;
            hellos++;
            notifyAll();
            return Bytes.join(Bytes.of(0, version), Bytes.ofText(rfId), Bytes.ofNumber(bootEpoch, 3),
                    Bytes.ofText(firmware));
        }
        if (!greeted) {
            return status(Status.NOT_GREETED);
        }
        return switch (command) {
            case 'P' -> poll(message);
            case 'A' -> act(message);
            case 'C' -> listing == Status.OK ? listActions((int) message.number(1, 3)) : status(listing);
            case 'I' -> {
                rfId = new String(message.from(1).toArray(), StandardCharsets.UTF_8);
                yield record("id " + rfId, ACCEPTED);
            }
            case 'R' -> record("radio " + message.at(1), ACCEPTED);
            case 'O' -> record("overhear " + message.at(1), ACCEPTED);
            case 'Y' -> relay(message.from(1));
            case 'W' -> relaying(message.from(1));
            case 'E' -> raiseEpoch((int) message.number(1, 4));
            case 'K' -> store(message);
            case 'S' -> record("statistics", statistics());
            case 'N' -> renew(message);
            case 'U' -> use(addressIn(message));
            case 'F' -> finishRenewal(addressIn(message));
            case 'L' -> record("list", list());
            case 'D' -> forget(addressIn(message));
            case 'V' -> storeSession(message);
            default -> status(Status.UNKNOWN_COMMAND);
        };
    }

    private Bytes transmit(Frame frame) {
        return takeUp("transmit " + frame.header());
    }

    private Bytes relay(Bytes frame) {
        return takeUp("relay " + frame.hex());
    }

    private Bytes relaying(Bytes wish) {
        if (refusal != null) {
            return status(refusal);
        }
        relays = wish.length() == 0 ? relays : wish.at(0);
        return record("relaying " + relays, Bytes.of(0, relays));
    }

    private Bytes takeUp(String what) {
        if (refusal != null) {
            return status(refusal);
        }
        if (ends != null) {
            mail.end(transmissions & 0xFF, ends);
        }
        return record(what, Bytes.of(0, transmissions++));
    }

    private Bytes act(Bytes message) {
        String action = new String(message.from(1).toArray(), StandardCharsets.UTF_8);
        if (refusal != null) {
            return status(refusal);
        }
        return action.equals("unknown") ? status(Status.UNKNOWN_ACTION) : record(action, ACCEPTED);
    }

    private Bytes listActions(int offset) {
        Bytes names = Bytes.ofText(String.join("", actions.stream().map(name -> name + "\0").toList()));
        int end = Math.min(names.length(), offset + actionBytesInAReply);
        return Bytes.join(Bytes.of(0, actions.size()), names.slice(Math.min(offset, end), end));
    }

    /** The check values of an address's keys: what seals, and beside it a next or a previous one, or null. */
    private static final class StoredKeys {
        private Bytes current;
        private Bytes other;
        private boolean isNext;
        private boolean isSession;

        StoredKeys(Bytes current) {
            this.current = current;
        }
    }

    private static String addressIn(Bytes message) {
        return new String(message.slice(1, 1 + Address.LENGTH).toArray(), StandardCharsets.UTF_8);
    }

    private Bytes raiseEpoch(int epoch) {
        bootEpoch = Math.max(bootEpoch, epoch);
        return record("epoch " + epoch, ACCEPTED);
    }

    private Bytes store(Bytes message) {
        Bytes check = Key.of(message.from(1 + Address.LENGTH)).check();
        keys.put(addressIn(message), new StoredKeys(check));
        return record("key", Bytes.join(ACCEPTED, corruptsKeys ? Bytes.of(1, 2, 3) : check));
    }

    private Bytes storeSession(Bytes message) {
        String address = addressIn(message);
        StoredKeys before = keys.get(address);
        if (before != null && !before.isSession) {
            return status(Status.HAS_KEY);
        }
        Bytes check = Key.of(message.from(1 + Address.LENGTH)).check();
        if (before == null || !before.current.equals(check)) {
            if (sessionKeys.contains(check)) {
                return status(Status.BAD_ARGUMENT);
            }
            setSessionKey(address, check);
        }
        return record("session key " + address, Bytes.join(ACCEPTED, check));
    }

    private Bytes forget(String address) {
        return keys.remove(address) == null ? status(Status.NO_KEY) : record("forget " + address, ACCEPTED);
    }

    private Bytes renew(Bytes message) {
        StoredKeys stored = keys.get(addressIn(message));
        if (stored == null || stored.isSession || stored.other != null) {
            return status(stored == null || stored.isSession ? Status.NO_KEY : Status.BAD_ARGUMENT);
        }
        stored.other = Key.of(message.from(1 + Address.LENGTH)).check();
        stored.isNext = true;
        return record("renew", Bytes.join(ACCEPTED, stored.other));
    }

    private Bytes use(String address) {
        StoredKeys stored = keys.get(address);
        if (busy > 0) {
            busy--;
            return status(Status.BUSY);
        }
        if (stored == null || !stored.isNext) {
            return status(Status.NO_KEY);
        }
        Bytes before = stored.current;
        stored.current = stored.other;
        stored.other = before;
        stored.isNext = false;
        return record("use " + address, ACCEPTED);
    }

    private Bytes finishRenewal(String address) {
        StoredKeys stored = keys.get(address);
        if (stored == null || stored.other == null || stored.isNext) {
            return status(Status.NO_KEY);
        }
        stored.other = null;
        return record("finish " + address, ACCEPTED);
    }

    private Bytes list() {
        Bytes list = ACCEPTED;
        for (Map.Entry<String, StoredKeys> entry : keys.entrySet()) {
            Bytes address = Bytes.ofText(entry.getKey());
            StoredKeys stored = entry.getValue();
            int doubtful = doubted.contains(entry.getKey()) ? 4 : 0;
            list = Bytes.join(list, address, Bytes.of(stored.isSession ? 3 : doubtful), stored.current);
            if (stored.other != null) {
                list = Bytes.join(list, address, Bytes.of(stored.isNext ? 2 : 1), stored.other);
            }
        }
        return list;
    }

    private Bytes statistics() {
        rises.forEach((counter, by) -> counters.merge(counter, by, Long::sum));
        Bytes body = ACCEPTED;
        for (Map.Entry<Counter, Long> counter : counters.entrySet()) {
            body = Bytes.join(body, Bytes.of(counter.getKey().number()), Bytes.ofNumber(counter.getValue(), 4));
        }
        return body;
    }

    private Bytes poll(Bytes message) {
        polls++;
        notifyAll();
        if (badPolls) {
            return Bytes.of(0, 0, 'P');
        }
        if ((message.at(1) & 4) != 0) {
            mail.hostArrived();
        } else if ((message.at(1) & 8) == 0) {
            mail.replyArrived();
        }
        if (message.length() == 8) {
            mail.taken(message.at(7));
        }
        return null;
    }

    private Bytes record(String what, Bytes reply) {
        performed.add(what);
        notifyAll();
        return reply;
    }

    private static Bytes status(Status status) {
        return Bytes.of(status.ordinal());
    }

    public synchronized void setFirmware(String name) {
        firmware = name;
    }

    public synchronized void setVersion(int newVersion) {
        version = newVersion;
    }

    /** Has the board answer nothing, or again everything. */
    public synchronized void setSilent(boolean isSilent) {
        silent = isSilent;
    }

    /** Has so many of the host's writes get lost. */
    synchronized void setDeaf(int writes) {
        deaf = writes;
    }

    /** Has the boot loader wait for a sketch, and what runs there wait for its end. */
    public synchronized void setLoading() {
        loading = true;
    }

    /** Has each reading that a poll with a hold brings stop before its end until the host sends something. */
    public synchronized void setHaltsReadings(boolean halts) {
        haltsReadings = halts;
    }

    /** Has the board answer polls with half a record. */
    public synchronized void setBadPolls(boolean bad) {
        badPolls = bad;
    }

    /** Has the board answer wrong check values. */
    public synchronized void setCorruptsKeys(boolean corrupts) {
        corruptsKeys = corrupts;
    }

    /** Has its key for SUPO have this check value, 3 bytes. */
    public synchronized void setCheck(Bytes value) {
        keys.put("SUPO", new StoredKeys(value));
    }

    /** Has it have a session key of this check value, 3 bytes. */
    public synchronized void setSessionKey(String device, Bytes check) {
        sessionKeys.add(check);
        StoredKeys session = new StoredKeys(check);
        session.isSession = true;
        keys.put(device, session);
    }

    /** Has the board's EEPROM be erased: it knows neither id nor keys, and counts its boots anew. */
    public synchronized void eraseEeprom() {
        keys.clear();
        rfId = "++++";
        bootEpoch = 1;
    }

    /** Has the board find keys and no epoch, and floors missing of some keys. */
    public synchronized void loseEpoch(String... addresses) {
        bootEpoch = 0;
        doubted.addAll(List.of(addresses));
    }

    /** Has replies to polls say that the memory of nonces did not hold. */
    public synchronized void setDamaged() {
        mail.setDamaged();
    }

    /** Has a message be under way that so many times prevents the use of a key. */
    public synchronized void setBusy(int times) {
        busy = times;
    }

    public synchronized int bootEpoch() {
        return bootEpoch;
    }

    /** Has each reply pass through a fault. */
    synchronized void setFault(Fault newFault) {
        fault = newFault;
    }

    /** Has requests get lost whose message the predicate names. */
    synchronized void setLoses(Predicate<Bytes> lost) {
        loses = lost;
    }

    /** ISO 8859-1, so that percepts can be no UTF-8. */
    public synchronized void setPercepts(String... literals) {
        percepts.clear();
        percepts.addAll(List.of(literals));
    }

    /** Queues a message from ROMA to all. */
    void receive(String content) {
        receive("////", "ROMA", 0, content);
    }

    /** Queues a message; of a broadcast the id is 0. */
    public synchronized void receive(String destination, String origin, int id, String content) {
        mail.receive(destination, origin, id, Bytes.ofText(content));
    }

    /** Queues a plain host message. */
    synchronized void receive(HostMessage message) {
        mail.receive("////", "ROMA", 0, message.bytes());
    }

    /** Has a sealed frame come for which the board has no key. */
    public synchronized void receiveWithoutKey(String destination, String origin) {
        mail.receiveWithoutKey(destination, origin);
    }

    /** Has the board hear a packet. */
    synchronized void overhear(long millis, int how, Bytes payload) {
        mail.overhear(millis, how, payload);
    }

    /** Has the sketch name these actions. */
    public synchronized void setActions(String... names) {
        actions.clear();
        actions.addAll(List.of(names));
    }

    /** Has so many bytes of the names of actions fit a reply. */
    synchronized void setActionBytesInAReply(int most) {
        actionBytesInAReply = most;
    }

    /** Has list actions answered with this status. */
    synchronized void setListing(Status status) {
        listing = status;
    }

    /** Has the board say that its RF id is this; {@code ++++} for none, as at first. */
    public synchronized void setRfId(String id) {
        rfId = id;
    }

    public synchronized void setCounter(Counter counter, long value) {
        counters.put(counter, value);
    }

    /** Has a counter rise by so much before each time that it is asked for. */
    public synchronized void setRise(Counter counter, long by) {
        rises.put(counter, by);
    }

    /** Has each transmission end so at once. */
    public synchronized void setEnds(Outcome outcome) {
        ends = outcome;
    }

    /** Has the board refuse to act and to transmit. */
    public synchronized void setRefusal(Status status) {
        refusal = status;
    }

    /** Has a transmission end. */
    synchronized void end(int number, Outcome outcome) {
        mail.end(number, outcome);
    }

    public synchronized void setBootEpoch(int count) {
        bootEpoch = count;
    }

    /** Boots anew: it must be greeted, and what was not taken comes again. */
    public synchronized void reset() {
        greeted = false;
        bootEpoch = bootEpoch == 0 ? 0 : Math.min(bootEpoch + 1, MAX_BOOT_EPOCH);
        transmissions = 0;
        keys.values().removeIf(stored -> stored.isSession);
        sessionKeys.clear();
        mail.boot();
        held = null;
        booted = true;
        lastRequest = Bytes.EMPTY;
    }

    /** The requests that came, without repeats, each as the message's hexadecimal digits. */
    synchronized List<String> requests() {
        return List.copyOf(requests);
    }

    /** Waits until the host has taken all messages. */
    synchronized void awaitAllTaken() throws InterruptedException {
        while (!mail.isEmpty()) {
            wait();
        }
    }

    /** The commands that were performed, in order, as text; polls and hellos left out. */
    public synchronized List<String> performed() {
        return List.copyOf(performed);
    }

    /** Waits until it was polled so many times more. */
    synchronized void awaitPolls(int more) throws InterruptedException {
        int wanted = polls + more;
        while (polls < wanted) {
            wait();
        }
    }

    /** Waits until a poll is held. */
    synchronized void awaitHeld() throws InterruptedException {
        while (held == null) {
            wait();
        }
    }

    synchronized int hellos() {
        return hellos;
    }
}
