package javino.board;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.IntPredicate;
import javino.Counts;
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
import javino.protocol.Status;

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

    private static final int MOST_SHOWN = 80;

    /** The characters of a reason (SPEC 4.2): fewer may be damage. */
    private static final int LEAST_REASON = 3;
    private static final int MOST_REASON = 200;

    /** How often bytes are read that are there when their time is over: a device that babbles is not heard for ever. */
    private static final int MOST_LATE_READS = 100;

    private final Link link;
    private final SessionContext context;
    private final Counts<SessionCounter> counters;
    private final PacketDecoder decoder = new PacketDecoder();
    private final byte[] buffer = new byte[1024];
    private int sequence;
    /** The sequence bytes of polls that were left, and whose replies are still to come; the oldest first. */
    private final Deque<Integer> left = new ArrayDeque<>();
    /** Whether the board had taken the last of them. */
    private boolean leftTaken;
    private Consumer<Frame> lateReplies = reply -> {};
    private boolean replyLost;
    private boolean saysTaken;
    private boolean overdue;
    /** Whether the board has asked again since the last hello began, and since when it is known to be there. */
    private boolean askedAgain;
    private long presentSince;
    private Duration lag = Duration.ZERO;
    /** When the board counts as lost, whatever of the last request's attempts is left. */
    private Deadline bound;
    private boolean warned;
    /** What the sketch has printed since the board took the last request, if that is no poll. */
    private final List<String> said = new ArrayList<>();
    private Optional<String> reason = Optional.empty();

    /** @param firstSequence the sequence number of the first request, 0…255. */
    Exchange(Link link, int firstSequence, SessionContext context) {
        this.link = link;
        this.context = context;
        this.counters = context.counters();
        presentSince = context.time().nanos();
        this.sequence = firstSequence - 1;
    }

    /** Says who takes the replies to polls that were left; they come while a later request is asked. */
    void setLateReplies(Consumer<Frame> taker) {
        lateReplies = taker;
    }

    /** Says whether the board sends a 0x00 when it has taken a request. */
    void setSaysTaken(boolean says) {
        saysTaken = says;
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
        said.clear();
        reason = Optional.empty();
        Optional<Reply> reply = askUntilAnswered(request, timeout, leaves, again);
        if (reply.isPresent() && reply.get().status() == Status.ACTION_FAILED) {
            reason = Optional.of(inOneLine(String.join(" ", said)))
                    .filter(text -> text.length() >= LEAST_REASON && text.length() <= MOST_REASON);
        }
        if (reason.isEmpty()) {
            said.forEach(this::warnOfPrint);
        }
        return reply;
    }

    /** What the sketch has printed before it refused the last request, an action. */
    Optional<String> reason() {
        return reason;
    }

    private Optional<Reply> askUntilAnswered(Request request, Duration timeout, BooleanSupplier leaves,
            IntPredicate again) throws LinkException, ProtocolException {
        if (request.command() == Request.Command.HELLO) {
            left.clear();
            replyLost = false;
            // A zero before the reply to hello may be that of a boot.
            saysTaken = false;
            askedAgain = false;
            presentSince = context.time().nanos();
            lag = Duration.ZERO;
        }
        overdue = false;
        Duration actionTime = context.config().actionTime();
        Duration rest = rest(request.hold().plus(timeout));
        bound = context
                .in(!left.isEmpty() ? actionTime.plus(rest) : actionTime.compareTo(rest) < 0 ? rest : actionTime);
        sequence = sequence + 1 & 0xFF;
        Bytes packet = new SerialPacket(sequence, request.frame()).encode();
        byte[] bytes = Bytes.join(SEPARATOR, packet).toArray();
        counters.count(SessionCounter.REQUESTS);
        int attempts = 0;
        do {
            if (attempts > 0) {
                counters.count(SessionCounter.REPEATS);
                // It may be answered with more than the poll, when that has a reply and this is an old one.
                replyLost |= request.command() == Request.Command.POLL;
            }
            // Every other time, as to a sketch that runs it is damage; none has to be started that has asked again.
            boolean toBootLoader = request.command() == Request.Command.HELLO && attempts % 2 == 1 && !askedAgain;
            long began = context.time().nanos();
            link.write(toBootLoader ? Bytes.join(START_SKETCH, SEPARATOR, packet).toArray() : bytes);
            // A line can stop its host, as that of an emulated board does in a pause: the board is not late by that.
            bound = bound.later(context.time().nanos() - began);
            attempts++;
            Optional<SerialPacket> reply =
                    new Attempt(request, timeout.plus(link.timeFor(bytes.length)).plus(lag), bytes).await(leaves);
            if (reply.isPresent()) {
                return Optional.of(Reply.decode(reply.get().frame()));
            }
        } while (!hasLeft() && !bound.passed() && again.test(attempts));
        return Optional.empty();
    }

    /** How long a request that is overdue is repeated: as long as one that was not taken, but one attempt at least. */
    private Duration rest(Duration attempt) {
        Duration all = context.config().replyTimeout().multipliedBy(context.config().attempts());
        return all.compareTo(attempt) < 0 ? attempt : all;
    }

    /** Whether the last request is a poll that was left. */
    boolean hasLeft() {
        return !left.isEmpty() && left.getLast() == sequence;
    }

    /**
     * How long the board has not answered a request that it has taken: the last one, or a poll that was left before it;
     * zero if that is not why the last one has no reply.
     */
    Duration overdue() {
        boolean taken = overdue || !left.isEmpty() && leftTaken;
        return taken ? context.config().actionTime().plus(rest(Duration.ZERO)) : Duration.ZERO;
    }

    /** Whether the board has asked again since the last hello began, as none of the older protocol does. */
    boolean hasAskedAgain() {
        return askedAgain;
    }

    /** The time for which a board is known to be there: since it asked again, or else since the last hello began. */
    Duration presence() {
        return Duration.ofNanos(context.time().nanos() - presentSince);
    }

    /** Says how long the sketch lets each request wait: until then none is repeated, as that only fills its buffer. */
    void setLag(Duration time) {
        lag = time;
    }

    Duration lag() {
        return lag;
    }

    /** Whether the reply to the last request has begun to come, and seems to be a reading. */
    boolean readingComes() {
        return PollReply.isReading(sequence, decoder.begun(PollReply.FLAGS_END));
    }

    /** The state of the replies to the polls before; to be said in the next one. */
    Request.LastReply takeLastReply() {
        if (replyLost) {
            replyLost = false;
            return Request.LastReply.LOST;
        }
        return left.isEmpty() ? Request.LastReply.HERE : Request.LastReply.COMING;
    }

    /** One sending of a request, until its reply is here or its time is over. */
    private final class Attempt {

        private final Duration hold;
        private final Duration timeout;
        private final byte[] bytes;
        private final boolean saysTakenNow;
        private final Deadline usual;
        private Deadline end;
        private Deadline deadline;
        private SerialPacket reply;
        private boolean taken;
        private boolean damaged;
        private boolean asked;
        private boolean repeated;

        Attempt(Request request, Duration timeout, byte[] bytes) {
            hold = request.hold();
            this.timeout = timeout;
            this.bytes = bytes;
            // An action has its time once.
            saysTakenNow = saysTaken && !overdue;
            usual = context.in(hold.plus(timeout)).orBefore(bound);
            end = usual;
            deadline = usual;
        }

        Optional<SerialPacket> await(BooleanSupplier leaves) throws LinkException {
            int late = 0;
            while (late < MOST_LATE_READS) {
                // If this thread stood still, the reply may be here: the board is not late by that.
                boolean isLate = deadline.passed();
                if (!hold.isZero() && leaves.getAsBoolean()) {
                    left.add(sequence);
                    leftTaken = taken;
                    return Optional.empty();
                }
                int count = link.read(buffer, Duration.ofNanos(Math.max(1, deadline.nanosLeft())));
                take(decoder.feed(buffer, count), count > 0);
                if (reply != null) {
                    // The board replies in order.
                    replyLost |= !left.isEmpty();
                    left.clear();
                    return Optional.of(reply);
                }
                if (asked && !hold.isZero()) {
                    return Optional.empty();
                }
                if (asked && !repeated) {
                    // Once an attempt, so that they last for as long as damage may.
                    repeated = true;
                    counters.count(SessionCounter.REPEATS);
                    link.write(bytes);
                }
                asked = false;
                if (context.queue().isClosed()) {
                    deadline = deadline.orBefore(usual);
                }
                late = !isLate ? 0 : count == 0 ? MOST_LATE_READS : late + 1;
            }
            overdue |= taken && deadline.equals(end);
            // A text goes on to the zero of a request that is taken.
            if ((decoder.packetComes() || !saysTaken) && decoder.abandon()) {
                counters.count(SessionCounter.DAMAGED_PACKETS);
            }
            return Optional.empty();
        }

        private void take(List<PacketDecoder.Result> results, boolean came) {
            boolean spoiled = false;
            for (PacketDecoder.Result result : results) {
                if (result instanceof PacketDecoder.Found found) {
                    spoiled = false;
                    deadline = end;
                    take(found.packet());
                } else if (result instanceof PacketDecoder.Empty empty) {
                    take(empty);
                } else if (result instanceof PacketDecoder.Printed printed) {
                    print(printed.text(), hold.isZero() && taken && reply == null);
                } else {
                    counters.count(SessionCounter.DAMAGED_PACKETS);
                    damaged = true;
                    spoiled = true;
                }
            }
            // A damaged reply may be all that comes.
            if (spoiled || came && decoder.packetComes()) {
                deadline = context.in(timeout).orBefore(end);
            }
        }

        private void take(SerialPacket packet) {
            if (packet.sequence() == sequence) {
                reply = packet;
            } else {
                takeLate(packet);
            }
        }

        private void take(PacketDecoder.Empty empty) {
            if (empty.asksAgain()) {
                presentSince = askedAgain ? presentSince : context.time().nanos();
                askedAgain = true;
                // The zero before it was none of a request that was taken.
                asked = true;
                taken = false;
                end = context.in(hold.plus(timeout));
                deadline = end;
            } else if (saysTakenNow) {
                zeroCame();
            } else {
                // A board of an earlier library has booted, or refused the poll.
                asked |= !hold.isZero();
            }
        }

        /** Unless it is that of a poll that was left: the board replies in order, but perhaps damaged. */
        private void zeroCame() {
            if (!taken && (left.isEmpty() || damaged && hold.isZero())) {
                taken = true;
                end = context.in(hold.plus(context.config().actionTime()));
                bound = context.in(context.config().actionTime().plus(rest(hold.plus(timeout))));
                deadline = end;
            } else {
                leftTaken |= !left.isEmpty();
            }
        }
    }

    /** @param byRequest whether the request may have printed it, and not what else there is in the sketch. */
    private void print(String text, boolean byRequest) {
        counters.count(SessionCounter.PRINTED_TEXTS);
        context.listener().tell(listener -> listener.printed(text));
        if (byRequest) {
            said.add(text);
        } else {
            warnOfPrint(text);
        }
    }

    private static String inOneLine(String text) {
        return text.strip().replaceAll("\\s+", " ");
    }

    private void warnOfPrint(String text) {
        // Text that setup() prints harms nobody.
        if (saysTaken && !warned) {
            warned = true;
            String line = inOneLine(text);
            context.listener().warn("the sketch prints on the line of the protocol, which delays it: \""
                    + (line.length() > MOST_SHOWN ? line.substring(0, MOST_SHOWN) + "…" : line)
                    + "\"; remove that print, or use another serial port for it");
        }
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
