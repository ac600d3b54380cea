package campaign;

import java.util.BitSet;

import harness.Report;
import javino.protocol.Content;
import javino.protocol.Outcome;

/**
 * The account of all unicasts from one host to another, by what both hosts know. Numbers count from 0. Safe to be told
 * things by both hosts' threads.
 */
final class Ledger {

    private final int length;
    private final BitSet received = new BitSet();
    private final BitSet delivered = new BitSet();
    private int offered;
    private int refused;
    private int undelivered;
    private int unknown;
    private int wrong;
    private int twice;

    /** @param length the length of each content, in bytes. */
    Ledger(int length) {
        this.length = length;
    }

    /** The sum of a ledger, or of several together. Each number is one of messages. */
    record Sum(long offered, long refused, long delivered, long undelivered, long unknown, long received, long lost,
            long wrong, long twice) {

        static final Sum ZERO = new Sum(0, 0, 0, 0, 0, 0, 0, 0, 0);

        Sum plus(Sum other) {
            return new Sum(offered + other.offered, refused + other.refused, delivered + other.delivered,
                    undelivered + other.undelivered, unknown + other.unknown, received + other.received,
                    lost + other.lost,
                    wrong + other.wrong, twice + other.twice);
        }

        /** The number of messages whose end is not known yet. */
        long open() {
            return offered - ended();
        }

        /** The number of messages whose end is known. */
        long ended() {
            return refused + delivered + undelivered + unknown;
        }

        /** Reports what must never be. */
        void report(Report report) {
            report.never("delivered with another content than was sent", wrong);
            report.never("delivered twice", twice);
            report.never("reported delivered, but not received", lost);
        }
    }

    /** The number of the next message to be sent. */
    synchronized int next() {
        return offered++;
    }

    /** The content of the message of a number. */
    Content content(int number) {
        return Contents.of(number, length);
    }

    /** The board did not take it. */
    synchronized void refused() {
        refused++;
        notifyAll();
    }

    /** The host lost its board while it handed the message over. */
    synchronized void unknown() {
        unknown++;
        notifyAll();
    }

    /** The sender's host was told how a message ended. */
    synchronized void ended(int number, Outcome outcome) {
        if (outcome == Outcome.DELIVERED) {
            delivered.set(number);
        } else {
            undelivered++;
        }
        notifyAll();
    }

    /** The receiver's host was handed a message. */
    synchronized void received(Content content) {
        int number = Contents.number(content);
        if (number < 0 || number >= offered || content.encode().length() != length) {
            wrong++;
        } else if (received.get(number)) {
            twice++;
        } else {
            received.set(number);
        }
    }

    /** The receiver's host was handed a message of somebody else. */
    synchronized void strayed() {
        wrong++;
    }

    /** How many were reported delivered until now. */
    synchronized long delivered() {
        return delivered.cardinality();
    }

    /** All until now. A message counts as lost as soon as it is reported delivered without having been received. */
    synchronized Sum sum() {
        BitSet lost = (BitSet) delivered.clone();
        lost.andNot(received);
        return new Sum(offered, refused, delivered.cardinality(), undelivered, unknown, received.cardinality(),
                lost.cardinality(),
                wrong, twice);
    }
}
