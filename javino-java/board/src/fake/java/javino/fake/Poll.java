package javino.fake;

import javino.protocol.Bytes;
import javino.protocol.Frame;

/** A poll's fields (SPEC 4.3), and what its reply is made of. */
record Poll(Bytes message) {

    /** The room for records, behind status and flags. */
    static final int ROOM = 509;
    static final int MORE = 1;
    static final int LEFT_OUT = 2;
    static final int READING = 4;
    static final int DAMAGED = 8;
    static final int TAKEN_TIMER_SHIFT = 4;

    boolean wantsPercepts() {
        return (message.at(1) & 1) != 0;
    }

    boolean wantsThemNow() {
        return (message.at(1) & 2) != 0;
    }

    boolean lostReply() {
        return (message.at(1) & 4) != 0;
    }

    /** A poll that comes again is told what it was told. */
    static Frame repeated(Frame poll) {
        Bytes message = poll.message();
        return new Frame(poll.destination(), poll.origin(),
                Bytes.join(message.slice(0, 1), Bytes.of(message.at(1) | 4), message.from(2)));
    }

    boolean replyMayCome() {
        return (message.at(1) & 8) != 0;
    }

    long holdNanos() {
        return message.number(2, 4) * 1_000_000;
    }

    long leastNanos() {
        return message.number(4, 7) * 1_000_000;
    }

    /** The number of the message taken last; -1 if none. */
    int taken() {
        return message.length() == 8 ? message.at(7) : -1;
    }

    static Bytes record(char type, Bytes value) {
        return Bytes.join(Bytes.of(type), Bytes.ofNumber(value.length(), 2), value);
    }
}
