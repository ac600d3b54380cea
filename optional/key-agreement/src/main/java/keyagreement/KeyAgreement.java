package keyagreement;

import java.security.SecureRandom;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.LongStream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;
import javino.protocol.Message;
import keyagreement.edhoc.HandshakeException;

/**
 * How a host comes to a key with hosts that it has never met (SPEC 11.3): handshakes, the messages that wait for them,
 * revocation lists, the keys of groups. It opens nothing and has no thread: it is told what happens, and
 * {@link #effects} tells what is to be done.
 *
 * <p>A caller uses one thread that is neither the board's nor the agent's, as a handshake computes for some ms, and one
 * clock in ms, which never goes back. It does the effects after each call, in their order. At its start it deletes the
 * session keys that the board still has, which are of an earlier run.
 */
final class KeyAgreement {

    /** Hosts that were met, and others of which something came or for which something waits. */
    static final int MOST_MET = 64;
    static final int MOST_UNKNOWN = 16;

    private final Context context;
    private final GroupKeys groupKeys;
    private final Map<Address, Peer> peers = new LinkedHashMap<>(MOST_MET, 0.75f, true);
    private int lastId;

    /** @param groupKey the last one that {@link Effect.KeepGroupKey} had a group key server keep; else nothing. */
    KeyAgreement(Identity identity, Optional<GroupKeys.Kept> groupKey, SecureRandom random) {
        context = new Context(identity, random);
        groupKeys = new GroupKeys(context, groupKey);
        lastId = random.nextInt();
    }

    /** The effects since this was asked last. */
    List<Effect> effects() {
        List<Effect> effects = List.copyOf(context.effects());
        context.effects().clear();
        return effects;
    }

    // Requests of the agent

    /**
     * Sends a message to a device, when there is a session key. {@link Effect.End} tells how it ended, within
     * {@value MessageQueue#MOST_MILLIS} ms, whatever happens.
     *
     * @return false if there are too many messages, which is told nowhere else.
     * @throws IllegalArgumentException if the address is no other device's, or a content has more than 490 bytes.
     */
    boolean send(Object ticket, Address to, Message message, long now) {
        if (to.kind() != Address.Kind.DEVICE || to.equals(context.self())) {
            throw new IllegalArgumentException("a message goes to another device, not to " + to);
        }
        // A host knows repeats of its own messages; an agent must not hear a content twice.
        HostMessage sent = message instanceof HostMessage ofHost ? ofHost : new HostMessage(Kind.CONTENT,
                Bytes.join(Bytes.ofNumber(++lastId, Peer.ID_LENGTH), message.encode()));
        return peer(to).filter(peer -> peer.send(ticket, sent, now)).isPresent();
    }

    /** Keeps a message to the own group until the board has its key; as {@link #send}. */
    boolean sendToGroup(Object ticket, long now) {
        boolean taken = groupKeys.send(ticket, now);
        renewLostGroupKey(now);
        return taken;
    }

    /** The board has no key of the own group. */
    void lacksGroupKey(long now) {
        groupKeys.want(now);
        renewLostGroupKey(now);
    }

    /** Whether there is a session key, as far as is known. */
    boolean isSecure(Address device) {
        return peers.containsKey(device) && peers.get(device).isSecure();
    }

    /** Ends all: the board is to forget all session keys. */
    void close() {
        peers.values().forEach(peer -> peer.forget(Ending.CLOSED));
        groupKeys.end(Ending.CLOSED);
    }

    // Reports of the board

    /** A host message came: a broadcast, or sealed by a session key. */
    void received(Address from, HostMessage message, long now) {
        Optional<Address> to = message.to();
        if (from.equals(context.self())) {
            context.count(Event.MALFORMED);
        } else if (to.isEmpty()) {
            opened(from, message, now);
        } else if (message.kind() == Kind.GROUP) {
            groupKeyWanted(from, to.get(), now);
        } else if (to.get().equals(context.self())) {
            handshake(from, message, now);
        } else {
            context.count(Event.OVERHEARD);
            peers.values().forEach(peer -> peer.giveWay(now));
        }
    }

    private void handshake(Address from, HostMessage message, long now) {
        boolean begins = message.kind() == Kind.MESSAGE_1 || message.kind() == Kind.RENEWAL_1;
        (begins ? peer(from) : known(from, any -> true)).ifPresent(peer -> peer.handshake(message, now));
    }

    private Optional<Peer> known(Address from, Predicate<Peer> which) {
        Optional<Peer> peer = Optional.ofNullable(peers.get(from)).filter(which);
        if (peer.isEmpty()) {
            context.count(Event.STRAY);
        }
        return peer;
    }

    /** The peer, who may be new; nothing if there are too many. */
    private Optional<Peer> peer(Address address) {
        if (!peers.containsKey(address) && !leavesRoom(false, MOST_UNKNOWN)) {
            context.count(Event.LIMITED);
            return Optional.empty();
        }
        return Optional.of(peers.computeIfAbsent(address, unknown -> new Peer(context, groupKeys, unknown)));
    }

    /**
     * Forgets who was not heard of for longest, where there are too many of those that were met, or of the others: so
     * nobody is forgotten for whoever sends in the name of many.
     */
    private boolean leavesRoom(boolean met, int most) {
        List<Peer> alike = peers.values().stream().filter(peer -> met == (peer.kept() != null)).toList();
        Optional<Peer> idle = alike.stream().filter(Peer::isIdle).findFirst();
        if (alike.size() >= most && idle.isPresent()) {
            idle.get().forget(Ending.NO_ANSWER);
            peers.remove(idle.get().address());
        }
        return alike.size() < most || idle.isPresent();
    }

    private void groupKeyWanted(Address from, Address group, long now) {
        if (!groupKeys.isWanted(from, group)) {
            context.count(Event.OVERHEARD);
            return;
        }
        Optional<Peer> member = context.permits(context.hints(), now) ? peer(from) : Optional.empty();
        member.ifPresent(peer -> {
            groupKeys.asks(from);
            giveGroupKeyOrMeet(peer, now);
        });
    }

    private static void giveGroupKeyOrMeet(Peer peer, long now) {
        peer.giveGroupKey(now);
        if (!peer.isSecure()) {
            peer.meet(now);
        }
    }

    private void opened(Address from, HostMessage message, long now) {
        known(from, Peer::isMet).ifPresent(peer -> {
            peer.opened(message, now);
            if (message.kind() == Kind.REVOCATION_LIST) {
                revocationList(message.body(), now);
            } else if (message.kind() == Kind.GROUP_KEY_REQUEST) {
                renewLostGroupKey(now);
            }
        });
    }

    private void revocationList(Bytes list, long now) {
        try {
            if (context.identity().take(list)) {
                context.count(Event.REVOCATION_LISTS);
                context.effects().add(new Effect.KeepRevocationLists());
                List<Peer> all = List.copyOf(peers.values());
                groupKeys.renew();
                all.forEach(Peer::check);
                all.forEach(peer -> peer.giveGroupKey(now));
            }
        } catch (HandshakeException e) {
            context.count(Event.REFUSED);
        }
    }

    /** Those that are met get another key at once, and {@link #tick} meets the others that had the one before. */
    private void renewLostGroupKey(long now) {
        if (groupKeys.renewLost(now)) {
            List.copyOf(peers.values()).forEach(peer -> peer.giveGroupKey(now));
        }
    }

    /** The board has heard a sealed frame for itself, and has no key for its origin. */
    void noKey(Address origin, long now) {
        peer(origin).ifPresent(peer -> peer.noKey(now));
    }

    /** The board has booted: all session keys are gone. */
    void booted(long now) {
        List.copyOf(peers.values()).forEach(peer -> peer.booted(now));
    }

    /** A broadcast has ended, so long after its effect; not on the air if it was not taken, as too many waited. */
    void said(Effect.Broadcast broadcast, boolean onAir, long took, long now) {
        List.copyOf(peers.values()).forEach(peer -> peer.said(broadcast, onAir, took, now));
    }

    /** A unicast of {@link Effect.Unicast} has ended: as the board says; or it has not sent it: NO_KEY, FAILED. */
    void sent(Address to, Session.Input how, long now) {
        Optional.ofNullable(peers.get(to)).ifPresent(peer -> peer.sent(how, now));
    }

    /** {@link Effect.SetSessionKey} is done, or was refused. */
    void keySet(Address device, boolean done, long now) {
        Optional.ofNullable(peers.get(device)).ifPresent(peer -> peer.keySet(done, now));
        leavesRoom(true, MOST_MET + 1);
    }

    /** {@link Effect.SetGroupKey} is done. */
    void groupKeySet() {
        groupKeys.set();
    }

    /** {@link Effect.SetGroupKey} was refused: the board has lost this key. */
    void groupKeyRefused(long now) {
        groupKeys.refused();
        renewLostGroupKey(now);
        List.copyOf(peers.values()).forEach(peer -> peer.requestGroupKey(now));
    }

    // Time

    /** When {@link #tick} is to be called, unless something happens before. {@link Long#MAX_VALUE} for never. */
    long next() {
        return LongStream.concat(LongStream.of(groupKeys.next()), peers.values().stream().mapToLong(Peer::next)).min()
                .getAsLong();
    }

    /** Does what is due. */
    void tick(long now) {
        List.copyOf(peers.values()).forEach(peer -> peer.tick(now));
        groupKeys.tick(now);
        renewLostGroupKey(now);
        groupKeys.due(now).flatMap(this::peer).ifPresent(peer -> giveGroupKeyOrMeet(peer, now));
    }

    /** How often each has happened; what has not is absent. */
    Map<Event, Long> events() {
        return new EnumMap<>(context.events());
    }
}
