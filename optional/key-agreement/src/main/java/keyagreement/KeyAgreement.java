package keyagreement;

import java.io.IOException;
import java.security.SecureRandom;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javino.JavinoException;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Key;
import javino.protocol.Outcome;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;
import javino.protocol.Message;
import keyagreement.edhoc.HandshakeException;

/**
 * How a host comes to a key with hosts that it has never met (SPEC 11.3): handshakes, the messages that wait for them,
 * revocation lists, the keys of groups. It opens nothing and has no thread: it is told what happens, and tells an
 * {@link Effects} what to do.
 *
 * <p>A caller with a {@link javino.board.Board}
 * <ul>
 * <li>calls all methods on one thread that is neither the board's nor the agent's (a handshake computes for some
 * milliseconds), with the same clock in ms, which never goes back;
 * <li>deletes at its start the session keys that the board still has ({@link javino.protocol.Reply.Role#SESSION}): they
 * are of an earlier run;
 * <li>passes on {@link javino.board.BoardListener#hostMessage} to {@link #received}, {@code noKey} to {@link #noKey},
 * and {@code online} with another boot epoch than before to {@link #booted};
 * <li>calls {@link #tick} when {@link #next} has come.
 * </ul>
 * It makes no object of this class for a board whose RF id is not that of the certificate.
 */
public final class KeyAgreement {

    /** Hosts that were met, and others of which something came or for which something waits. */
    static final int MOST_MET = 64;
    static final int MOST_UNKNOWN = 16;

    private final Shared shared;
    private final Map<Address, Peer> peers = new LinkedHashMap<>(MOST_MET, 0.75f, true);
    private final Address self;
    private boolean open = true;
    private long lastTicket;

    /** What the agreement has done. Each call returns at once; no method of the agreement may be called within. */
    public interface Effects {

        /**
         * Sends {@code board.transmit(Address.BROADCAST, word)}; when that has ended, however it has,
         * {@link KeyAgreement#said} is called. There is one at a time.
         */
        void broadcast(HostMessage word);

        /**
         * Sends {@code board.transmit(to, word)}; then {@link KeyAgreement#sent} is called. There is one at a time for
         * each address.
         */
        void unicast(Address to, HostMessage word);

        /** Calls {@code board.setSessionKey(device, key)}, and then {@link KeyAgreement#keySet}. */
        void setSessionKey(Address device, Key key);

        /** Calls {@code board.deleteKey(device)}: of a session key. */
        void deleteKey(Address device);

        /**
         * Calls {@code board.setKey(group, key)}: it is kept in EEPROM. The group key server also keeps it itself, for
         * {@link KeyAgreement#KeyAgreement}.
         */
        void setGroupKey(Address group, Key key);

        /** There is a fresh key with the peer, which has shown a certificate that counts. */
        void met(Address peer, Certificate certificate);

        /** A content came from a peer with a certificate, sealed. */
        void received(Address from, Content content);

        /** What became of a message of {@link KeyAgreement#send}. */
        void ended(long ticket, Ending how);

        /** @param what one line for the user. */
        void warn(String what);
    }

    /** How a unicast ended, as far as the board knows. */
    public enum Sent {
        /** {@link Outcome#DELIVERED}. */
        DELIVERED,
        /** {@link Outcome#UNDELIVERED}. */
        UNDELIVERED,
        /** The board has not sent it: {@link javino.protocol.Status#NO_KEY}. */
        NO_KEY,
        /** The board has not sent it, for another reason. */
        FAILED
    }

    /**
     * @param identity the device's own.
     * @param groupKey of a group key server, what {@link Effects#setGroupKey} had it keep last; else nothing.
     * @param random   for keys, nonces and waits.
     */
    public KeyAgreement(Identity identity, Optional<Key> groupKey, Effects effects, SecureRandom random) {
        shared = new Shared(identity, effects, random);
        self = identity.certificate().address();
        groupKey.ifPresent(shared::setGroupKey);
        if (identity.certificate().groupKeyServer() && groupKey.isEmpty()) {
            makeGroupKey();
        }
    }

    /** Whether this host takes part in handshakes that others begin; it does unless told otherwise. */
    public void setOpen(boolean wanted) {
        open = wanted;
    }

    // What the agent wants.

    /**
     * Sends a message to a device with which there is no stored key; where there is no session key, hosts agree on one
     * first. A message ends within {@value Peer#MOST_MILLIS} ms, as {@link Effects#ended} tells, whatever happens.
     *
     * @param message of a content, up to 490 bytes.
     * @return the ticket, by which its end is told; nothing if there are too many messages, which is told nowhere else.
     * @throws IllegalArgumentException if the address is no other device's, or the content is too long.
     */
    public Optional<Long> send(Address to, Message message, long now) {
        if (to.kind() != Address.Kind.DEVICE || to.equals(self)) {
            throw new IllegalArgumentException("a message goes to another device, not to " + to);
        }
        long ticket = lastTicket + 1;
        Optional<Peer> peer = peer(to);
        if (peer.isEmpty() || !peer.get().send(ticket, message, now)) {
            return Optional.empty();
        }
        lastTicket = ticket;
        return Optional.of(ticket);
    }

    /**
     * Asks the group key server of the own group for its key, by one broadcast that may be lost; what comes of it is
     * {@link Effects#setGroupKey}. To be asked again, some ten seconds later, while the key is wanted.
     */
    public void wantGroupKey(long now) {
        shared.broadcasts().say(new HostMessage(Kind.GROUP, Address.multicast(self.group()), Bytes.EMPTY), now,
                (then, took) -> {
                });
    }

    /** Whether there is a session key with a device, as far as is known. */
    public boolean isSecure(Address device) {
        return peers.containsKey(device) && peers.get(device).isSecure();
    }

    // What the board tells.

    /** A host message came: a broadcast, or sealed by a session key. */
    public void received(Address from, HostMessage word, long now) {
        if (from.equals(self)) {
            shared.count(Event.MALFORMED);
        } else if (word.to().isEmpty()) {
            opened(from, word, now);
        } else if (word.kind() == Kind.GROUP) {
            groupWanted(from, word.to().get(), now);
        } else if (!word.to().get().equals(self)) {
            shared.count(Event.OVERHEARD);
            peers.values().forEach(peer -> peer.giveWay(now));
        } else {
            heard(from, word, now);
        }
    }

    private void heard(Address from, HostMessage word, long now) {
        switch (word.kind()) {
            case MESSAGE_1 -> first(from, word, Handshake.Round.FULL, now);
            case RENEWAL_1 -> first(from, word, Handshake.Round.RENEWAL, now);
            case MESSAGE_2, RENEWAL_2 -> known(from).ifPresent(peer -> peer.second(word, now));
            case MESSAGE_3, RENEWAL_3 -> known(from).ifPresent(peer -> peer.third(word, now));
            case WANT -> known(from).ifPresent(peer -> peer.wanted((int) word.body().number(0, 2), now));
            default -> throw new IllegalArgumentException("of no handshake: " + word);
        }
    }

    private void first(Address from, HostMessage word, Handshake.Round round, long now) {
        if (!open) {
            shared.count(Event.LIMITED);
            return;
        }
        peer(from).ifPresent(peer -> peer.first(word, round, now));
    }

    private Optional<Peer> known(Address from) {
        Optional<Peer> peer = Optional.ofNullable(peers.get(from));
        if (peer.isEmpty()) {
            shared.count(Event.STRAY);
        }
        return peer;
    }

    /** The peer, who may be new; nothing if there are too many. */
    private Optional<Peer> peer(Address address) {
        if (!peers.containsKey(address) && !leavesRoom(false, MOST_UNKNOWN)) {
            shared.count(Event.LIMITED);
            return Optional.empty();
        }
        return Optional.of(peers.computeIfAbsent(address, unknown -> new Peer(shared, unknown)));
    }

    /**
     * Forgets who was not heard of for longest, where there are too many of those that were met, or of the others: so
     * nobody is forgotten for whoever sends in the name of many.
     */
    private boolean leavesRoom(boolean met, int most) {
        List<Peer> alike = peers.values().stream().filter(peer -> met == (peer.kept() != null)).toList();
        Optional<Peer> idle = alike.stream().filter(Peer::isIdle).findFirst();
        if (alike.size() >= most && idle.isPresent()) {
            idle.get().forget();
            peers.remove(idle.get().address());
        }
        return alike.size() < most || idle.isPresent();
    }

    private void groupWanted(Address from, Address group, long now) {
        if (!open || !shared.identity().certificate().groupKeyServer() || !group.equals(Address.multicast(self.group()))
                || !from.group().equals(self.group())) {
            shared.count(Event.OVERHEARD);
            return;
        }
        Optional<Peer> member = shared.hints().take(now) ? peer(from) : Optional.empty();
        member.ifPresent(peer -> {
            peer.forgetGroupKeyGiven();
            if (peer.isSecure()) {
                peer.giveGroupKey(now);
            } else {
                peer.meet(now);
            }
        });
    }

    private void opened(Address from, HostMessage word, long now) {
        Optional<Peer> peer = Optional.ofNullable(peers.get(from)).filter(Peer::isMet);
        if (peer.isEmpty()) {
            shared.count(Event.STRAY);
            return;
        }
        switch (word.kind()) {
            case REVOCATION_LIST -> revocationList(word.body(), now);
            case GROUP_KEY -> groupKey(peer.get(), word.body());
            default -> peer.get().opened(word, now);
        }
    }

    private void revocationList(Bytes revocationList, long now) {
        try {
            if (shared.identity().take(revocationList)) {
                shared.count(Event.REVOCATION_LISTS);
                peers.values().forEach(Peer::check);
                if (shared.identity().certificate().groupKeyServer()) {
                    // Whoever it names has the key of the group.
                    makeGroupKey();
                    List.copyOf(peers.values()).forEach(peer -> peer.giveGroupKey(now));
                }
            }
        } catch (HandshakeException e) {
            shared.count(Event.REFUSED);
        } catch (IOException | JavinoException e) {
            shared.effects().warn("a revocation list of the authority could not be kept: " + e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void makeGroupKey() {
        Key key = Key.random(shared.random());
        shared.setGroupKey(key);
        shared.effects().setGroupKey(Address.multicast(self.group()), key);
    }

    private void groupKey(Peer from, Bytes key) {
        if (from.isGroupKeyServer()) {
            shared.effects().setGroupKey(Address.multicast(self.group()), Key.of(key));
        } else {
            shared.count(Event.REFUSED);
        }
    }

    /** The board has heard a sealed frame for itself, and has no key for its origin. */
    public void noKey(Address origin, long now) {
        if (open) {
            peer(origin).ifPresent(peer -> peer.noKey(now));
        }
    }

    /** The board has booted: all session keys are gone. */
    public void booted(long now) {
        List.copyOf(peers.values()).forEach(peer -> peer.booted(now));
    }

    /** {@link Effects#broadcast} has ended. */
    public void said(long now) {
        shared.broadcasts().sent(now);
    }

    /** {@link Effects#unicast} has ended. */
    public void sent(Address to, Sent how, long now) {
        Optional.ofNullable(peers.get(to)).ifPresent(peer -> peer.sent(how, now));
    }

    /** {@link Effects#setSessionKey} has ended. */
    public void keySet(Address device, boolean done, long now) {
        Optional.ofNullable(peers.get(device)).ifPresent(peer -> peer.keySet(done, now));
        leavesRoom(true, MOST_MET + 1);
    }

    // Time.

    /** When {@link #tick} is to be called, unless something happens before. {@link Long#MAX_VALUE} for never. */
    public long next() {
        return peers.values().stream().mapToLong(Peer::next).min().orElse(Long.MAX_VALUE);
    }

    /** Does what is due. */
    public void tick(long now) {
        List.copyOf(peers.values()).forEach(peer -> peer.tick(now));
    }

    /** How often each has happened; what has not is absent. */
    public Map<Event, Long> events() {
        return shared.events();
    }
}
