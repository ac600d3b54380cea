package javino.board;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.IntPredicate;
import javino.link.Link;
import javino.link.LinkException;
import javino.protocol.Bytes;
import javino.protocol.Frame;
import javino.protocol.SerialPacket;
import javino.protocol.PacketDecoder;
import javino.protocol.PollReply;
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

    private final Link link;
    private final SessionCounters counters;
    private final PacketDecoder decoder = new PacketDecoder();
    private final byte[] buffer = new byte[1024];
    private int sequence;
    /** The sequence bytes of polls that were left, and whose replies are still to come; the oldest first. */
    private final Deque<Integer> left = new ArrayDeque<>();
    private Consumer<Frame> lateReplies = reply -> {};
    private boolean replyLost;

    /** @param firstSequence that of the first request, 0…255. */
    Exchange(Link link, int firstSequence, SessionCounters counters) {
        this.link = link;
        this.counters = counters;
        this.sequence = firstSequence - 1;
    }

    /** Says who takes the replies to polls that were left; they come while a later request is asked. */
    void setLateReplies(Consumer<Frame> taker) {
        lateReplies = taker;
    }

    /**
     * Sends a request until it is answered; or leaves a poll, which the next request ends if the board holds it.
     *
     * @param timeout how long each attempt waits, from the end of the request's hold.
     * @param leaves  asked whenever something came or the link was woken: whether there is something else to send.
     * @param again   given how often the request was sent, says whether to send it once more.
     * @return nothing if there was no reply, or {@link #hasLeft}.
     * @throws LinkException     if the link broke.
     * @throws ProtocolException if a reply makes no sense.
     */
    Optional<Reply> ask(Request request, Duration timeout, BooleanSupplier leaves, IntPredicate again)
            throws LinkException, ProtocolException {
        if (request.command() == Request.Command.HELLO) {
            left.clear();
            replyLost = false;
        }
        sequence = sequence + 1 & 0xFF;
        Bytes packet = new SerialPacket(sequence, request.frame()).encode();
        byte[] bytes = Bytes.join(SEPARATOR, packet).toArray();
        counters.count(SessionCounter.REQUESTS);
        int attempts = 0;
        do {
            if (attempts > 0) {
                counters.count(SessionCounter.REPEATS);
            }
            // Every other time, as to a sketch that runs it is damage.
            boolean toBootLoader = request.command() == Request.Command.HELLO && attempts % 2 == 1;
            link.write(toBootLoader ? Bytes.join(START_SKETCH, SEPARATOR, packet).toArray() : bytes);
            attempts++;
            Optional<SerialPacket> reply = awaitReply(request.hold(), timeout, leaves);
            if (reply.isPresent()) {
                return Optional.of(Reply.decode(reply.get().frame()));
            }
        } while (!hasLeft() && again.test(attempts));
        return Optional.empty();
    }

    /** Whether the last request is a poll that was left. */
    boolean hasLeft() {
        return !left.isEmpty() && left.getLast() == sequence;
    }

    /** Whether the reply to the last request has begun to come, and seems to be a reading. */
    boolean readingComes() {
        return PollReply.isReading(sequence, decoder.begun(PollReply.FLAGS_END));
    }

    /** What became of the replies to the polls before; to be said in the next one. */
    Request.LastReply takeLastReply() {
        if (replyLost) {
            replyLost = false;
            return Request.LastReply.LOST;
        }
        return left.isEmpty() ? Request.LastReply.HERE : Request.LastReply.COMING;
    }

    private Optional<SerialPacket> awaitReply(Duration hold, Duration timeout, BooleanSupplier leaves)
            throws LinkException {
        Deadline end = Deadline.in(hold.plus(timeout));
        Deadline deadline = end;
        while (!deadline.passed()) {
            if (!hold.isZero() && leaves.getAsBoolean()) {
                left.add(sequence);
                return Optional.empty();
            }
            int count = link.read(buffer, Duration.ofNanos(Math.max(1, deadline.nanosLeft())));
            SerialPacket reply = null;
            boolean endsWhole = false;
            List<PacketDecoder.Result> results = decoder.feed(buffer, count);
            for (PacketDecoder.Result result : results) {
                endsWhole = result instanceof PacketDecoder.Found;
                if (!(result instanceof PacketDecoder.Found found)) {
                    counters.count(SessionCounter.DAMAGED_PACKETS);
                } else if (found.packet().sequence() == sequence) {
                    reply = found.packet();
                } else {
                    takeLate(found.packet());
                }
            }
            if (reply != null) {
                // The board replies in order.
                replyLost |= !left.isEmpty();
                left.clear();
                return Optional.of(reply);
            }
            if (!hold.isZero() && results.isEmpty() && count > 0 && buffer[count - 1] == 0) {
                // The board has booted, or refused the poll.
                return Optional.empty();
            }
            // Whatever else comes ends the hold, as a damaged reply may be all that comes.
            deadline = count == 0 ? deadline : endsWhole ? end : Deadline.in(timeout).orBefore(end);
        }
        if (decoder.abandon()) {
            counters.count(SessionCounter.DAMAGED_PACKETS);
        }
        return Optional.empty();
    }

    private void takeLate(SerialPacket packet) {
        if (!left.contains(packet.sequence())) {
            counters.count(SessionCounter.STALE_REPLIES);
            return;
        }
        while (left.remove() != packet.sequence()) {
            replyLost = true;
        }
        lateReplies.accept(packet.frame());
    }
}
