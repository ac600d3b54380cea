package keyagreement;

import java.util.OptionalInt;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import keyagreement.edhoc.InitiatorRole;
import keyagreement.edhoc.HandshakeException;
import keyagreement.edhoc.Initiator;

/** The side that begins a handshake. */
final class InitiatorHandshake extends Handshake {

    /** How often message 1 or a fragment of message 2 is asked for: for a message that waits, of an agent's or not. */
    private static final int TRIES = 5;
    private static final int FEW_TRIES = 2;
    /** The other side may lack message 3 for so long. */
    static final long THIRD_KEPT_MILLIS = 15_000;
    /** However busy the air is. */
    private static final long LIFE_MILLIS = 60_000;

    /** From one fragment of message 2 to the next one, and where it is clear that one is lost. */
    private static final int NEXT_MILLIS = 700;
    private static final int SOON_MILLIS = 100;

    private final InitiatorRole asking;
    private final Fragments second;
    private final long end;
    private int tries;
    /** The last that was said is a WANT: if nothing comes of it, the other side may have forgotten message 1. */
    private boolean wanted;
    private boolean disturbed;
    private Ending outcome = Ending.NO_ANSWER;
    /** Once message 2 was taken. */
    private Bytes message3;
    private boolean thirdSaid;

    InitiatorHandshake(Shared shared, Peer peer, Round round, long now) {
        super(shared, peer, round);
        end = now + LIFE_MILLIS;
        second = new Fragments(round.second.fragments());
        Address self = shared.identity().certificate().address();
        asking = round == Round.FULL ? new Initiator(shared.identity().with(peer.address()), shared.random())
                : new RenewalInitiator(peer.kept(), self, peer.address(), shared.random());
        shared.count(round == Round.FULL ? Event.BEGUN : Event.RENEWALS_BEGUN);
    }

    /** Whether message 2 is still awaited. */
    boolean isOpen() {
        return message3 == null;
    }

    /** Whether message 3 has been on the air: only then the other side can have the key. */
    boolean hasSaidThird() {
        return thirdSaid;
    }

    /** The other side is there: it tries to send something. */
    void isThere() {
        tries = 0;
    }

    private boolean hasTriedEnough(long now) {
        return now >= end || tries >= (round() == Round.FULL && peer().isWaiting() ? TRIES : FEW_TRIES);
    }

    /** What is tried while others are on the air does not count. */
    @Override
    void giveWay(long now) {
        super.giveWay(now);
        disturbed = true;
    }

    private void tried() {
        tries += disturbed ? 0 : 1;
        disturbed = false;
    }

    @Override
    Bytes message1() {
        return asking.message1();
    }

    void start(long now) {
        log(State.OPEN);
        tried();
        sayAll(round().first, asking.message1(), round().secondMillis, now);
    }

    @Override
    void late(long now) {
        if (!isOpen()) {
            peer().finished(this);
        } else if (hasTriedEnough(now)) {
            peer().unanswered(this, outcome, now);
        } else {
            OptionalInt lacking = second.lacking();
            wanted = lacking.isPresent() && !wanted;
            if (wanted) {
                tried();
                want(round().second, lacking.getAsInt(), round().secondMillis, now);
            } else {
                start(now);
            }
        }
    }

    @Override
    void heard(HostMessage word, long now) {
        if (!isOpen()) {
            shared().count(Event.STRAY);
            return;
        }
        for (Bytes message2 : second.add(word.fragment(), word.body())) {
            try {
                message3 = asking.message3(message2);
                Certificate certificate = asking instanceof Initiator initiator
                        ? Certificate.decode(initiator.peer().kid()) : peer().certificate();
                setDeadline(NEVER);
                Address self = shared().identity().certificate().address();
                peer().agreed(this, asking.secret(), certificate,
                        Identity.key(asking.secret(), self, peer().address()));
                return;
            } catch (HandshakeException e) {
                refused(e);
                // What is not proved may be anybody's, and tells nothing.
                if (e.reason() != HandshakeException.Reason.NOT_CERTIFIED) {
                    outcome = Ending.valueOf(e.reason().name());
                }
            }
        }
        wanted = false;
        // Fragments come in their order: one that lacks before this is lost, and the next one follows at once.
        awaitMore(now + (second.lacking().orElse(0) < word.fragment() ? SOON_MILLIS : NEXT_MILLIS)
                + shared().random().nextInt(SOON_MILLIS));
    }

    @Override
    void keyIsSet(long now) {
        sayAll(round().third, message3, THIRD_KEPT_MILLIS, now);
    }

    @Override
    void wasSaid(HostMessage word, long now) {
        if (word.kind() == round().third) {
            thirdSaid = true;
            setDeadline(now + THIRD_KEPT_MILLIS);
            peer().advance(now);
        }
    }

    @Override
    boolean wanted(int part, long now) {
        if (isOpen() || part != part(round().third, 0)) {
            return false;
        }
        sayAll(round().third, message3, THIRD_KEPT_MILLIS, now);
        return true;
    }
}
