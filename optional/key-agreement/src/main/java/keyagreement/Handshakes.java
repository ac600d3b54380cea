package keyagreement;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;
import keyagreement.HandshakeState.Deed;
import keyagreement.HandshakeState.Input;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.Secret;

/** The handshakes under way with a peer: one that this host began, and those that it answers. */
final class Handshakes {

    private final Context context;
    private final Address peer;
    /** Null for none. */
    private Handshake begun;

    /** A deed that a handshake leaves to the peer. */
    record Left(Handshake run, Deed deed) {
    }

    Handshakes(Context context, Address peer) {
        this.context = context;
        this.peer = peer;
    }

    private Stream<Handshake> answered() {
        return context.halfOpen().stream().filter(run -> run.peer.equals(peer));
    }

    List<Handshake> all() {
        return Stream.concat(Stream.ofNullable(begun), answered()).toList();
    }

    /** The one that this host began, if there is one. */
    Optional<Handshake> begun() {
        return Optional.ofNullable(begun);
    }

    /** Whether the peer has begun one, of which nothing is proved. */
    boolean isHalfOpen() {
        return answered().findAny().isPresent();
    }

    /** Whether this host has begun one, and awaits message 2. */
    boolean isOpen() {
        return begun().filter(Handshake::isOpen).isPresent();
    }

    /** Begins one. @param kept the secret for a renewal, if there is one. */
    void begin(Optional<Secret> kept, long now) {
        begun = Handshake.begin(context, peer, kept, isHalfOpen(), now);
    }

    /** A message 1. @param kept the secret for a renewal, if there is one. */
    void first(HostMessage message, Optional<Secret> kept, long now) {
        boolean renews = message.kind() == Kind.RENEWAL_1;
        Optional<Handshake> same = answered().filter(run -> run.answers(message)).findAny();
        if (same.isPresent()) {
            same.get().again(now);
        } else if (isOpen() && context.self().value() < peer.value()) {
            context.count(Event.CROSSED);
        } else if (renews && kept.isEmpty()) {
            refuse(true, now);
        } else if (context.permits(context.answers(), now)) {
            try {
                Bytes message1 = message.body();
                context.open(Handshake.answer(context, peer, renews ? kept : Optional.empty(), message1, now));
                // The other side's comes first, if it is genuine.
                begun().ifPresent(run -> run.giveWay(now));
            } catch (HandshakeException e) {
                refuse(renews, now);
            }
        }
    }

    private void refuse(boolean renewal, long now) {
        context.count(Event.REFUSED);
        if (renewal && context.permits(context.hints(), now)) {
            context.hint(new HostMessage(Kind.WANT, peer, Bytes.of(Kind.MESSAGE_1.first(), 0)));
        }
    }

    /** A part of a message 2 or 3. */
    List<Left> heard(HostMessage message, long now) {
        return counted(step(run -> run.awaited() == message.kind() ? run.heard(message, now) : Optional.empty()));
    }

    /** The other side lacks a message; or it lacks what it would need for a renewal. */
    List<Left> wanted(int first, int fragment, long now) {
        return counted(step(run -> first == Kind.MESSAGE_1.first() && run.isOpen() && run.round == Round.RENEWAL
                ? run.step(Input.SPENT, now) : run.wanted(first, fragment, now)));
    }

    private List<Left> counted(List<Left> left) {
        if (left.isEmpty()) {
            context.count(Event.STRAY);
        }
        return left;
    }

    /** A message of one has been on the air; or it will not be, as too much waits for that. */
    List<Left> said(Effect.Broadcast broadcast, boolean onAir, long took, long now) {
        return step(run -> run.number != broadcast.handshake() ? Optional.empty()
                : onAir ? run.onAir(broadcast.message(), took, now) : run.refused(broadcast.message(), now));
    }

    /** @param urgent whether messages of an agent's wait. */
    List<Left> tick(boolean urgent, long now) {
        return step(run -> now >= run.deadline() ? run.late(urgent, now) : Optional.empty());
    }

    List<Left> step(Input input, long now) {
        return step(run -> run.step(input, now));
    }

    /** Has each take a step; if one has verified the peer, the others are over. */
    private List<Left> step(Function<Handshake, Optional<Deed>> what) {
        List<Left> left = new ArrayList<>();
        for (Handshake run : all()) {
            Optional<Deed> deed = run.state() == HandshakeState.OVER ? Optional.empty() : what.apply(run);
            deed.ifPresent(each -> left.add(new Left(run, each)));
            if (deed.equals(Optional.of(Deed.KEY))) {
                all().stream().filter(other -> other != run).forEach(Handshake::drop);
            }
        }
        forget();
        return left;
    }

    /** Ends all. */
    void drop() {
        all().forEach(Handshake::drop);
        forget();
    }

    private void forget() {
        begun = begun().filter(run -> run.state() != HandshakeState.OVER).orElse(null);
        context.halfOpen().removeIf(run -> run.state() == HandshakeState.OVER);
    }
}
