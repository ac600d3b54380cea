package keyagreement;

import java.security.SecureRandom;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import javino.protocol.Key;

/** What all handshakes of a host share. */
final class Shared {

    /** Half-open handshakes that others began, in whosoever name. */
    private static final int MOST_HALF_OPEN = 4;

    private final Identity identity;
    private final KeyAgreement.Effects effects;
    private final SecureRandom random;
    private final Map<Event, Long> events = new EnumMap<>(Event.class);
    private final BroadcastQueue broadcasts = new BroadcastQueue(this);
    private final RateLimiter answers = new RateLimiter(this);
    private final RateLimiter hints = new RateLimiter(this);
    private final Deque<ResponderHandshake> halfOpen = new ArrayDeque<>();
    private int lastId;
    private Key groupKey;

    Shared(Identity identity, KeyAgreement.Effects effects, SecureRandom random) {
        this.identity = identity;
        this.effects = effects;
        this.random = random;
        lastId = random.nextInt();
    }

    Identity identity() {
        return identity;
    }

    KeyAgreement.Effects effects() {
        return effects;
    }

    SecureRandom random() {
        return random;
    }

    BroadcastQueue broadcasts() {
        return broadcasts;
    }

    /** Handshakes that others began and of which nothing is proved, the newest last. */
    Deque<ResponderHandshake> halfOpen() {
        return halfOpen;
    }

    /** Takes one more; the oldest makes room for it. */
    void open(ResponderHandshake run) {
        if (halfOpen.size() == MOST_HALF_OPEN) {
            halfOpen.poll();
            count(Event.EXPIRED);
        }
        halfOpen.add(run);
    }

    /** For messages 2. */
    RateLimiter answers() {
        return answers;
    }

    /** For all else that anybody can make this host say. */
    RateLimiter hints() {
        return hints;
    }

    /** The id of the next content: by one higher than the last, from a random one on. */
    int nextId() {
        return ++lastId;
    }

    /** The key of the own group, if this host is its group key server. */
    Optional<Key> groupKey() {
        return Optional.ofNullable(groupKey);
    }

    void setGroupKey(Key key) {
        groupKey = key;
    }

    void count(Event event) {
        events.merge(event, 1L, Long::sum);
    }

    Map<Event, Long> events() {
        return new EnumMap<>(events);
    }
}
