package javino.board;

import java.time.Duration;
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
import javino.protocol.HostMessage;

/** Makes polls, and turns what they bring into calls of the listener. For the session's thread only. */
final class Polling {

    /** The least time from one reading to the next: for a board whose readings differ all the time. */
    private static final long LEAST_MILLIS = 10;
    private static final Duration LONGEST_LEAST = Duration.ofMillis(Request.MAX_LEAST_MILLIS);

    private final SessionContext context;
    private final Perception perception;
    /** The ends that the board is yet to tell, by numbers, which hold for one boot of the board. */
    private final Map<Integer, CompletableFuture<Outcome>> underWay = new LinkedHashMap<>();
    private final RepeatFilter repeats = new RepeatFilter();
    /** The board that the numbers below are of; null if it has booted since it was greeted. */
    private BoardInfo source;
    private int taken = Request.NOTHING_TAKEN;
    private boolean owesTaken;
    private boolean isLast;
    private boolean toldDamage;
    private boolean toldTimer;

    Polling(SessionContext context) {
        this.context = context;
        perception = context.perception();
    }

    /**
     * A board came online; after a boot it counts messages and transmissions anew.
     *
     * @return whether it has booted, or was not greeted by this session before.
     */
    boolean greeted(BoardInfo board) {
        // Without an epoch no boot can be told from the one before.
        boolean booted = !board.equals(source) || board.bootEpoch() == 0;
        if (booted) {
            toldDamage = false;
            toldTimer = false;
            taken = Request.NOTHING_TAKEN;
            owesTaken = false;
            repeats.booted();
            abandonAll();
        }
        source = board;
        perception.forget();
        return booted;
    }

    /** The same board has a new address or epoch, and will say so in the next hello. */
    void renamed(BoardInfo board) {
        source = board.withActions(List.of());
    }

    /** The board said that it has booted since it was greeted. */
    void reset() {
        source = null;
    }

    /** The session ends, or its board was away for long. */
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

    /** Whether the board has taken a transmission that has not ended. */
    boolean isTransmitting() {
        return !underWay.isEmpty();
    }

    private void end(PollReply.Transmission transmission) {
        context.queue().setRoom();
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

    /**
     * The poll to make now.
     *
     * @param hold      how long the board may hold its reply at most.
     * @param lastReply the state of the replies to the polls before.
     */
    Request nextPoll(Duration hold, Request.LastReply lastReply) {
        boolean wanted = perception.update();
        Duration due = perception.dueIn();
        // For longer than a poll can say, they are not asked for; the board then tells them anew.
        if (!wanted || due.compareTo(LONGEST_LEAST) > 0) {
            return poll(Request.Percepts.NONE, hold, lastReply);
        }
        if (!perception.isAwaited()) {
            return poll(Request.Percepts.CHANGED, hold, lastReply);
        }
        if (due.isZero()) {
            perception.asked();
            return poll(Request.Percepts.NOW, Duration.ZERO, lastReply);
        }
        return poll(Request.Percepts.CHANGED, due.compareTo(hold) < 0 ? due : hold, lastReply);
    }

    private Request poll(Request.Percepts percepts, Duration hold, Request.LastReply lastReply) {
        // Rounded up, so that what is due is due when the reply comes.
        int holdMillis = (int) hold.plusNanos(999_999).toMillis();
        long least = Math.max(LEAST_MILLIS, perception.interval().toMillis());
        return Request.poll(percepts, holdMillis, (int) Math.min(least, Request.MAX_LEAST_MILLIS), taken, lastReply);
    }

    /**
     * Takes over all that the poll brought.
     *
     * @param late whether there was another poll after it.
     */
    void take(PollReply reply, boolean late) {
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
            } else if (item instanceof PollReply.NoKey frame && !isLast) {
                context.listener().tell(listener -> listener.noKey(frame));
            } else if (item instanceof PollReply.Overheard packet && !isLast) {
                context.counters().count(SessionCounter.OVERHEARD);
                context.listener().tell(listener -> listener.overheard(packet));
            }
        }
        if (reply.damaged() && !toldDamage) {
            toldDamage = true;
            context.listener().warn(LostState.ofMemory());
        }
        if (reply.takenTimer().isPresent() && !toldTimer) {
            toldTimer = true;
            int timer = reply.takenTimer().getAsInt();
            context.listener().tell(listener -> listener.timerTaken(timer, RadioTimer.ofTaken(timer)));
        }
        if (reply.reading()) {
            perception.take(literals, reply.leftOut(), late);
        }
    }

    /**
     * A poll that only says what is taken: messages that it brings stay with the board, for the next run of the host.
     */
    Request lastPoll(Request.LastReply lastReply) {
        isLast = true;
        return Request.poll(Request.Percepts.NONE, 0, 0, taken, lastReply);
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
            if (HostMessage.isHostMessage(message.content())) {
                HostMessage hostMessage = HostMessage.decode(message.content());
                context.listener()
                        .tell(listener -> listener.hostMessage(message.origin(), message.destination(), hostMessage));
                return;
            }
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
