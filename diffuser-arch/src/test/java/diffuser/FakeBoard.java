package diffuser;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicInteger;

import javino.link.InMemoryLink;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Counter;
import javino.protocol.Frame;
import javino.protocol.Outcome;
import javino.protocol.SerialPacket;
import javino.protocol.PacketDecoder;
import javino.protocol.Reply;
import javino.protocol.Status;

/** A board in memory that speaks SPEC 4, does as scripted, and records what it was asked. */
final class FakeBoard implements LinkOpener {

    /** No test lasts so long. */
    private static final Duration LONG = Duration.ofMinutes(10);
    /** In the body of a poll, and of its flags and its reply's (SPEC 4.3). */
    private static final int TAKEN_AT = 6;
    private static final int WANTED = 1;
    private static final int AT_ONCE = 2;
    private static final int READING = 4;
    /** The most outcomes in a poll reply. */
    private static final int MOST_OUTCOMES = 32;

    /** All requests but polls, hellos, statistics and lists of keys: {@code A stop}, {@code //SU tell;x}. */
    final BlockingQueue<String> requests = new LinkedBlockingQueue<>();
    private final String port;
    private final Map<String, Status> refusals = new ConcurrentHashMap<>();
    private final List<Message> messages = new CopyOnWriteArrayList<>();
    private final Map<String, Integer> transmissions = new ConcurrentHashMap<>();
    private final Queue<Bytes> outcomes = new ConcurrentLinkedQueue<>();
    private final Map<String, List<String>> effects = new ConcurrentHashMap<>();
    private volatile List<String> percepts = List.of();
    private volatile List<String> actions = List.of();
    private volatile Address rfId = Address.SERIAL;
    private final List<Bytes> keys = new CopyOnWriteArrayList<>();
    private volatile boolean plugged = true;
    private volatile boolean silent;
    private volatile String swallowed = "";
    private volatile String held;
    private volatile CountDownLatch released = new CountDownLatch(0);
    private volatile Outcome everyOutcome;
    private volatile Status everyRefusal = Status.OK;
    private volatile boolean hearing;
    private volatile boolean uncounting;
    private long packetsHeard;
    private volatile boolean greeted;
    private volatile int boots = 1;
    private volatile int transmissionCount;
    private volatile Link link;
    private volatile Bytes lastRequest;
    private volatile Bytes lastReply;
    private volatile SerialPacket heldPoll;
    private long heldSince;
    /** What it told last that it perceives; null if nothing since it was greeted. */
    private List<String> reading;
    private long readAt;
    private int messageCount;
    private final AtomicInteger openLinks = new AtomicInteger();
    private final AtomicInteger mostOpen = new AtomicInteger();
    private final CountDownLatch closing = new CountDownLatch(1);
    private volatile CountDownLatch mayClose = new CountDownLatch(0);

    private record Message(int number, String destination, String origin, String content) {

        Bytes value() {
            int id = destination.equals("////") ? 0 : number + 1;
            return Bytes.join(Bytes.of(number), Bytes.ofText(destination + origin), Bytes.ofNumber(id, 3),
                    Bytes.ofText(content));
        }
    }

    FakeBoard(String port) {
        this.port = port;
    }

    @Override
    public String name() {
        return port;
    }

    @Override
    public Link open() throws LinkException {
        if (!plugged) {
            throw new LinkException(port, "there is no such port");
        }
        if (openLinks.get() > 0) {
            throw new LinkException(port, "another program is using it");
        }
        InMemoryLink.Pair pair = InMemoryLink.pair(port);
        link = pair.board();
        Thread thread = new Thread(() -> serve(pair.board()), "fake board " + port);
        thread.setDaemon(true);
        thread.start();
        mostOpen.accumulateAndGet(openLinks.incrementAndGet(), Math::max);
        return new Opened(pair.host());
    }

    /** The host's end, of which the board knows whether it is open. */
    private final class Opened implements Link {

        private final Link line;

        Opened(Link line) {
            this.line = line;
        }

        @Override
        public void write(byte[] bytes) throws LinkException {
            line.write(bytes);
        }

        @Override
        public int read(byte[] into, Duration timeout) throws LinkException {
            return line.read(into, timeout);
        }

        @Override
        public void wake() {
            line.wake();
        }

        @Override
        public void close() {
            closing.countDown();
            awaitUninterrupted(mayClose);
            line.close();
            openLinks.decrementAndGet();
        }
    }

    private static void awaitUninterrupted(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    // The script

    FakeBoard perceiving(String... literals) {
        percepts = List.of(literals);
        wake();
        return this;
    }

    /** As soon as it has been asked for this, it perceives that. */
    FakeBoard perceivingAfter(String request, String... literals) {
        effects.put(request, List.of(literals));
        return this;
    }

    /** Its sketch has these actions, and no others; without them it tells of none and does all. */
    FakeBoard knowing(String... names) {
        actions = List.of(names);
        return this;
    }

    FakeBoard refusing(String request, Status status) {
        refusals.put(request, status);
        return this;
    }

    /** All transmissions are refused. */
    FakeBoard refusingAll(Status status) {
        everyRefusal = status;
        return this;
    }

    /** From here on every transmission ends at once, and so. */
    FakeBoard endingAll(Outcome outcome) {
        everyOutcome = outcome;
        return this;
    }

    /** The transmission that was asked for last with this request ends so. */
    void end(String request, Outcome outcome) {
        end(transmissions.get(request), outcome);
    }

    /** The transmission that was asked for last ends so. */
    void endLast(Outcome outcome) {
        end(transmissionCount - 1 & 0xFF, outcome);
    }

    /** A transmission ends, whoever has asked for it. */
    void end(int number, Outcome outcome) {
        outcomes.add(Bytes.of(number, outcome.ordinal()));
        wake();
    }

    /** The board boots: it knows nothing of what was under way, and wants to be greeted. */
    void reset() {
        greeted = false;
        boots++;
        transmissionCount = 0;
        outcomes.clear();
    }

    /** From here on the board answers nothing, or again everything. */
    void silent(boolean now) {
        silent = now;
    }

    /** When this request comes, the board records it and falls silent. */
    void swallow(String request) {
        swallowed = request;
    }

    /** Each request that begins so is recorded, and answered only after {@link #release}. */
    void hold(String request) {
        held = request;
        released = new CountDownLatch(1);
    }

    /** What is held is answered. */
    void release() {
        held = null;
        released.countDown();
    }

    /** From here on there is a packet for somebody in the air whenever the board is asked for its counters, or none. */
    FakeBoard hearing(boolean now) {
        hearing = now;
        return this;
    }

    /** The board has no counters. */
    FakeBoard uncounting() {
        uncounting = true;
        return this;
    }

    /** It comes with a key. */
    FakeBoard withKey(String address, Reply.Role role) {
        keys.add(Bytes.join(Bytes.ofText(address), Bytes.of(role.ordinal(), 1, 2, 3)));
        return this;
    }

    /** It comes with this address. */
    FakeBoard withRfId(String id) {
        rfId = Address.parse(id);
        return this;
    }

    void unplug() {
        plugged = false;
        Link open = link;
        if (open != null) {
            open.close();
        }
    }

    /** It does nothing more, and lets go of whoever waits for it. */
    void discard() {
        closesSlowly(false);
        released.countDown();
        unplug();
    }

    FakeBoard unplugged() {
        unplug();
        return this;
    }

    void plug() {
        plugged = true;
    }

    /** Whether the port is not left from here on until this is taken back. */
    void closesSlowly(boolean now) {
        mayClose.countDown();
        mayClose = new CountDownLatch(now ? 1 : 0);
    }

    /** Waits until somebody closes the port. */
    void awaitClosing() {
        awaitUninterrupted(closing);
    }

    /** How many had the port open at the same time. */
    int mostOpenAtOnce() {
        return mostOpen.get();
    }

    synchronized void receive(String destination, String origin, String content) {
        messages.add(new Message(messageCount++ & 0xFF, destination, origin, content));
        wake();
    }

    Address rfId() {
        return rfId;
    }

    // The protocol

    private void serve(Link line) {
        PacketDecoder decoder = new PacketDecoder();
        byte[] buffer = new byte[1024];
        heldPoll = null;
        try {
            while (true) {
                int count = line.read(buffer, heldPoll == null ? LONG : untilTold(heldPoll));
                List<PacketDecoder.Result> results = decoder.feed(buffer, count);
                if (heldPoll != null) {
                    write(line, pollReply(heldPoll, count > 0));
                }
                for (PacketDecoder.Result result : results) {
                    if (!silent && result instanceof PacketDecoder.Found found) {
                        write(line, answer(found.packet()));
                    }
                }
            }
        } catch (LinkException e) {
            // The host has closed the port, or the test has unplugged it.
            return;
        }
    }

    private void write(Link line, Bytes answer) throws LinkException {
        if (answer != null && !silent) {
            line.write(answer.toArray());
        }
    }

    /** The answer; null where it is held. */
    private Bytes answer(SerialPacket request) {
        Bytes encoded = request.encode();
        if (encoded.equals(lastRequest)) {
            return lastReply;
        }
        Frame frame = request.frame();
        if (greeted && frame.destination().equals(Address.SERIAL) && frame.message().at(0) == 'P') {
            takePoll(frame.message().from(1));
            heldSince = System.nanoTime();
            heldPoll = request;
            return pollReply(request, false);
        }
        return remember(request, reply(frame));
    }

    private Bytes remember(SerialPacket request, Bytes message) {
        heldPoll = null;
        lastRequest = request.encode();
        lastReply = new SerialPacket(request.sequence(), new Frame(Address.SERIAL, Address.SERIAL, message)).encode();
        return lastReply;
    }

    private Bytes reply(Frame request) {
        boolean toBoard = request.destination().equals(Address.SERIAL);
        if (toBoard && request.message().at(0) == 'H') {
            return hello();
        }
        if (!greeted) {
            return Bytes.of(Status.NOT_GREETED.ordinal());
        }
        if (!toBoard) {
            return transmit(request.destination() + " " + text(request.message()));
        }
        Bytes body = request.message().from(1);
        return switch (request.message().at(0)) {
            case 'A' -> act(text(body));
            case 'C' -> ok(actions((int) body.number(0, 2)));
            case 'R' -> recorded("R " + (body.at(0) == 1 ? "open" : "block"), Bytes.EMPTY);
            case 'I' -> setRfId(text(body));
            case 'L' -> ok(Bytes.join(keys.toArray(Bytes[]::new)));
            case 'S' -> statistics();
            default -> Bytes.of(Status.UNKNOWN_COMMAND.ordinal());
        };
    }

    private Bytes act(String action) {
        boolean known = actions.isEmpty() || actions.contains(action.split("\\(")[0]);
        Bytes reply = recorded("A " + action, Bytes.EMPTY);
        return known ? reply : Bytes.of(Status.UNKNOWN_ACTION.ordinal());
    }

    private Bytes actions(int offset) {
        Bytes names = Bytes.ofText(String.join("", actions.stream().map(name -> name + "\0").toList()));
        return Bytes.join(Bytes.of(actions.size()), names.from(Math.min(offset, names.length())));
    }

    private Bytes hello() {
        greeted = true;
        reading = null;
        return ok(Bytes.join(Bytes.of(1), rfId.toBytes(), Bytes.ofNumber(boots, 3), Bytes.ofText("fake")));
    }

    private Bytes transmit(String request) {
        int number = transmissionCount;
        transmissions.put(request, number);
        Bytes reply = recorded(request, Bytes.of(number));
        if (everyRefusal != Status.OK) {
            return Bytes.of(everyRefusal.ordinal());
        }
        if (reply.at(0) == Status.OK.ordinal()) {
            transmissionCount = number + 1 & 0xFF;
            if (everyOutcome != null) {
                end(number, everyOutcome);
            }
        }
        return reply;
    }

    private Bytes setRfId(String id) {
        Bytes reply = recorded("I " + id, Bytes.EMPTY);
        if (reply.at(0) == Status.OK.ordinal()) {
            rfId = Address.parse(id);
        }
        return reply;
    }

    private Bytes recorded(String request, Bytes body) {
        if (request.equals(swallowed)) {
            silent = true;
        }
        requests.add(request);
        String waited = held;
        if (waited != null && request.replaceFirst("#...;", ";").startsWith(waited)) {
            awaitUninterrupted(released);
        }
        percepts = effects.getOrDefault(request, percepts);
        Status status = refusals.getOrDefault(request, Status.OK);
        return status == Status.OK ? ok(body) : Bytes.of(status.ordinal());
    }

    private Bytes statistics() {
        if (uncounting) {
            return Bytes.of(Status.UNKNOWN_COMMAND.ordinal());
        }
        packetsHeard += hearing ? 1 : 0;
        return ok(Bytes.join(Bytes.of(Counter.RADIO_RECEIVED.number()), Bytes.ofNumber(packetsHeard, 4)));
    }

    private void takePoll(Bytes body) {
        if (body.length() > TAKEN_AT) {
            messages.removeIf(message -> message.number() == body.at(TAKEN_AT));
        }
        if ((body.at(0) & WANTED) == 0) {
            reading = null;
        }
    }

    /** How long nothing is to be done about a poll unless something happens. */
    private Duration untilTold(SerialPacket poll) {
        Bytes body = poll.frame().message().from(1);
        long end = heldSince + millis(body.number(1, 3));
        long mayTell = readAt + millis(body.number(3, 6));
        boolean waits = (body.at(0) & WANTED) != 0 && !percepts.equals(reading);
        long next = waits ? Math.min(end, mayTell) : end;
        return Duration.ofNanos(Math.max(1, next - System.nanoTime()));
    }

    private static long millis(long milliseconds) {
        return Duration.ofMillis(milliseconds).toNanos();
    }

    /** Has the board look whether it has something to tell. */
    private void wake() {
        Link open = link;
        if (open != null) {
            open.wake();
        }
    }

    /** The reply to a poll, or null while there is nothing to tell and it may be held. */
    private Bytes pollReply(SerialPacket poll, boolean byteCame) {
        Bytes body = poll.frame().message().from(1);
        List<Bytes> parts = new ArrayList<>();
        for (int i = 0; i < MOST_OUTCOMES && !outcomes.isEmpty(); i++) {
            parts.add(record('T', outcomes.remove()));
        }
        messages.stream().limit(1).forEach(message -> parts.add(record('M', message.value())));
        int flags = 0;
        List<String> now = percepts;
        if (parts.isEmpty() && (body.at(0) & WANTED) != 0 && isToBeTold(body, now)) {
            reading = now;
            readAt = System.nanoTime();
            flags = READING;
            now.forEach(literal -> parts.add(record('P', Bytes.ofText(literal))));
        }
        boolean over = byteCame || System.nanoTime() - heldSince >= millis(body.number(1, 3));
        if (parts.isEmpty() && flags == 0 && !over) {
            return null;
        }
        parts.add(0, Bytes.of(flags));
        return remember(poll, ok(Bytes.join(parts.toArray(Bytes[]::new))));
    }

    private boolean isToBeTold(Bytes body, List<String> now) {
        return reading == null || (body.at(0) & AT_ONCE) != 0
                || !now.equals(reading) && System.nanoTime() - readAt >= millis(body.number(3, 6));
    }

    private static Bytes record(char type, Bytes value) {
        return Bytes.join(Bytes.of(type), Bytes.ofNumber(value.length(), 2), value);
    }

    private static Bytes ok(Bytes body) {
        return Bytes.join(Bytes.of(Status.OK.ordinal()), body);
    }

    private static String text(Bytes bytes) {
        return new String(bytes.toArray(), StandardCharsets.UTF_8);
    }
}
