package strangers;

import java.util.OptionalInt;
import javino.protocol.Address;
import javino.protocol.Bytes;
import strangers.edhoc.Asking;
import strangers.edhoc.HandshakeException;
import strangers.edhoc.Initiator;

/** The side that begins a handshake. */
final class Begun extends Talk {

    /** How often message 1 or a fragment of message 2 is asked for: for a message that waits, of an agent's or not. */
    static final int TRIES = 5;
    static final int FEW_TRIES = 2;
    /** The other side may lack message 3 for so long. */
    static final long THIRD_KEPT_MILLIS = 15_000;
    /** However busy the air is. */
    private static final long LIFE_MILLIS = 60_000;

    private final Asking asking;
    private final Fragments second;
    private final long end;
    private int triesLeft;
    private HandshakeException reason;
    /** Once message 2 was taken. */
    private Bytes message3;
    private boolean thirdSaid;

    Begun(Shared shared, Peer peer, Round round, int tries, long now) {
        super(shared, peer, round);
        triesLeft = tries;
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

    void start(long now) {
        triesLeft--;
        sayAll(round().first, asking.message1(), round().secondMillis, now);
    }

    @Override
    void late(long now) {
        if (!isOpen()) {
            peer().finished(this);
        } else if (now >= end || triesLeft <= 0 || reason != null && triesLeft < TRIES - 1) {
            peer().unanswered(this, reason == null ? Ending.NO_ANSWER : Ending.valueOf(reason.reason().name()), now);
        } else {
            OptionalInt lacking = second.lacking();
            if (lacking.isPresent()) {
                triesLeft--;
                want(round().second, lacking.getAsInt(), round().secondMillis, now);
            } else {
                start(now);
            }
        }
    }

    @Override
    void heard(HostWord word, long now) {
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
                reason = e;
            }
        }
        // The next fragment follows at once.
        setDeadline(Math.max(deadline(), now + round().secondMillis / 2));
    }

    @Override
    void keyIsSet(long now) {
        sayAll(round().third, message3, THIRD_KEPT_MILLIS, now);
    }

    @Override
    void wasSaid(HostWord word, long now) {
        if (word.kind() == round().third) {
            thirdSaid = true;
            setDeadline(now + THIRD_KEPT_MILLIS);
            peer().advance(now);
        }
    }

    /** Whether message 3 is still to be on the air for the first time. */
    boolean owesThird() {
        return message3 != null && !thirdSaid;
    }

    @Override
    boolean wanted(int first, long now) {
        if (isOpen() || first != round().third.first(0)) {
            return false;
        }
        sayAll(round().third, message3, THIRD_KEPT_MILLIS, now);
        return true;
    }
}
