package keyagreement;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;
import javino.protocol.Key;
import javino.protocol.Message;
import javino.protocol.ProtocolException;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.Secret;

/** Another host: what is kept of it, the handshakes under way with it, and the messages for it. */
final class Peer {

    /** Messages that wait for a peer. */
    static final int MOST_WAITING = 8;
    /** How long a message waits, or is under way, in ms: then it ends. */
    static final int MOST_MILLIS = 60_000;
    /** The ids of contents that came last. */
    private static final int IDS = 8;
    private static final int ID_LENGTH = 3;
    /** Agreements for one message: then it fails. */
    private static final int MOST_AGREEMENTS = 3;
    /** Who began has said what revocation lists it has, if it has any; the other waits for that. */
    private static final long REVOCATION_LISTS_MILLIS = 3000;
    private static final int SEQUENCE_LENGTH = 2;
    /** What the board tells so soon after it has got a key may be older than that. */
    private static final long LATE_MILLIS = 1000;

    private final Shared shared;
    private final Address address;

    private Certificate certificate;
    private Secret kept;

    /** What is known of the session key. */
    private enum Session {
        /** The board has none for this peer. */
        NONE,
        /** The board has it; whether the peer has it too is not known. */
        UNPROVEN,
        /** Something sealed with it has come, or was delivered. */
        PROVEN
    }

    private Session session = Session.NONE;
    private int keysSet;
    private long keySetAt = Long.MIN_VALUE / 2;
    private InitiatorHandshake initiated;
    /** Whose key the board is being given. */
    private Handshake setting;

    private final Deque<Mail> waiting = new ArrayDeque<>();
    private Mail underWay;
    private int keysThen;
    private final Deque<Integer> ids = new ArrayDeque<>();

    private final Map<Integer, Integer> sequences = new LinkedHashMap<>();
    private long revocationListsDue = Handshake.NEVER;
    private boolean revocationListsSaid;
    private Key groupKeyGiven;

    /** A message for the peer; of an agent's if it has a ticket. */
    private static final class Mail {

        private static final long NO_TICKET = -1;

        private final long ticket;
        private final HostMessage word;
        private final long end;
        private int agreements;
        private boolean over;

        Mail(long ticket, HostMessage word, long now) {
            this.ticket = ticket;
            this.word = word;
            end = now + MOST_MILLIS;
        }

        long deadline() {
            return over ? Handshake.NEVER : end;
        }
    }

    Peer(Shared shared, Address address) {
        this.shared = shared;
        this.address = address;
    }

    Address address() {
        return address;
    }

    Secret kept() {
        return kept;
    }

    Certificate certificate() {
        return certificate;
    }

    private Stream<ResponderHandshake> answered() {
        return shared.halfOpen().stream().filter(run -> run.peer() == this);
    }

    private boolean isHalfOpen() {
        return answered().findAny().isPresent();
    }

    /** Whether it has shown a certificate that counts: what comes sealed is its own. */
    boolean isMet() {
        return certificate != null;
    }

    boolean isSecure() {
        return session != Session.NONE;
    }

    /** Whether it may be forgotten: what others have initiated without a proof counts for nothing. */
    boolean isIdle() {
        return initiated == null && setting == null && waiting.isEmpty() && underWay == null;
    }

    boolean isWaiting() {
        return !waiting.isEmpty();
    }

    private List<Handshake> handshakes() {
        return Stream.concat(Stream.ofNullable(initiated), answered()).toList();
    }

    long next() {
        LongStream ofMails = Stream.of(underWay, waiting.peek()).filter(Objects::nonNull).mapToLong(Mail::deadline);
        return LongStream.concat(handshakes().stream().mapToLong(Handshake::deadline), ofMails)
                .reduce(revocationListsDue, Math::min);
    }

    void tick(long now) {
        handshakes().stream().filter(handshake -> now >= handshake.deadline())
                .forEach(handshake -> handshake.late(now));
        if (now >= revocationListsDue) {
            revocationListsDue = Handshake.NEVER;
            sayRevocationLists(now);
        }
        while (isWaiting() && now >= waiting.peek().deadline()) {
            end(waiting.poll(), session != Session.NONE ? Ending.UNDELIVERED
                    : setting != null ? Ending.NOT_SENT : Ending.NO_ANSWER);
        }
        if (underWay != null && now >= underWay.deadline()) {
            end(underWay, Ending.UNDELIVERED);
        }
    }

    /** Others were on the air. */
    void giveWay(long now) {
        handshakes().forEach(handshake -> handshake.giveWay(now));
    }

    // What the agent wants.

    /** Takes a message, unless too many wait. */
    boolean send(long ticket, Message message, long now) {
        if (waiting.size() >= MOST_WAITING) {
            return false;
        }
        // A host knows repeats of its own messages; an agent must not hear a content twice.
        HostMessage word = message instanceof HostMessage ofHost ? ofHost : new HostMessage(Kind.CONTENT,
                Bytes.join(Bytes.ofNumber(shared.nextId(), ID_LENGTH), message.encode()));
        waiting.add(new Mail(ticket, word, now));
        advance(now);
        return true;
    }

    /** Does the next that can be done for what waits. */
    void advance(long now) {
        if (waiting.isEmpty() || underWay != null || setting != null) {
            return;
        }
        if (session == Session.UNPROVEN && initiated != null && !initiated.isOpen() && !initiated.hasSaidThird()) {
            return;
        }
        if (session != Session.NONE) {
            underWay = waiting.poll();
            keysThen = keysSet;
            shared.effects().unicast(address, underWay.word);
        } else if (initiated == null) {
            begin(now);
        }
    }

    // Handshakes.

    /** Begins a handshake, unless one is under way. */
    void meet(long now) {
        if (initiated == null && setting == null) {
            begin(now);
        }
    }

    private void begin(long now) {
        Handshake.Round round = mayRenew() ? Handshake.Round.RENEWAL : Handshake.Round.FULL;
        initiated = new InitiatorHandshake(shared, this, round, now);
        if (isHalfOpen()) {
            // The other side's comes first, if it is genuine; nothing proves that yet, so not for long.
            initiated.setDeadline(now + round.thirdMillis + shared.random().nextInt((int) round.thirdMillis));
        } else {
            initiated.start(now);
        }
    }

    private boolean mayRenew() {
        try {
            if (kept != null) {
                shared.identity().check(certificate);
            }
            return kept != null;
        } catch (HandshakeException e) {
            return false;
        }
    }

    /** A message 1. */
    void first(HostMessage word, Handshake.Round round, long now) {
        Optional<ResponderHandshake> same = answered().filter(run -> run.answers(word)).findAny();
        if (same.isPresent()) {
            same.get().answer(now);
            return;
        }
        if (setting != null || initiated != null && initiated.isOpen() && hasPrecedence()) {
            shared.count(Event.CROSSED);
            return;
        }
        try {
            if (round == Handshake.Round.RENEWAL && !mayRenew()) {
                throw new HandshakeException(HandshakeException.Reason.NOT_CERTIFIED, "nothing is kept of " + address);
            }
            if (!shared.answers().take(now)) {
                return;
            }
            ResponderHandshake run = new ResponderHandshake(shared, this, round, word.body());
            shared.open(run);
            run.answer(now);
            if (initiated != null) {
                // The other side's comes first, if it is genuine.
                initiated.giveWay(now);
            }
        } catch (HandshakeException e) {
            shared.count(Event.REFUSED);
            if (round == Handshake.Round.RENEWAL && shared.hints().take(now)) {
                shared.broadcasts().say(new HostMessage(Kind.WANT, address, Bytes.of(Kind.MESSAGE_1.first(), 0)), now,
                        (then, took) -> {
                        });
            }
        }
    }

    private boolean hasPrecedence() {
        return shared.identity().certificate().address().value() < address.value();
    }

    /** A part of a message 2. */
    void second(HostMessage word, long now) {
        pass(Stream.ofNullable(initiated), word, now);
    }

    /** A message 3. */
    void third(HostMessage word, long now) {
        pass(answered(), word, now);
    }

    private void pass(Stream<? extends Handshake> runs, HostMessage word, long now) {
        List<? extends Handshake> fitting = runs.filter(handshake -> setting == null
                && (word.kind() == handshake.round().second || word.kind() == handshake.round().third)).toList();
        if (fitting.isEmpty()) {
            shared.count(Event.STRAY);
        }
        // One of them may have said it; when that is found, the others are over.
        fitting.stream().takeWhile(handshake -> setting == null).forEach(handshake -> handshake.heard(word, now));
    }

    /** The other side lacks a fragment; or it lacks what it would need for a renewal. */
    void wanted(int part, long now) {
        if (part == Handshake.part(Kind.MESSAGE_1, 0) && initiated != null && initiated.isOpen()
                && initiated.round() == Handshake.Round.RENEWAL) {
            beginFull(now);
        } else if (handshakes().stream().filter(handshake -> handshake.wanted(part, now)).toList().isEmpty()) {
            shared.count(Event.STRAY);
        }
    }

    private void beginFull(long now) {
        kept = null;
        begin(now);
    }

    /** A handshake that this side began has no message 2. */
    void unanswered(InitiatorHandshake handshake, Ending why, long now) {
        if (handshake.round() == Handshake.Round.RENEWAL) {
            beginFull(now);
            return;
        }
        handshake.log(Handshake.State.OVER);
        finished(handshake);
        shared.count(Event.FAILED);
        if (isHalfOpen()) {
            advance(now);
        } else {
            failAll(why);
        }
    }

    /** A handshake has the other side verified: the board gets the key, once. */
    void agreed(Handshake handshake, Secret secret, Certificate whose, Key key) {
        certificate = whose;
        kept = secret;
        setting = handshake;
        initiated = handshake == initiated ? initiated : null;
        shared.halfOpen().removeIf(run -> run.peer() == this);
        handshake.log(Handshake.State.SETTING);
        shared.effects().setSessionKey(address, key);
    }

    void keySet(boolean done, long now) {
        Handshake handshake = setting;
        if (handshake == null) {
            return;
        }
        setting = null;
        if (!done) {
            session = Session.NONE;
            handshake.log(Handshake.State.OVER);
            finished(handshake);
            failOrAgain(Ending.NOT_SENT, now);
            return;
        }
        handshake.log(Handshake.State.DONE);
        shared.count(Event.KEYS_SET);
        keysSet++;
        keySetAt = now;
        session = handshake == initiated ? Session.UNPROVEN : Session.PROVEN;
        revocationListsSaid = false;
        shared.effects().met(address, certificate);
        boolean initiator = handshake == initiated;
        handshake.keyIsSet(now);
        handOn(initiator, now);
    }

    /** A handshake is over. */
    void finished(Handshake handshake) {
        initiated = handshake == initiated ? null : initiated;
        shared.halfOpen().remove(handshake);
    }

    /** The board has heard a sealed frame of the peer, and has no key for it. */
    void noKey(long now) {
        if (setting != null || now - keySetAt < LATE_MILLIS) {
            return;
        }
        answered().toList().forEach(run -> run.askForThird(now));
        if (initiated != null && initiated.isOpen()) {
            initiated.isThere();
            return;
        }
        session = Session.NONE;
        if (shared.hints().take(now)) {
            begin(now);
        }
    }

    /** The board has booted: its session keys are gone. */
    void booted(long now) {
        session = Session.NONE;
        if (initiated != null && !initiated.isOpen()) {
            initiated = null;
        }
        advance(now);
    }

    // Messages.

    /** What became of the message under way. */
    void sent(KeyAgreement.Sent how, long now) {
        Mail mail = underWay;
        underWay = null;
        if (mail == null) {
            return;
        }
        boolean sameKey = keysThen == keysSet && setting == null;
        switch (how) {
            case DELIVERED -> {
                if (sameKey) {
                    prove();
                }
                end(mail, Ending.DELIVERED);
                advance(now);
            }
            case UNDELIVERED -> {
                if (sameKey && session == Session.PROVEN) {
                    // Perhaps it is only far away; if not, the next one shows it.
                    session = Session.UNPROVEN;
                    end(mail, Ending.UNDELIVERED);
                    advance(now);
                } else {
                    // Perhaps the other side lacks message 3.
                    if (sameKey && (mail.agreements > 0 || initiated == null
                            || !initiated.wanted(Handshake.part(initiated.round().third, 0), now))) {
                        session = Session.NONE;
                        kept = null;
                        initiated = null;
                    }
                    again(mail, Ending.UNDELIVERED, now);
                }
            }
            case NO_KEY -> {
                session = sameKey ? Session.NONE : session;
                again(mail, Ending.NOT_SENT, now);
            }
            case FAILED -> {
                end(mail, Ending.NOT_SENT);
                advance(now);
            }
        }
    }

    private void again(Mail mail, Ending why, long now) {
        shared.count(Event.RESENT);
        waiting.addFirst(mail);
        failOrAgain(why, now);
    }

    private void failOrAgain(Ending why, long now) {
        Mail mail = waiting.peek();
        if (mail != null && (mail.over || mail.agreements++ == MOST_AGREEMENTS)) {
            end(waiting.poll(), why);
        }
        advance(now);
    }

    private void prove() {
        session = Session.PROVEN;
        if (initiated != null && !initiated.isOpen()) {
            initiated = null;
        }
    }

    private void end(Mail mail, Ending how) {
        if (mail.ticket != Mail.NO_TICKET && !mail.over) {
            shared.effects().ended(mail.ticket, how);
        }
        mail.over = true;
    }

    private void failAll(Ending why) {
        List<Mail> all = new ArrayList<>(waiting);
        waiting.clear();
        all.forEach(mail -> end(mail, why));
    }

    /** A sealed word of the peer. */
    void opened(HostMessage word, long now) {
        if (session != Session.NONE) {
            prove();
        }
        switch (word.kind()) {
            case CONTENT -> content(word.body());
            case SEQUENCES -> sequences(word.body(), now);
            default -> throw new IllegalArgumentException("not for a peer: " + word);
        }
    }

    private void content(Bytes body) {
        try {
            if (body.length() <= ID_LENGTH) {
                shared.count(Event.MALFORMED);
                return;
            }
            Content content = Content.decode(body.from(ID_LENGTH));
            int id = (int) body.number(0, ID_LENGTH);
            if (ids.contains(id)) {
                shared.count(Event.DUPLICATES);
                return;
            }
            if (ids.size() == IDS) {
                ids.poll();
            }
            ids.add(id);
            shared.effects().received(address, content);
        } catch (ProtocolException e) {
            shared.count(Event.MALFORMED);
        }
    }

    // What is handed on.

    private void handOn(boolean initiator, long now) {
        giveGroupKey(now);
        if (initiator) {
            revocationListsDue = Handshake.NEVER;
            sayRevocationLists(now);
        } else {
            revocationListsDue = now + REVOCATION_LISTS_MILLIS;
        }
    }

    private void hand(HostMessage word, long now) {
        if (waiting.size() < 2 * MOST_WAITING) {
            waiting.add(new Mail(Mail.NO_TICKET, word, now));
            advance(now);
        } else {
            shared.count(Event.LIMITED);
        }
    }

    /** Gives a member of the own group the group's key, if this host is its group key server. */
    void giveGroupKey(long now) {
        Optional<Key> key = shared.groupKey();
        Certificate own = shared.identity().certificate();
        if (own.groupKeyServer() && key.isPresent() && !key.get().equals(groupKeyGiven)
                && address.group().equals(own.address().group()) && session != Session.NONE) {
            groupKeyGiven = key.get();
            hand(new HostMessage(Kind.GROUP_KEY, key.get().bytes()), now);
        }
    }

    /** The member asks for the key: what was given is lost. */
    void forgetGroupKeyGiven() {
        groupKeyGiven = null;
    }

    /** Whether the peer may give the key of this host's group. */
    boolean isGroupKeyServer() {
        return certificate != null && certificate.groupKeyServer()
                && address.group().equals(shared.identity().certificate().address().group());
    }

    private Map<Integer, Integer> ownSequences() {
        Map<Integer, Integer> own = new LinkedHashMap<>();
        shared.identity().revocationLists()
                .forEach(revocationList -> own.put(revocationList.authority(), revocationList.sequence()));
        return own;
    }

    private void sayRevocationLists(long now) {
        Map<Integer, Integer> own = ownSequences();
        if (session != Session.NONE && !revocationListsSaid && !own.equals(sequences)) {
            revocationListsSaid = true;
            Bytes body = own.entrySet().stream()
                    .map(entry -> Bytes.join(Bytes.of(entry.getKey()),
                            Bytes.ofNumber(entry.getValue(), SEQUENCE_LENGTH)))
                    .reduce(Bytes.EMPTY, Bytes::join);
            hand(new HostMessage(Kind.SEQUENCES, body), now);
        }
    }

    private void sequences(Bytes body, long now) {
        int length = 1 + SEQUENCE_LENGTH;
        if (body.length() % length != 0) {
            shared.count(Event.MALFORMED);
            return;
        }
        revocationListsDue = Handshake.NEVER;
        sequences.clear();
        for (int at = 0; at < body.length(); at += length) {
            sequences.put(body.at(at), (int) body.number(at + 1, at + length));
        }
        Map<Integer, Integer> own = ownSequences();
        for (RevocationList revocationList : shared.identity().revocationLists()) {
            if (revocationList.sequence() > sequences.getOrDefault(revocationList.authority(), 0)) {
                sequences.put(revocationList.authority(), revocationList.sequence());
                hand(new HostMessage(Kind.REVOCATION_LIST, revocationList.toBytes()),
                        now);
            }
        }
        if (sequences.entrySet().stream()
                .anyMatch(entry -> entry.getValue() > own.getOrDefault(entry.getKey(), 0))) {
            sayRevocationLists(now);
        }
    }

    /** A revocation list has come: whoever is not valid any more is forgotten. */
    void check() {
        if (certificate == null) {
            return;
        }
        try {
            shared.identity().check(certificate);
        } catch (HandshakeException e) {
            forget();
            failAll(Ending.valueOf(e.reason().name()));
        }
    }

    /** Forgets all that is kept of the peer, and has the board forget it. */
    void forget() {
        if (session != Session.NONE || setting != null) {
            shared.effects().deleteKey(address);
        }
        session = Session.NONE;
        setting = null;
        kept = null;
        certificate = null;
        initiated = null;
        shared.halfOpen().removeIf(run -> run.peer() == this);
    }
}
