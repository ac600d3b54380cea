package javino.board;

import java.time.Duration;
import java.util.List;
import java.util.function.Supplier;
import javino.link.LinkException;
import javino.protocol.ActionNames;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.PollReply;
import javino.protocol.ProtocolError;
import javino.protocol.ProtocolException;
import javino.protocol.Reply;
import javino.protocol.Request;
import javino.protocol.Status;

/** Serves requests and polls a board that was greeted, until it is lost. For the session's thread only. */
final class Service {

    /** What a board may take to write to its EEPROM, beyond the time for a reply (SPEC 4.2). */
    private static final Duration EEPROM_TIME = Duration.ofMillis(400);

    /** From one poll to the next while the board receives or sends. */
    private static final Duration ACTIVE_INTERVAL = Duration.ofMillis(15);

    private final Context context;
    private final Exchange exchange;
    private final Polling polling;
    private Deadline nextPoll = Deadline.in(Duration.ZERO);
    private boolean pollsFail;
    /** Whether to poll before the next request: acknowledgements wait for the board to know what was taken. */
    private boolean pollFirst;
    /** What the radio was told since the board was greeted; null if nothing yet. */
    private Request radioTold;

    Service(Context context, Exchange exchange, Polling polling) {
        this.context = context;
        this.exchange = exchange;
        this.polling = polling;
    }

    /** Opens or blocks the radio as it was wished, since boards start with it blocked. */
    void restoreRadio() throws LinkException, LostException {
        Boolean wanted = context.radio().get();
        if (wanted == null) {
            return;
        }
        Request request = Request.radio(wanted);
        try {
            Status status = tell(request).status();
            if (status != Status.OK) {
                context.listener().warn(new RequestFailedException(request.toString(), status).getMessage());
            }
        } catch (ProtocolException e) {
            context.counters().count(SessionCounter.BAD_REPLIES);
            context.listener().warn("the reply to " + request + " was dropped: " + e.getMessage());
        }
    }

    /**
     * Asks for the names of the sketch's actions.
     *
     * @throws ProtocolException if a reply makes no sense.
     */
    List<String> actions() throws LinkException, LostException, ProtocolException {
        ActionNames names = actionsFrom(0);
        while (!names.areAll()) {
            names = names.and(actionsFrom(names.told().length()));
        }
        return names.names();
    }

    private ActionNames actionsFrom(int offset) throws LinkException, LostException, ProtocolException {
        Reply reply = ask(Request.listActions(offset));
        if (reply.status() != Status.OK) {
            throw new ProtocolException(ProtocolError.BAD_REPLY, "list actions answered with " + reply.status());
        }
        return reply.actionNames();
    }

    /** Returns when the session was closed. */
    void run(Supplier<BoardInfo> present) throws LinkException, LostException {
        pollFirst = polling.owesTaken();
        while (!context.queue().isClosed()) {
            Pending<?> request = pollFirst ? null : context.queue().next(nextPoll);
            if (request != null && !request.result().isDone()) {
                perform(request, present.get());
            }
            // No request: it is time, a wish has changed, or messages were taken.
            if (request == null || nextPoll.passed()) {
                poll();
            }
        }
        if (polling.owesTaken()) {
            confirm();
        }
    }

    private void perform(Pending<?> pending, BoardInfo board) throws LinkException, LostException {
        try {
            pending.answer(tell(pending.source().request(board)));
        } catch (RequestFailedException e) {
            pending.fail(e);
        } catch (ProtocolException e) {
            context.counters().count(SessionCounter.BAD_REPLIES);
            pending.fail(e);
        } catch (LinkException | LostException e) {
            pending.fail(new OutcomeUnknownException(pending.description(), e.getMessage()));
            throw e;
        }
    }

    /** Asks, but for what a radio was told already: what was wished before the greeting also waits in the queue. */
    private Reply tell(Request request) throws LinkException, LostException, ProtocolException {
        if (request.equals(radioTold)) {
            return new Reply(Status.OK, Bytes.EMPTY);
        }
        boolean toRadio = request.command() == Request.Command.RADIO;
        radioTold = toRadio ? null : radioTold;
        Reply reply = ask(request);
        if (toRadio && reply.status() == Status.OK) {
            radioTold = request;
        }
        return reply;
    }

    private void poll() throws LinkException, LostException {
        Duration interval = context.config().pollInterval();
        boolean first = pollFirst;
        pollFirst = false;
        try {
            PollReply reply = pollReply(ask(polling.nextPoll()));
            polling.take(reply);
            interval = polling.owesTaken() ? Duration.ZERO : intervalAfter(reply);
            // Once: a board that has a message each time shall not keep all requests waiting.
            pollFirst = polling.owesTaken() && !first;
            pollsFail = false;
        } catch (ProtocolException e) {
            badPollReply(e);
        }
        nextPoll = Deadline.in(interval);
    }

    private Duration intervalAfter(PollReply reply) {
        Duration usual = context.config().pollInterval();
        if (reply.more()) {
            return Duration.ZERO;
        }
        return reply.airActive() && usual.compareTo(ACTIVE_INTERVAL) > 0 ? ACTIVE_INTERVAL : usual;
    }

    /** Says at the end what was taken, so that its sender learns of it and the next run does not get it again. */
    private void confirm() throws LinkException, LostException {
        try {
            polling.take(pollReply(ask(polling.lastPoll())));
        } catch (ProtocolException e) {
            badPollReply(e);
        }
    }

    private void badPollReply(ProtocolException e) {
        context.counters().count(SessionCounter.BAD_REPLIES);
        // Once for a row of them: there may be fifty a second.
        if (!pollsFail) {
            context.listener().warn("replies to polls are dropped: " + e.getMessage());
        }
        pollsFail = true;
    }

    private static PollReply pollReply(Reply reply) throws ProtocolException {
        if (reply.status() != Status.OK) {
            throw new ProtocolException(ProtocolError.BAD_REPLY, "poll answered with " + reply.status());
        }
        return reply.poll();
    }

    private Reply ask(Request request) throws LinkException, LostException, ProtocolException {
        // A listener or a future's dependant may have interrupted this thread; that is no reason to drop the link.
        Thread.interrupted();
        Duration timeout = context.config().replyTimeout();
        Reply reply = exchange.ask(request, request.command().writesEeprom() ? timeout.plus(EEPROM_TIME) : timeout,
                attempts -> attempts < context.config().attempts() && !context.queue().isClosed()).orElse(null);
        if (reply == null && context.queue().isClosed()) {
            throw new LostException(context.name() + ": the session was closed");
        }
        if (reply == null) {
            context.counters().count(SessionCounter.SILENCES);
            throw new LostException(context.name() + ": the board left a request unanswered");
        }
        if (reply.status() == Status.NOT_GREETED) {
            context.counters().count(SessionCounter.RESETS);
            polling.reset();
            throw new LostException(context.name() + ": the board was reset");
        }
        return reply;
    }
}
