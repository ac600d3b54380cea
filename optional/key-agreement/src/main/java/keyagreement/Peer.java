package keyagreement;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.stream.LongStream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;
import javino.protocol.ProtocolException;
import keyagreement.edhoc.Secret;

/** Another host: what is kept of it, and what joins its session, its handshakes and the messages for it. */
final class Peer {

    /** The ids of contents that came last. */
    private static final int IDS = 8;
    static final int ID_LENGTH = 3;
    /** A report of the board so soon after it has got a key may be older than that. */
    private static final long OLDER_MILLIS = 1000;

    private final Context context;
    private final GroupKeys groupKeys;
    private final Address address;
    private final Handshakes handshakes;
    private final MessageQueue queue;
    private final RevocationLists lists;
    private final Deque<Integer> ids = new ArrayDeque<>();

    private Certificate certificate;
    private Secret kept;
    private Session session = Session.NONE;
    private int keysSet;
    private int keysThen;
    private long keySetAt = Long.MIN_VALUE / 2;

    Peer(Context context, GroupKeys groupKeys, Address address) {
        this.context = context;
        this.groupKeys = groupKeys;
        this.address = address;
        handshakes = new Handshakes(context, address);
        queue = new MessageQueue(context, address);
        lists = new RevocationLists(context);
    }

    Address address() {
        return address;
    }

    Secret kept() {
        return kept;
    }

    /** Whether it has shown a certificate that counts: what comes sealed is its own. */
    boolean isMet() {
        return certificate != null;
    }

    boolean isSecure() {
        return session != Session.NONE;
    }

    /** Whether it may be forgotten: what others have begun without a proof counts for nothing. */
    boolean isIdle() {
        return handshakes.begun().isEmpty() && session != Session.SETTING && queue.isEmpty();
    }

    long next() {
        return LongStream.concat(LongStream.of(queue.next(), lists.next()),
                handshakes.all().stream().mapToLong(Handshake::deadline)).min().getAsLong();
    }

    void tick(long now) {
        handshakes.tick(queue.isWaiting(), now).forEach(left -> after(left, now));
        if (now >= lists.next()) {
            queue(lists.step(RevocationLists.Input.LATE, now), now);
        }
        queue.tick(switch (session) {
            case NONE -> Ending.NO_ANSWER;
            case SETTING -> Ending.NOT_SENT;
            case UNPROVEN, PROVEN -> Ending.UNDELIVERED;
        }, now);
    }

    // Handshakes

    /** Begins a renewal, or where that cannot be a handshake, unless one is under way. */
    void meet(long now) {
        meet(renewable(), now);
    }

    private void meet(Optional<Secret> from, long now) {
        if (handshakes.begun().isEmpty() && session != Session.SETTING) {
            handshakes.begin(from, now);
        }
    }

    private Optional<Secret> renewable() {
        return Optional.ofNullable(kept).filter(any -> context.identity().refusal(certificate).isEmpty());
    }

    /** A message of a handshake. */
    void handshake(HostMessage message, long now) {
        boolean first = message.kind() == Kind.MESSAGE_1 || message.kind() == Kind.RENEWAL_1;
        if (session == Session.SETTING) {
            context.count(first ? Event.CROSSED : Event.STRAY);
        } else if (first) {
            handshakes.first(message, renewable(), now);
        } else {
            (message.kind() == Kind.WANT ? handshakes.wanted(message.body().at(0), message.body().at(1), now)
                    : handshakes.heard(message, now)).forEach(left -> after(left, now));
        }
    }

    /** A message of a handshake has been on the air; or it will not be, as too much waits for that. */
    void said(Effect.Broadcast broadcast, boolean onAir, long took, long now) {
        handshakes.said(broadcast, onAir, took, now).forEach(left -> after(left, now));
    }

    /** Others were on the air. */
    void giveWay(long now) {
        handshakes.all().forEach(run -> run.giveWay(now));
    }

    /** Does what a handshake leaves to it. */
    private void after(Handshakes.Left left, long now) {
        if (left.deed() == HandshakeState.Deed.KEY) {
            certificate = left.run().certificate().orElse(certificate);
            kept = left.run().secret();
            step(Session.Input.VERIFIED);
            context.effects().add(new Effect.SetSessionKey(address, left.run().key()));
        } else if (left.deed() == HandshakeState.Deed.FAIL) {
            failed(left, now);
        } else if (left.deed() == HandshakeState.Deed.KEEP) {
            advance(now);
        }
    }

    private void failed(Handshakes.Left left, long now) {
        if (left.run().isInitiator() && left.run().round == Round.RENEWAL) {
            // Nothing is proved by that, so what is kept stays.
            meet(Optional.empty(), now);
            return;
        }
        context.count(left.run().isInitiator() ? Event.FAILED : Event.EXPIRED);
        if (left.run().failure() != Ending.NO_ANSWER) {
            groupKeys.owesNothing(address);
        }
        if (!left.run().isInitiator() || handshakes.isHalfOpen()) {
            advance(now);
        } else {
            queue.endWaiting(left.run().failure());
        }
    }

    /** The board has taken the key, or not. */
    void keySet(boolean done, long now) {
        boolean initiated = handshakes.begun().isPresent();
        Session.Input input = !done ? Session.Input.NOT_SET
                : initiated ? Session.Input.SET_FIRST : Session.Input.SET_SECOND;
        if (Session.TABLE.cell(session, input).isIgnored()) {
            return;
        }
        step(input);
        if (!done) {
            handshakes.drop();
            queue.agreementFailed(Ending.NOT_SENT);
            advance(now);
            return;
        }
        context.count(Event.KEYS_SET);
        keysSet++;
        keySetAt = now;
        context.effects().add(new Effect.Met(address));
        handshakes.step(HandshakeState.Input.SET, now);
        advance(now);
        giveGroupKey(now);
        queue(lists.step(initiated ? RevocationLists.Input.FIRST : RevocationLists.Input.SECOND, now), now);
    }

    /** The board has heard a sealed frame of the peer, and has no key for it. */
    void noKey(long now) {
        if (now - keySetAt < OLDER_MILLIS) {
            return;
        }
        boolean open = handshakes.isOpen();
        handshakes.step(HandshakeState.Input.UNOPENED, now);
        if (!open && step(Session.Input.UNOPENED) == Session.Deed.BEGIN && context.permits(context.hints(), now)) {
            meet(now);
        }
    }

    /** The board has booted: its session keys are gone. */
    void booted(long now) {
        step(Session.Input.BOOTED);
        advance(now);
    }

    private Session.Deed step(Session.Input input) {
        Table.Cell<Session, Session.Deed> cell = Session.TABLE.cell(session, input);
        if (cell.next() != session) {
            session = cell.next();
            context.effects().add(new Effect.Transition("session", address, "", session));
        }
        if (!cell.isIgnored() && (session == Session.PROVEN || session == Session.NONE)) {
            handshakes.step(HandshakeState.Input.DONE, 0);
        }
        return cell.deed();
    }

    // Messages

    /** Takes a message of an agent's, unless too many wait. */
    boolean send(Object ticket, HostMessage message, long now) {
        boolean taken = queue.add(Optional.of(ticket), message, now);
        advance(now);
        return taken;
    }

    private void queue(Collection<HostMessage> messages, long now) {
        messages.forEach(message -> queue.add(Optional.empty(), message, now));
        advance(now);
    }

    /** Does the next that can be done for what waits. */
    private void advance(long now) {
        if (!queue.isWaiting() || queue.isUnderWay()) {
            return;
        }
        // The other side can have the key only when message 3 has been on the air.
        boolean closing = handshakes.begun().filter(run -> run.state() == HandshakeState.CLOSING).isPresent();
        if (session == Session.NONE) {
            meet(now);
        } else if (session != Session.SETTING && !closing) {
            keysThen = keysSet;
            queue.send();
        }
    }

    /** The outcome of the message under way. */
    void sent(Session.Input how, long now) {
        if (!queue.isUnderWay()) {
            return;
        }
        Ending ending = how == Session.Input.DELIVERED ? Ending.DELIVERED
                : how == Session.Input.UNDELIVERED ? Ending.UNDELIVERED : Ending.NOT_SENT;
        if (how == Session.Input.DELIVERED) {
            groupKeys.delivered(address, queue.underWay());
        }
        if (deed(how, now) == Session.Deed.AGAIN) {
            queue.again(ending);
        } else {
            queue.end(ending);
        }
        advance(now);
    }

    private Session.Deed deed(Session.Input how, long now) {
        if (keysThen != keysSet) {
            return Session.TABLE.cell(Session.SETTING, how).deed();
        }
        if (how == Session.Input.UNDELIVERED && session == Session.UNPROVEN) {
            if (queue.isFirstTry() && handshakes.begun()
                    .flatMap(run -> run.wanted(run.round.third.first(), 0, now)).isPresent()) {
                return Session.Deed.AGAIN;
            }
            handshakes.drop();
        }
        return step(how);
    }

    /** A sealed message of the peer. */
    void opened(HostMessage message, long now) {
        step(Session.Input.SEALED);
        if (message.kind() == Kind.CONTENT) {
            content(message.body());
        } else if (message.kind() == Kind.GROUP_KEY) {
            groupKeys.take(certificate, message.body());
        } else if (message.kind() == Kind.GROUP_KEY_REQUEST) {
            queueOnce(groupKeys.requested(certificate), now);
        } else if (message.kind() == Kind.SEQUENCES) {
            queue(lists.heard(message.body(), now), now);
        }
        // It is there, and may not have had what was sent before.
        giveGroupKey(now);
    }

    private void content(Bytes body) {
        try {
            Content content = Content.decode(body.from(Math.min(ID_LENGTH, body.length())));
            int id = (int) body.number(0, ID_LENGTH);
            if (ids.contains(id)) {
                context.count(Event.DUPLICATES);
                return;
            }
            if (ids.size() == IDS) {
                ids.poll();
            }
            ids.add(id);
            context.effects().add(new Effect.Receive(address, content));
        } catch (ProtocolException e) {
            context.count(Event.MALFORMED);
        }
    }

    /** Gives it the key of the own group, if it is to have that. */
    void giveGroupKey(long now) {
        if (isSecure()) {
            queueOnce(groupKeys.give(address), now);
        }
    }

    private void queueOnce(Optional<HostMessage> message, long now) {
        queue(message.filter(each -> !queue.holds(each)).stream().toList(), now);
    }

    /** Asks for another key of the own group, if this is who gives it. */
    void requestGroupKey(long now) {
        if (isSecure() && groupKeys.isServedBy(certificate)) {
            queue(List.of(GroupKeys.request()), now);
        }
    }

    // Forgetting

    /** A revocation list has come: a device that is not valid any more is forgotten. */
    void check() {
        if (isMet()) {
            context.identity().refusal(certificate).ifPresent(why -> {
                groupKeys.owesNothing(address);
                forget(Ending.valueOf(why.name()));
            });
        }
    }

    /** Forgets all that is kept of the peer, and has the board forget it; what waits ends. */
    void forget(Ending why) {
        if (isSecure() || keysSet > 0) {
            context.effects().add(new Effect.DeleteKey(address));
        }
        step(Session.Input.FORGOTTEN);
        kept = null;
        certificate = null;
        handshakes.drop();
        queue.endAll(why);
    }
}
