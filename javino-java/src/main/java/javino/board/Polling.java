package javino.board;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.Content;
import javino.protocol.Outcome;
import javino.protocol.PollReply;
import javino.protocol.ProtocolException;
import javino.protocol.Request;

/** Makes polls, and turns what they bring into calls of the listener. For the session's thread only. */
final class Polling {

    private final Context context;
    private final Perception perception;
    /** The ends that the board is yet to tell, by numbers, which hold for one boot of the board. */
    private final Map<Integer, CompletableFuture<Outcome>> underWay = new LinkedHashMap<>();
    private final RepeatFilter repeats = new RepeatFilter();
    /** The board that the numbers below are of; null if it has booted since it was greeted. */
    private BoardInfo source;
    private int taken = Request.NOTHING_TAKEN;
    private boolean owesTaken;
    /** Whether the last poll asked for percepts. */
    private boolean asksPercepts;
    private boolean isLast;
    /** Whether percepts came just now, so that the next poll, made at once, is for what may have had no room. */
    private boolean perceptsCrowd;

    Polling(Context context) {
        this.context = context;
        perception = context.perception();
    }

    /** A board came online; after a boot it counts messages and transmissions anew. */
    void greeted(BoardInfo board) {
        if (!board.equals(source)) {
            taken = Request.NOTHING_TAKEN;
            owesTaken = false;
            repeats.booted();
            abandonAll();
        }
        perceptsCrowd = false;
        source = board;
        perception.forget();
    }

    /** The same board has a new address. */
    void renamed(BoardInfo board) {
        source = board;
    }

    /** The board said that it has booted since it was greeted. */
    void reset() {
        source = null;
    }

    /** The session ends. */
    void close() {
        abandonAll();
    }

    /** The board has taken a transmission, and will tell its end by this number. */
    void transmitting(int number, CompletableFuture<Outcome> end) {
        abandon(underWay.put(number, end));
    }

    private void abandonAll() {
        List<CompletableFuture<Outcome>> all = List.copyOf(underWay.values());
        underWay.clear();
        all.forEach(this::abandon);
    }

    /** The board will not tell this end any more, if there is one. */
    private void abandon(CompletableFuture<Outcome> end) {
        if (end != null) {
            context.counters().count(SessionCounter.ABANDONED_TRANSMISSIONS);
            end.complete(Outcome.UNDELIVERED);
        }
    }

    private void end(PollReply.Transmission transmission) {
        CompletableFuture<Outcome> end = underWay.remove(transmission.number());
        if (end == null) {
            context.counters().count(SessionCounter.UNKNOWN_OUTCOMES);
        } else {
            end.complete(transmission.outcome());
        }
    }

    /** Whether messages were taken of which the board was not told yet. */
    boolean owesTaken() {
        return owesTaken;
    }

    Request nextPoll() {
        perception.followWish();
        asksPercepts = perception.isDue() && !perceptsCrowd;
        if (asksPercepts) {
            perception.asked();
        }
        return Request.poll(asksPercepts, taken);
    }

    /** Takes over all that the poll brought. */
    void take(PollReply reply) {
        owesTaken = false;
        repeats.confirmed();
        List<Bytes> literals = new ArrayList<>();
        for (PollReply.Item item : reply.records()) {
            if (item instanceof PollReply.Percept percept) {
                literals.add(percept.literal());
            } else if (item instanceof PollReply.Message message && !isLast) {
                takeMessage(message);
            } else if (item instanceof PollReply.Transmission transmission) {
                end(transmission);
            }
        }
        if (asksPercepts) {
            perception.take(literals, reply.leftOut());
        }
        perceptsCrowd = asksPercepts && (reply.more() || owesTaken);
    }

    /**
     * A poll that only says what is taken: messages that it brings stay with the board, for the next run of the host.
     */
    Request lastPoll() {
        asksPercepts = false;
        isLast = true;
        return Request.poll(false, taken);
    }

    private void takeMessage(PollReply.Message message) {
        taken = message.number();
        owesTaken = true;
        if (!repeats.add(message)) {
            context.counters().count(SessionCounter.REPEATED_MESSAGES);
            return;
        }
        context.counters().count(SessionCounter.MESSAGES);
        try {
            Content content = Content.decode(message.content());
            ReceivedMessage received =
                    new ReceivedMessage(message.origin(), message.destination(), message.id(), content);
            context.listener().tell(listener -> listener.message(received));
        } catch (ProtocolException e) {
            context.counters().count(SessionCounter.DAMAGED_RECORDS);
            context.listener().warn("a message from " + message.origin() + " was skipped: " + e.getMessage());
        }
    }
}
