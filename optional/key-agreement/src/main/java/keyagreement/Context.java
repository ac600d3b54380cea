package keyagreement;

import java.security.SecureRandom;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import javino.protocol.Address;
import javino.protocol.HostMessage;

/**
 * The part that the state machines of a host share.
 *
 * @param effects  those that they ask for.
 * @param halfOpen handshakes that others began and of which nothing is proved, the newest last.
 * @param answers  limits messages 2.
 * @param hints    limits all else that anybody can make this host say.
 * @param handshakes how many there were.
 */
record Context(Identity identity, SecureRandom random, List<Effect> effects, Map<Event, Long> events,
        Deque<Handshake> halfOpen, RateLimiter answers, RateLimiter hints, AtomicInteger handshakes) {

    static final long NEVER = Long.MAX_VALUE;
    /** Half-open handshakes that others began, in whosoever name. */
    private static final int MOST_HALF_OPEN = 4;

    Context(Identity identity, SecureRandom random) {
        this(identity, random, new ArrayList<>(), new EnumMap<>(Event.class), new ArrayDeque<>(),
                new RateLimiter(random), new RateLimiter(random), new AtomicInteger());
    }

    Address self() {
        return identity.certificate().address();
    }

    /** Takes one more; the oldest makes room for it. */
    void open(Handshake run) {
        if (halfOpen.size() == MOST_HALF_OPEN) {
            halfOpen.poll().drop();
            count(Event.EXPIRED);
        }
        halfOpen.add(run);
    }

    /** Says something that belongs to no handshake. */
    void hint(HostMessage message) {
        effects.add(new Effect.Broadcast(0, message));
    }

    /** Whether a limit permits it. */
    boolean permits(RateLimiter limiter, long now) {
        boolean permitted = limiter.take(now);
        if (!permitted) {
            count(Event.LIMITED);
        }
        return permitted;
    }

    void count(Event event) {
        events.merge(event, 1L, Long::sum);
    }
}
