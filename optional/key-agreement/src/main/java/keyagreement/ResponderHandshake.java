package keyagreement;

import java.util.Set;
import java.util.TreeSet;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import keyagreement.edhoc.ResponderRole;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.Responder;
import keyagreement.edhoc.Secret;

/** The side that answers a handshake. */
final class ResponderHandshake extends Handshake {

    /** How often message 3 is asked for. */
    private static final int WANTS = 2;
    /** Until it is forgotten, from the end of message 2 on. */
    static final long LIFE_MILLIS = 10_000;
    /** Before a fragment is said again: of two with one address, whose boards draw the same, one comes first. */
    static final int SPREAD_MILLIS = 200;

    private final Bytes message1;
    private final ResponderRole answering;
    private final Set<Integer> due = new TreeSet<>();
    private int wantsLeft = WANTS;
    private long end = NEVER;

    /** @throws HandshakeException if message 1 is none that can be answered. */
    ResponderHandshake(Shared shared, Peer peer, Round round, Bytes message1) throws HandshakeException {
        super(shared, peer, round);
        this.message1 = message1;
        Address self = shared.identity().certificate().address();
        answering = round == Round.FULL
                ? new Responder(shared.identity().with(peer.address()), message1, shared.random())
                : new RenewalResponder(peer.kept(), self, peer.address(), message1, shared.random());
        shared.count(Event.ANSWERED);
    }

    boolean answers(HostMessage first) {
        return first.kind() == round().first && first.body().equals(message1);
    }

    @Override
    Bytes message1() {
        return message1;
    }

    /** Says message 2; the same each time. */
    void answer(long now) {
        if (end == NEVER) {
            log(State.HALF_OPEN);
            sayAll(round().second, answering.message2(), round().thirdMillis, now);
        } else {
            for (int i = 0; i < round().second.fragments(); i++) {
                again(i, now);
            }
        }
    }

    private void again(int fragment, long now) {
        due.add(fragment);
        setDeadline(now + shared().random().nextInt(SPREAD_MILLIS));
    }

    @Override
    void wasSaid(HostMessage word, long now) {
        if (word.kind() == round().second) {
            end = now + LIFE_MILLIS;
        }
    }

    /** The board has heard a sealed message of the other side, and has no key: message 3 is lost. */
    void askForThird(long now) {
        if (end != NEVER) {
            want(round().third, 0, round().thirdMillis, now);
        }
    }

    @Override
    void late(long now) {
        if (!due.isEmpty()) {
            due.forEach(i -> say(HostMessage.fragments(round().second, peer().address(), answering.message2()).get(i),
                    round().thirdMillis, now));
            due.clear();
        } else if (end == NEVER || now >= end) {
            shared().count(Event.EXPIRED);
            log(State.OVER);
            peer().finished(this);
            peer().advance(now);
        } else if (wantsLeft > 0) {
            wantsLeft--;
            askForThird(now);
        } else {
            setDeadline(end);
        }
    }

    @Override
    boolean wanted(int part, long now) {
        for (int i = 0; i < round().second.fragments(); i++) {
            if (part == part(round().second, i)) {
                again(i, now);
                return true;
            }
        }
        return false;
    }

    @Override
    void heard(HostMessage word, long now) {
        try {
            Secret secret = answering.finish(word.body());
            Certificate certificate = answering instanceof Responder responder
                    ? Certificate.decode(responder.peer().kid()) : peer().certificate();
            Address self = shared().identity().certificate().address();
            peer().agreed(this, secret, certificate, Identity.key(secret, peer().address(), self));
        } catch (HandshakeException e) {
            refused(e);
        }
    }

    @Override
    void keyIsSet(long now) {
        peer().advance(now);
    }
}
