package javino.board;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import java.util.function.IntPredicate;
import javino.link.Link;
import javino.link.LinkException;
import javino.protocol.Bytes;
import javino.protocol.Packet;
import javino.protocol.PacketDecoder;
import javino.protocol.ProtocolException;
import javino.protocol.Reply;
import javino.protocol.Request;

/** Asks one request after the other over an open link, and finds each one's reply (SPEC 4.2). */
final class Exchange {

    /** An empty packet, which ends what damage may have left open at the other side. */
    private static final Bytes SEPARATOR = Bytes.of(0);

    /**
     * Has a Mega's boot loader start the sketch: CMD_LEAVE_PROGMODE_ISP of STK500 version 2 (Atmel AVR068), the first
     * message, of one byte. A byte that comes in the first second after a reset has this boot loader wait for a new
     * sketch, some 5 s from each further one on: a host that says hello until it is answered would wait for ever.
     */
    private static final Bytes START_SKETCH = Bytes.of(0x1B, 0x01, 0x00, 0x01, 0x0E, 0x11, 0x04);

    /** What a board takes to find its answer. */
    private static final Duration THINKING = Duration.ofMillis(1);
    /** The longest that a reply is left to gather: one that is shorter than the last must not wait for long. */
    private static final Duration MOST_GATHERING = Duration.ofMillis(8);

    private final Link link;
    private final SessionCounters counters;
    private final PacketDecoder decoder = new PacketDecoder();
    private final Deque<PacketDecoder.Result> arrived = new ArrayDeque<>();
    private final byte[] buffer = new byte[1024];
    private int sequence;
    private int replyLength;

    /** @param firstSequence that of the first request, 0…255. */
    Exchange(Link link, int firstSequence, SessionCounters counters) {
        this.link = link;
        this.counters = counters;
        this.sequence = firstSequence - 1;
    }

    /**
     * Sends a request until it is answered.
     *
     * @param timeout how long each attempt waits.
     * @param again   given how often the request was sent, says whether to send it once more.
     * @return nothing if there was no reply.
     * @throws LinkException     if the link broke.
     * @throws ProtocolException if the reply makes no sense.
     */
    Optional<Reply> ask(Request request, Duration timeout, IntPredicate again)
            throws LinkException, ProtocolException {
        sequence = sequence + 1 & 0xFF;
        Bytes packet = new Packet(sequence, request.frame()).encode();
        byte[] bytes = Bytes.join(SEPARATOR, packet).toArray();
        byte[] toBootLoader = Bytes.join(START_SKETCH, SEPARATOR, packet).toArray();
        counters.count(SessionCounter.REQUESTS);
        int attempts = 0;
        do {
            if (attempts > 0) {
                counters.count(SessionCounter.REPEATS);
            }
            // Every other time, as to a sketch that runs it is damage.
            link.write(request.command() == Request.Command.HELLO && attempts % 2 == 1 ? toBootLoader : bytes);
            attempts++;
            gather(bytes.length + replyLength);
            Optional<Packet> reply = awaitReply(Deadline.in(timeout));
            if (reply.isPresent()) {
                return Optional.of(Reply.decode(reply.get().frame()));
            }
        } while (again.test(attempts));
        return Optional.empty();
    }

    /**
     * Waits until a reply as long as the last one is likely to be there whole. A serial line gives a few bytes at a
     * time, and being woken for each few of fifty replies a second would be most of what an idle agent costs.
     */
    private void gather(int bytes) {
        Duration line = link.timeFor(bytes);
        if (!line.isZero()) {
            Duration whole = line.plus(THINKING);
            LockSupport.parkNanos(Math.min(whole.toNanos(), MOST_GATHERING.toNanos()));
        }
    }

    private Optional<Packet> awaitReply(Deadline deadline) throws LinkException {
        int received = 0;
        while (true) {
            Optional<Packet> reply = takeArrived();
            if (reply.isPresent()) {
                replyLength = received;
                return reply;
            }
            if (deadline.passed()) {
                if (decoder.abandon()) {
                    counters.count(SessionCounter.DAMAGED_PACKETS);
                }
                return Optional.empty();
            }
            int count = link.read(buffer, Duration.ofNanos(Math.max(1, deadline.nanosLeft())));
            received += count;
            arrived.addAll(decoder.feed(buffer, count));
        }
    }

    /** The reply that is waited for, if it is among what arrived; all before it is counted and dropped. */
    private Optional<Packet> takeArrived() {
        while (!arrived.isEmpty()) {
            if (!(arrived.remove() instanceof PacketDecoder.Found found)) {
                counters.count(SessionCounter.DAMAGED_PACKETS);
            } else if (found.packet().sequence() != sequence) {
                counters.count(SessionCounter.STALE_REPLIES);
            } else {
                return Optional.of(found.packet());
            }
        }
        return Optional.empty();
    }
}
