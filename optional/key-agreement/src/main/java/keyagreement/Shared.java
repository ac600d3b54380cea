package keyagreement;

import java.security.SecureRandom;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import javino.protocol.Key;

/** What all meetings of a host share. */
final class Shared {

    /** Half-open handshakes that others began, in whosoever name. */
    private static final int MOST_HALF_OPEN = 4;

    private final Identity identity;
    private final Meetings.Outside outside;
    private final SecureRandom random;
    private final Map<Event, Long> events = new EnumMap<>(Event.class);
    private final Speech speech = new Speech(this);
    private final Sparingly answers = new Sparingly(this);
    private final Sparingly hints = new Sparingly(this);
    private final Deque<Answered> halfOpen = new ArrayDeque<>();
    private int lastId;
    private Key groupKey;

    Shared(Identity identity, Meetings.Outside outside, SecureRandom random) {
        this.identity = identity;
        this.outside = outside;
        this.random = random;
        lastId = random.nextInt();
    }

    Identity identity() {
        return identity;
    }

    Meetings.Outside outside() {
        return outside;
    }

    SecureRandom random() {
        return random;
    }

    Speech speech() {
        return speech;
    }

    /** Handshakes that others began and of which nothing is proved, the newest last. */
    Deque<Answered> halfOpen() {
        return halfOpen;
    }

    /** Takes one more; the oldest makes room for it. */
    void open(Answered run) {
        if (halfOpen.size() == MOST_HALF_OPEN) {
            halfOpen.poll();
            count(Event.EXPIRED);
        }
        halfOpen.add(run);
    }

    /** For messages 2. */
    Sparingly answers() {
        return answers;
    }

    /** For all else that anybody can make this host say. */
    Sparingly hints() {
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
