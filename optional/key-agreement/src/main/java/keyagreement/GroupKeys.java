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

    private final Context context;
    private final Address group;
    private final Deque<Waiting> waiting = new ArrayDeque<>();
    private final Set<Address> given = new HashSet<>();
    /** The server's. */
    private Optional<Key> key;
    private long asked = -AGAIN_MILLIS;

    private record Waiting(Object ticket, long end) {
    }

    /** @param key of a server, what it kept last. */
    GroupKeys(Context context, Optional<Key> key) {
        this.context = context;
        this.key = key;
        group = Address.multicast(context.self().group());
        if (isServer() && key.isEmpty()) {
            make();
        }
    }

    private boolean isServer() {
        return context.identity().certificate().groupKeyServer();
    }

    /** Makes another key. */
    private void make() {
        Key made = Key.random(context.random());
        key = Optional.of(made);
        given.clear();
        context.effects().add(new Effect.KeepGroupKey(made));
        context.effects().add(new Effect.SetGroupKey(made));
    }

    /** Makes another key, if this host is the server: whoever a new revocation list names has the last one. */
    void renew() {
        if (isServer()) {
            make();
        }
    }

    /** The board lacks the key: a server gives it, a member asks for it, unless it has done so lately. */
    void want(long now) {
        if (isServer()) {
            context.effects().add(new Effect.SetGroupKey(key.get()));
        } else if (now - asked >= AGAIN_MILLIS) {
            asked = now;
            context.hint(new HostMessage(Kind.GROUP, group, Bytes.EMPTY));
        }
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
        waiting.forEach(each -> context.effects().add(new Effect.Multicast(each.ticket())));
        waiting.clear();
    }

    /** A device gives the key. */
    void take(Certificate from, Bytes bytes) {
        if (from.groupKeyServer() && isMember(from.address())) {
            context.effects().add(new Effect.SetGroupKey(Key.of(bytes)));
        } else {
            context.count(Event.REFUSED);
        }
    }

    /** Whether a device asks for the key that this host gives. */
    boolean isWanted(Address from, Address wanted) {
        return isServer() && wanted.equals(group) && isMember(from);
    }

    private boolean isMember(Address device) {
        return device.group().equals(context.self().group());
    }

    /** The member lacks the key: what was given is lost. */
    void lost(Address member) {
        given.remove(member);
    }

    /** What a device is to be given, if this host is the server and has not given it. */
    Optional<HostMessage> give(Address to) {
        return key.filter(each -> isMember(to) && given.add(to))
                .map(each -> new HostMessage(Kind.GROUP_KEY, each.bytes()));
    }

    long next() {
        return waiting.isEmpty() ? Context.NEVER : waiting.peek().end();
    }

    void tick(long now) {
        while (next() <= now) {
            context.effects().add(new Effect.End(waiting.poll().ticket(), Ending.NO_GROUP_KEY));
        }
    }

    /** All that waits ends. */
    void end(Ending why) {
        waiting.forEach(each -> context.effects().add(new Effect.End(each.ticket(), why)));
        waiting.clear();
    }
}
