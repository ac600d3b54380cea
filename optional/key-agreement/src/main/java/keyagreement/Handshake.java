package keyagreement;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import javino.protocol.Address;
import javino.protocol.Airtime;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;
import javino.protocol.Key;
import keyagreement.HandshakeState.Deed;
import keyagreement.HandshakeState.Input;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.Initiator;
import keyagreement.edhoc.Responder;
import keyagreement.edhoc.Role;
import keyagreement.edhoc.Secret;

/** A handshake with a peer, on either side: it is told what happens, says what is due, and tells its peer the rest. */
final class Handshake {

    /** So long after its own last message it has been put off enough, whoever speaks. */
    private static final long PUT_OFF_MILLIS = 5000;
    /** For what waits to be on the air. */
    private static final long AIR_MILLIS = 30_000;
    /** So many times what a message had to wait for the air, the answer may wait too. */
    private static final int WAITED_TIMES = 3;
    /** After a message for others, at least, and again as a random part: their next one comes sooner. */
    private static final int OTHERS_MILLIS = 600;
    /** From one fragment of message 2 to the next one, and where it is clear that one is lost. */
    private static final int NEXT_MILLIS = 900;
    private static final int SOON_MILLIS = 100;
    /** How often message 1 or a fragment of message 2 is asked for: for a message that waits, of an agent's or not. */
    private static final int TRIES = 5;
    private static final int FEW_TRIES = 2;
    /** How often message 3 is asked for. */
    private static final int WANTS = 2;
    /** The longest life of an initiator, however busy the air is; of a responder, from the end of message 2 on. */
    private static final long LIFE_MILLIS = 60_000;
    private static final long HALF_OPEN_MILLIS = 10_000;
    /** The other side may lack message 3 for so long. */
    private static final int THIRD_KEPT_MILLIS = 15_000;
    /** Before a fragment is said again: of two with one address, whose boards draw the same, one comes first. */
    static final int SPREAD_MILLIS = 200;

    final Address peer;
    final Round round;
    final int number;
    private final Context context;
    /** The one that a responder answers; else null. */
    private final Bytes message1;
    private final Role role;
    private final Fragments parts;
    private final Repeats repeats;
    private final Set<Integer> due = new TreeSet<>();
    private HandshakeState state;
    private int tries;
    private boolean disturbed;
    private long deadline = Context.NEVER;
    private long latest = Context.NEVER;
    private long end = Context.NEVER;
    private Ending failure = Ending.NO_ANSWER;
    private Role.Agreed agreed;
    private Optional<Certificate> certificate;

    private Handshake(Context context, Address peer, Round round, HandshakeState state, Bytes message1, Role role) {
        this.context = context;
        this.peer = peer;
        this.round = round;
        this.message1 = message1;
        this.role = role;
        parts = new Fragments(awaited().fragments());
        repeats = new Repeats(context);
        number = context.handshakes().incrementAndGet();
        enter(state);
    }

    /** Begins one. @param kept from the last one, for a renewal. @param later if the other side may have begun one. */
    static Handshake begin(Context context, Address peer, Optional<Secret> kept, boolean later, long now) {
        Round round = kept.isPresent() ? Round.RENEWAL : Round.FULL;
        context.count(round == Round.FULL ? Event.BEGUN : Event.RENEWALS_BEGUN);
        Handshake begun = new Handshake(context, peer, round, HandshakeState.WAITING, null, kept.isPresent()
                ? Renewal.begin(kept.get(), context.self(), peer, context.random())
                : new Initiator(context.identity().with(peer), context.random()));
        begun.end = now + LIFE_MILLIS;
        if (later) {
            begun.deadline = now + round.thirdMillis + begun.random(round.thirdMillis);
        } else {
            begun.step(Input.LATE, now);
        }
        return begun;
    }

    /** Answers one. @throws HandshakeException if message 1 is none that can be answered. */
    static Handshake answer(Context context, Address peer, Optional<Secret> kept, Bytes message1, long now)
            throws HandshakeException {
        Role role = kept.isPresent()
                ? Renewal.answer(kept.get(), context.self(), peer, message1, context.random())
                : new Responder(context.identity().with(peer), message1, context.random());
        context.count(Event.ANSWERED);
        Handshake answered = new Handshake(context, peer, kept.isPresent() ? Round.RENEWAL : Round.FULL,
                HandshakeState.ANSWERING, message1, role);
        answered.perform(Deed.SECOND, now);
        return answered;
    }

    HandshakeState state() {
        return state;
    }

    long deadline() {
        return deadline;
    }

    /** Why it has failed: what somebody has proved of the address. */
    Ending failure() {
        return failure;
    }

    Secret secret() {
        return agreed.secret();
    }

    /** The peer's; nothing if it was known before. */
    Optional<Certificate> certificate() {
        return certificate;
    }

    Key key() {
        return isInitiator() ? Identity.key(secret(), context.self(), peer)
                : Identity.key(secret(), peer, context.self());
    }

    /** Whether this host has begun it. */
    boolean isInitiator() {
        return message1 == null;
    }

    /** Whether it has begun it, and awaits message 2. */
    boolean isOpen() {
        return state == HandshakeState.WAITING || state == HandshakeState.OPEN || state == HandshakeState.ASKING;
    }

    /** The kind of message that it awaits. */
    Kind awaited() {
        return isInitiator() ? round.second : round.third;
    }

    boolean answers(HostMessage first) {
        return first.kind() == round.first && first.body().equals(message1);
    }

    // Inputs

    /** Takes a step. Tells what is left to its peer; nothing if the input is ignored. */
    Optional<Deed> step(Input input, long now) {
        Table.Cell<HandshakeState, Deed> cell = HandshakeState.TABLE.cell(state, input);
        if (cell.isIgnored()) {
            return Optional.empty();
        }
        if (state != cell.next()) {
            enter(cell.next());
        }
        perform(cell.deed(), now);
        return Optional.of(cell.deed());
    }

    /** Another one has given the key, or the board has not taken it, or the peer is forgotten. */
    void drop() {
        enter(HandshakeState.OVER);
    }

    private void enter(HandshakeState next) {
        state = next;
        Bytes first = isInitiator() ? role.opening() : message1;
        context.effects().add(new Effect.Transition(isInitiator() ? "initiator" : "responder", peer,
                first.slice(Integer.BYTES, 2 * Integer.BYTES).hex(), next));
    }

    /** The deadline is over. @param urgent whether messages of an agent's wait. */
    Optional<Deed> late(boolean urgent, long now) {
        boolean lacks = isInitiator() ? parts.lacking().isPresent() : tries < WANTS;
        tries += !isInitiator() && state == HandshakeState.ANSWERED && lacks ? 1 : 0;
        Optional<Deed> deed =
                step(now >= end || isInitiator() && tries >= (round == Round.FULL && urgent ? TRIES : FEW_TRIES)
                        ? Input.SPENT : lacks ? Input.LACKING : Input.LATE, now);
        if (deed.isEmpty()) {
            deadline = Context.NEVER;
        }
        return deed;
    }

    /** Others are on the air: puts off what is to be done. Attempts meanwhile do not count. */
    void giveWay(long now) {
        deadline = Math.max(deadline, Math.min(now + OTHERS_MILLIS + random(OTHERS_MILLIS), latest));
        disturbed = true;
    }

    /** A part of message 2 or 3 has come. */
    Optional<Deed> heard(HostMessage part, long now) {
        if (HandshakeState.TABLE.cell(state, Input.VERIFIED).isIgnored()) {
            return Optional.empty();
        }
        for (Bytes message : parts.add(part.fragment(), part.body())) {
            try {
                Role.Agreed proved = role.take(message);
                certificate = proved.peer().isEmpty() ? Optional.empty()
                        : Optional.of(Certificate.decode(proved.peer().get().kid()));
                agreed = proved;
                return step(Input.VERIFIED, now);
            } catch (HandshakeException e) {
                context.count(Event.REFUSED);
                // An unproved message may be anybody's, and tells nothing.
                failure = e.reason() == HandshakeException.Reason.NOT_CERTIFIED ? failure
                        : Ending.valueOf(e.reason().name());
            }
        }
        if (step(Input.PART, now).isPresent()) {
            // Fragments come in their order: one that lacks before this is lost, and the next one follows at once. What
            // has come anybody can have said, so nobody can put it off for ever.
            deadline = Math.min(latest, now + random(SOON_MILLIS)
                    + (parts.lacking().orElse(0) < part.fragment() ? SOON_MILLIS : NEXT_MILLIS));
        }
        return Optional.of(Deed.NOTHING);
    }

    /** The same message 1 has come again. */
    void again(long now) {
        if (step(Input.AGAIN, now).isPresent()) {
            IntStream.range(0, round.second.fragments()).forEach(due::add);
        }
    }

    /** The other side lacks a message, of which it asks for a fragment. */
    Optional<Deed> wanted(int first, int fragment, long now) {
        Kind own = isInitiator() ? round.third : round.second;
        Optional<Deed> deed = first == own.first() && fragment < own.fragments() ? step(Input.WANTED, now)
                : Optional.empty();
        deed.ifPresent(each -> due.add(fragment));
        return deed;
    }

    /** A message of it has been on the air. @param took ms since it was to be said. */
    Optional<Deed> onAir(HostMessage message, long took, long now) {
        int wait = wait(message.kind());
        repeats.onAir(message, now);
        latest = now + PUT_OFF_MILLIS;
        // A random part, so that two do not collide again; and longer where the message had to wait for the air itself.
        deadline = now + wait + random(wait / 3) + WAITED_TIMES * Math.max(0, took
                - Airtime.millis(Frame.HEADER_LENGTH + message.encode().length()));
        return message.kind() == round.second || message.kind() == round.third ? step(Input.ON_AIR, now)
                : Optional.empty();
    }

    private int wait(Kind kind) {
        return kind == round.third ? THIRD_KEPT_MILLIS : isInitiator() ? round.secondMillis : round.thirdMillis;
    }

    /** A message of it will not be on the air, as too much waits for that. */
    Optional<Deed> refused(HostMessage message, long now) {
        repeats.refused(message);
        deadline = now + Repeats.AGAIN_MILLIS;
        return Optional.empty();
    }

    // Deeds

    private void perform(Deed deed, long now) {
        deadline = switch (deed) {
            case NOTHING, FAIL -> deadline;
            case ANEW -> {
                tries = 0;
                yield deadline;
            }
            case FIRST -> {
                tried();
                yield say(HostMessage.fragments(round.first, peer, role.opening()), now);
            }
            case SECOND -> say(HostMessage.fragments(round.second, peer, role.opening()), now);
            case THIRD -> say(HostMessage.fragments(round.third, peer, agreed.answer()), now);
            case WANT -> {
                if (isInitiator()) {
                    tried();
                }
                yield say(List.of(new HostMessage(Kind.WANT, peer,
                        Bytes.of(awaited().first(), parts.lacking().orElse(0)))), now);
            }
            case SAY -> {
                List<HostMessage> all = HostMessage.fragments(round.second, peer, role.opening());
                List<HostMessage> wanted = due.stream().map(all::get).toList();
                due.clear();
                yield say(wanted, now);
            }
            case LATER -> now + random(SPREAD_MILLIS);
            case KEEP -> {
                end = isInitiator() ? end : now + HALF_OPEN_MILLIS;
                yield isInitiator() ? now + THIRD_KEPT_MILLIS : deadline;
            }
            case IDLE -> end;
            case KEY -> Context.NEVER;
        };
    }

    private void tried() {
        tries += disturbed ? 0 : 1;
        disturbed = false;
    }

    /** Tells until when an answer is awaited. */
    private long say(List<HostMessage> messages, long now) {
        long until = deadline;
        for (HostMessage message : messages) {
            boolean taken = repeats.take(message, now);
            until = taken ? now + AIR_MILLIS : Math.max(until, now + Repeats.AGAIN_MILLIS);
            if (taken) {
                context.effects().add(new Effect.Broadcast(number, message));
            }
        }
        return until;
    }

    private int random(int below) {
        return context.random().nextInt(below);
    }
}
