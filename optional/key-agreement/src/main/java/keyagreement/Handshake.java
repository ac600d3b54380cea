package keyagreement;

import java.util.HashMap;
import java.util.Map;
import javino.board.Transitions;
import javino.protocol.Airtime;
import javino.protocol.Bytes;
import javino.protocol.HostMessage;
import javino.protocol.HostMessage.Kind;
import javino.protocol.Frame;
import keyagreement.edhoc.HandshakeException;

/** A handshake that is under way with a peer, on either side. */
abstract class Handshake {

    static final long NEVER = Long.MAX_VALUE;
    /** The same fragment again: not before, so that no board takes it for a repeat of its own (SPEC 7.2). */
    static final long AGAIN_MILLIS = 450;
    /** Fragments said again in a handshake, at most. */
    static final int MOST_REPEATS = 12;
    /** So long after its own last word it has been put off enough, whoever speaks. */
    private static final long PUT_OFF_MILLIS = 5000;
    /** For what waits to be on the air. */
    private static final long AIR_MILLIS = 30_000;
    /** So many times what a fragment had to wait for the air, the answer may wait too. */
    private static final int WAITED_TIMES = 3;
    /** After a fragment of others, at least, and again as a random part: their next one comes sooner. */
    private static final int OTHERS_MILLIS = 600;

    /** Where a handshake is. */
    enum State {
        OPEN, HALF_OPEN, SETTING, DONE, OVER
    }

    /** The two ways to agree on a key. */
    enum Round {
        /** By certificates. */
        FULL(Kind.MESSAGE_1, Kind.MESSAGE_2, Kind.MESSAGE_3,
                1200, 1400),
        /** By what both have kept. */
        RENEWAL(Kind.RENEWAL_1, Kind.RENEWAL_2,
                Kind.RENEWAL_3, 800, 1000);

        final Kind first;
        final Kind second;
        final Kind third;
        final long secondMillis;
        final long thirdMillis;

        Round(Kind first, Kind second, Kind third,
                long secondMillis, long thirdMillis) {
            this.first = first;
            this.second = second;
            this.third = third;
            this.secondMillis = secondMillis;
            this.thirdMillis = thirdMillis;
        }
    }

    private final Shared shared;
    private final Peer peer;
    private final Round round;
    private final Map<Integer, Long> said = new HashMap<>();
    private int repeats;
    private long deadline = NEVER;
    private long latest = NEVER;

    Handshake(Shared shared, Peer peer, Round round) {
        this.shared = shared;
        this.peer = peer;
        this.round = round;
    }

    /** Message 1, which both sides have. */
    abstract Bytes message1();

    /** Has it known where it is, before anything follows from that. */
    void log(State state) {
        Transitions.log(this instanceof InitiatorHandshake ? "initiator" : "responder",
                shared.identity().certificate().address(), peer.address(),
                message1().slice(Integer.BYTES, 2 * Integer.BYTES).hex(), state);
    }

    Shared shared() {
        return shared;
    }

    Peer peer() {
        return peer;
    }

    Round round() {
        return round;
    }

    long deadline() {
        return deadline;
    }

    void setDeadline(long when) {
        deadline = when;
    }

    /** Sets the deadline by what has come, which anybody can have said: so nobody can put it off for ever. */
    void awaitMore(long until) {
        deadline = Math.min(until, latest);
    }

    /** Puts off what is to be done, as others are on the air. */
    void giveWay(long now) {
        long quiet = now + OTHERS_MILLIS + shared.random().nextInt(OTHERS_MILLIS);
        deadline = Math.max(deadline, Math.min(quiet, latest));
    }

    /**
     * Says a word, and waits for an answer: so long from the end on, with a random part so that two do not collide
     * again, and longer where it had to wait for the air itself.
     */
    void say(HostMessage word, long wait, long now) {
        int part = part(word.kind(), word.fragment());
        if (!mayBeSaid(part, now)) {
            shared.count(Event.LIMITED);
            deadline = Math.max(deadline, now + AGAIN_MILLIS);
            return;
        }
        boolean taken = shared.broadcasts().say(word, now, (then, took) -> {
            said.put(part, then);
            latest = then + PUT_OFF_MILLIS;
            deadline = then + wait + shared.random().nextInt((int) wait / 3)
                    + WAITED_TIMES * Math.max(0, took - airMillis(word));
            wasSaid(word, then);
        });
        if (taken) {
            said.put(part, NEVER);
        }
        deadline = now + (taken ? AIR_MILLIS : AGAIN_MILLIS);
    }

    private boolean mayBeSaid(int part, long now) {
        Long before = said.get(part);
        if (before == null) {
            return true;
        }
        if (before == NEVER || now - before < AGAIN_MILLIS || repeats == MOST_REPEATS) {
            return false;
        }
        repeats++;
        shared.count(Event.REPEATED);
        return true;
    }

    /** The word has been on the air. */
    void wasSaid(HostMessage word, long now) {
    }

    /** Says all fragments of a message. */
    void sayAll(Kind kind, Bytes message, long wait, long now) {
        HostMessage.fragments(kind, peer.address(), message).forEach(word -> say(word, wait, now));
    }

    /** Asks for a fragment. */
    void want(Kind kind, int fragment, long wait, long now) {
        say(new HostMessage(Kind.WANT, peer.address(), Bytes.of(kind.first(), fragment)), wait, now);
    }

    /** A fragment as a {@code WANT} names it. */
    static int part(Kind kind, int fragment) {
        return kind.first() << Byte.SIZE | fragment;
    }

    /** What it takes of the air at 2000 bit/s, in ms. */
    private static long airMillis(HostMessage word) {
        return Airtime.millis(Frame.HEADER_LENGTH + word.encode().length());
    }

    /** The other side lacks a fragment. Tells whether there is one. */
    abstract boolean wanted(int part, long now);

    /** The next message of the other side, or a part of it; of the right round. */
    abstract void heard(HostMessage word, long now);

    /** The deadline is over. */
    abstract void late(long now);

    /** The board has the key. */
    abstract void keyIsSet(long now);

    void refused(HandshakeException why) {
        shared.count(Event.REFUSED);
    }
}
