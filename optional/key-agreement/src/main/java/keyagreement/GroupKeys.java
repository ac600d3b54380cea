package keyagreement;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;
import javino.protocol.Key;

/** The key of the own group: its server makes it and gives it; a member asks for it, while messages wait for it. */
final class GroupKeys {

    /** Messages that wait, and how long in ms: a server needs some seconds. */
    private static final int MOST_WAITING = 8;
    private static final long WAIT_MILLIS = 30_000;
    /** Between two questions for the key. */
    private static final long AGAIN_MILLIS = 10_000;
    /** Between two keys for members that have lost theirs. */
    static final long RENEWAL_MILLIS = 3_600_000;
    /** Between two members that are owed the key: a handshake takes some seconds. Then before all that still are. */
    private static final long OWED_MILLIS = 15_000;
    private static final long ROUND_MILLIS = 600_000;
    private static final long AT_ONCE = Long.MIN_VALUE / 2;

    private final Context context;
    private final Address group;
    private final Deque<Waiting> waiting = new ArrayDeque<>();
    /** Members that have had the key. */
    private final Set<Address> had = new HashSet<>();
    /** Members that have had an earlier key, and keep that until they are met: they ask for nothing. */
    private final Set<Address> owed = new HashSet<>();
    /** Those of them that have still to be met in this round. */
    private final Deque<Address> round = new ArrayDeque<>();
    private long meetAt = AT_ONCE;
    /** Members that have had the key and say, without a proof, that their boards lack it. */
    private final Set<Address> asked = new HashSet<>();
    /** The server's. */
    private Optional<Key> key;
    /** A member that has had the key has lost it: another one is due. */
    private boolean isLost;
    private long mayRenew = Long.MIN_VALUE;
    private boolean lacks;
    private long askedAt = -AGAIN_MILLIS;

    private record Waiting(Object ticket, long end) {
    }

    /** A server's state: the key, the members that have had it, and those that have had only an earlier one. */
    record Kept(Key key, Set<Address> had, Set<Address> owed) {
    }

    /** @param kept the last state of a server. */
    GroupKeys(Context context, Optional<Kept> kept) {
        this.context = context;
        key = kept.map(Kept::key);
        kept.ifPresent(each -> {
            had.addAll(each.had());
            owed.addAll(each.owed());
        });
        group = Address.multicast(context.self().group());
        if (isServer() && key.isEmpty()) {
            make();
        }
    }

    private boolean isServer() {
        return context.identity().certificate().groupKeyServer();
    }

    /** Makes another key: whoever had the one before is owed it. */
    private void make() {
        key = Optional.of(Key.random(context.random()));
        owed.addAll(had);
        owed.remove(context.self());
        round.clear();
        meetAt = AT_ONCE;
        had.clear();
        asked.clear();
        isLost = false;
        keep();
        context.effects().add(new Effect.SetGroupKey(key.get()));
    }

    private void keep() {
        context.effects().add(new Effect.KeepGroupKey(new Kept(key.get(), Set.copyOf(had), Set.copyOf(owed))));
    }

    /** Makes another key, if this host is the server: whoever a new revocation list names has the last one. */
    void renew() {
        if (isServer()) {
            make();
        }
    }

    /**
     * Makes another key if a member has lost the one that it had: with the same again, its nonces and what others have
     * said could come again. Once an hour at most, so that no member wears out the others' EEPROM.
     *
     * @return whether there is another one.
     */
    boolean renewLost(long now) {
        boolean renews = isLost && now >= mayRenew;
        if (renews) {
            mayRenew = now + RENEWAL_MILLIS;
            make();
        }
        return renews;
    }

    /** A member that is owed the key and is to be met now: one at a time, all in a round, then all that still are. */
    Optional<Address> due(long now) {
        if (owed.isEmpty() || now < meetAt) {
            return Optional.empty();
        }
        round.retainAll(owed);
        if (round.isEmpty()) {
            round.addAll(owed);
        }
        Address member = round.poll();
        meetAt = now + (round.isEmpty() ? ROUND_MILLIS : OWED_MILLIS);
        return Optional.of(member);
    }

    /** A device's certificate is not valid any more. */
    void owesNothing(Address device) {
        if (owed.remove(device)) {
            keep();
        }
    }

    /** The board lacks the key: a server gives it, a member asks for it, unless it has done so lately. */
    void want(long now) {
        lacks = true;
        if (isServer()) {
            isLost |= had.contains(context.self());
            if (!isLost) {
                context.effects().add(new Effect.SetGroupKey(key.get()));
            }
        } else if (now - askedAt >= AGAIN_MILLIS) {
            askedAt = now;
            context.hint(new HostMessage(Kind.GROUP, group, Bytes.EMPTY));
        }
    }

    /** The board has had the key that it was to be given, and has lost it: it does not take it. */
    void refused() {
        lacks = true;
        isLost |= isServer();
    }

    /** Takes a message that needs the key, unless too many wait. */
    boolean send(Object ticket, long now) {
        boolean taken = waiting.size() < MOST_WAITING && waiting.add(new Waiting(ticket, now + WAIT_MILLIS));
        if (taken) {
            want(now);
        }
        return taken;
    }

    /** The board has the key. */
    void set() {
        lacks = false;
        if (isServer()) {
            had(context.self());
        }
        waiting.forEach(each -> context.effects().add(new Effect.Multicast(each.ticket())));
        waiting.clear();
    }

    /** A device gives the key. */
    void take(Certificate from, Bytes bytes) {
        if (isServedBy(from)) {
            context.effects().add(new Effect.SetGroupKey(Key.of(bytes)));
        } else {
            context.count(Event.REFUSED);
        }
    }

    /** Whether a device asks for the key that this host gives. */
    boolean isWanted(Address from, Address wanted) {
        return isServer() && wanted.equals(group) && isMember(from);
    }

    /** Anybody says in a member's name that it lacks the key. */
    void asks(Address member) {
        if (had.contains(member)) {
            asked.add(member);
        }
    }

    /** Whether a device with this certificate gives this host the key. */
    boolean isServedBy(Certificate other) {
        return other.groupKeyServer() && isMember(other.address());
    }

    /**
     * A request by a session key. The server's asks whether the board lacks the key; a member's says so.
     *
     * @return the answer, if there is one.
     */
    Optional<HostMessage> requested(Certificate from) {
        if (!isServer() && isServedBy(from)) {
            return lacks ? Optional.of(request()) : Optional.empty();
        }
        if (!isServer() || !isMember(from.address())) {
            context.count(Event.REFUSED);
            return Optional.empty();
        }
        asked.remove(from.address());
        isLost |= had.contains(from.address());
        return give(from.address());
    }

    static HostMessage request() {
        return new HostMessage(Kind.GROUP_KEY_REQUEST, Bytes.EMPTY);
    }

    /** A member has taken a message. */
    void delivered(Address member, HostMessage message) {
        if (message.kind() == Kind.GROUP_KEY && key.filter(each -> each.bytes().equals(message.body())).isPresent()) {
            had(member);
        } else if (message.kind() == Kind.GROUP_KEY_REQUEST) {
            asked.remove(member);
        }
    }

    private void had(Address member) {
        if (had.add(member) | owed.remove(member)) {
            keep();
        }
    }

    private boolean isMember(Address device) {
        return device.group().equals(context.self().group());
    }

    /** The server's message for a device: the key until it has had it, then a request if it is said to lack it. */
    Optional<HostMessage> give(Address to) {
        if (key.isEmpty() || !isMember(to)) {
            return Optional.empty();
        }
        if (had.contains(to)) {
            return asked.contains(to) ? Optional.of(request()) : Optional.empty();
        }
        return Optional.of(new HostMessage(Kind.GROUP_KEY, key.get().bytes()));
    }

    long next() {
        return Math.min(end(), Math.min(isLost ? mayRenew : Context.NEVER, owed.isEmpty() ? Context.NEVER : meetAt));
    }

    private long end() {
        return waiting.isEmpty() ? Context.NEVER : waiting.peek().end();
    }

    void tick(long now) {
        while (end() <= now) {
            context.effects().add(new Effect.End(waiting.poll().ticket(), Ending.NO_GROUP_KEY));
        }
    }

    /** All that waits ends. */
    void end(Ending why) {
        waiting.forEach(each -> context.effects().add(new Effect.End(each.ticket(), why)));
        waiting.clear();
    }
}
