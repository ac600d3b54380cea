package gateway;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Supplier;
import javino.protocol.Address;
import javino.protocol.Airtime;
import javino.protocol.Bytes;
import javino.protocol.Frame;

/**
 * A radio cell in memory, at the pace of boards: one packet at a time is on the air, a device acknowledges what is for
 * it, and a sender repeats what nobody acknowledges. Nothing is sealed.
 */
final class PlayedCell implements Radio {

    /** The number of the device that has moved to the next cell and is silent there. */
    static final int MOVED = 19;
    static final int DEVICES = 20;
    private static final int NUMBERS = 64;
    private static final int CONTENT = 24;
    private static final int PROOF = 8;
    private static final int BITS = 0xFFF;
    private static final int ATTEMPTS = 8;
    private static final int QUICK_ATTEMPTS = 2;
    private static final long TURN_MILLIS = 30;
    private static final long PATIENCE_MILLIS = 500;
    private static final int BACKOFF_MILLIS = 300;

    private final int cell;
    private final Clock clock;
    private final Random random;
    private final Supplier<Address> destinations;
    private final Set<Address> here = new HashSet<>();
    /** By destination and last bits of the nonce. */
    private final Map<String, Sent> awaited = new HashMap<>();
    private final PlayedCount count = new PlayedCount();
    private Listener listener;
    private long free;
    private int nonce;

    private record Sent(Frame frame, String key) {
    }

    /** Time in ms, from any start. */
    interface Clock {

        long now();

        /** Does something in that time. */
        void schedule(Runnable what, long millis);
    }

    /** @param destinations those of messages to other cells. */
    PlayedCell(int cell, int cells, Clock clock, long seed, Supplier<Address> destinations) {
        this.cell = cell;
        this.clock = clock;
        this.destinations = destinations;
        random = new Random(seed + cell);
        nonce = random.nextInt(BITS);
        for (int i = 0; i < DEVICES; i++) {
            here.add(i == MOVED ? device((cell + cells - 1) % cells, MOVED) : device(cell, i));
        }
    }

    static Address device(int cell, int number) {
        return new Address(cell * NUMBERS + number);
    }

    PlayedCount count() {
        return count;
    }

    Radio open(Listener told) {
        listener = told;
        return this;
    }

    /** Each device is heard, and begins to send; the one that moves is heard here for the last time. */
    void begin(long meanMillis) {
        for (int i = 0; i < DEVICES; i++) {
            Address own = device(cell, i);
            clock.schedule(() -> say(own), random.nextInt(DEVICES * BACKOFF_MILLIS * 2));
            if (i != MOVED) {
                next(own, meanMillis);
            }
        }
    }

    private synchronized void say(Address own) {
        Frame frame = new Frame(Address.BROADCAST, own, Bytes.ofText("tell;here"));
        onAir(frame, () -> listener.heard(frame.encode()));
    }

    private void next(Address own, long meanMillis) {
        long pause = Math.round(-meanMillis / 2.0 * Math.log(1 - random.nextDouble()));
        clock.schedule(() -> {
            boolean near = random.nextBoolean();
            send(own, near ? device(cell, random.nextInt(MOVED)) : destinations.get());
            next(own, meanMillis);
        }, pause);
    }

    /** A device sends a message, until it is acknowledged or for the last time. */
    synchronized void send(Address from, Address to) {
        nonce++;
        Frame frame = new Frame(to, from,
                Bytes.join(Bytes.ofNumber((long) cell << NUMBERS / 2 - 1 | nonce, 6), Bytes.ofNumber(nonce, CONTENT)));
        Sent sent = new Sent(frame, to + " " + (nonce & BITS));
        awaited.put(sent.key, sent);
        count.offered(kind(to));
        attempt(sent, 1);
    }

    private PlayedCount.Kind kind(Address to) {
        int number = to.value() % NUMBERS;
        return number == MOVED ? PlayedCount.Kind.MOVED : number > MOVED ? PlayedCount.Kind.UNKNOWN
                : to.value() / NUMBERS == cell ? PlayedCount.Kind.NEAR : PlayedCount.Kind.FAR;
    }

    private void attempt(Sent sent, int number) {
        onAir(sent.frame, () -> {
            listener.heard(sent.frame.encode());
            reach(sent.frame);
            long pause = (number > QUICK_ATTEMPTS ? 2 : 1) * PATIENCE_MILLIS + random.nextInt(BACKOFF_MILLIS);
            clock.schedule(() -> repeat(sent, number + 1), pause);
        });
    }

    private synchronized void repeat(Sent sent, int number) {
        if (awaited.get(sent.key) != sent) {
            return;
        }
        if (number > ATTEMPTS) {
            awaited.remove(sent.key);
        } else {
            attempt(sent, number);
        }
    }

    /** A frame takes its turn on the air. */
    private synchronized void onAir(Frame frame, Runnable heard) {
        long now = clock.now();
        free = Math.max(free, now) + Airtime.millis(frame.encode().length()) + TURN_MILLIS;
        clock.schedule(heard, free - now);
    }

    /** A frame has come to whom it is for. */
    private synchronized void reach(Frame frame) {
        Address to = frame.destination();
        if (to.kind() == Address.Kind.ACKNOWLEDGEMENT) {
            Sent sent = awaited.remove(frame.origin() + " " + (to.value() & BITS));
            if (sent != null) {
                count.delivered(kind(sent.frame.destination()));
            }
        } else if (here.contains(to)) {
            int bits = (int) frame.message().number(4, 6) & BITS;
            Frame answer = new Frame(Address.parse("+K" + new Address(bits).toString().substring(2)), to,
                    Bytes.ofNumber(bits, PROOF));
            onAir(answer, () -> {
                listener.heard(answer.encode());
                reach(answer);
            });
        }
    }

    @Override
    public boolean isOnline() {
        return listener != null;
    }

    @Override
    public CompletionStage<Boolean> relay(Frame frame) {
        CompletableFuture<Boolean> sent = new CompletableFuture<>();
        onAir(frame, () -> {
            sent.complete(true);
            reach(frame);
        });
        return sent;
    }

    @Override
    public void close() {
        // Nothing is open.
    }
}
