package javino.board;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import javino.JavinoException;
import javino.link.LinkException;
import javino.protocol.ActionNames;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Counter;
import javino.protocol.Frame;
import javino.protocol.ProtocolError;
import javino.protocol.ProtocolException;
import javino.protocol.Reply;
import javino.protocol.Request;
import javino.protocol.Status;

/** Serves requests and polls a board that was greeted, until it is lost. For the session's thread only. */
final class Service {

    /** The time that a board may take to write to its EEPROM, beyond that for a reply (SPEC 4.2). */
    private static final Duration EEPROM_TIME = Duration.ofMillis(400);

    /** The most time from one poll to the next, while requests follow each other. */
    private static final Duration MOST_INTERVAL = Duration.ofMillis(35);

    /** From one reading of the airtime to the next, and while messages are under way: they may wait for it. */
    private static final Duration AIRTIME_INTERVAL = Duration.ofMinutes(1);
    private static final Duration BUSY_AIRTIME_INTERVAL = Duration.ofSeconds(5);

    private final SessionContext context;
    private final Exchange exchange;
    private final Polling polling;
    private final StateGuard guard;
    private Deadline latestPoll;
    private Deadline airtimeDue;
    private Deadline busyAirtimeDue;
    private boolean pollsFail;
    /** Whether to poll before the next request: acknowledgements wait for the board to know what was taken. */
    private boolean pollFirst;

    /** A step to take when the board has got an address. */
    interface Renamed {
        void to(Address id) throws LinkException, LostException, ProtocolException;
    }

    Service(SessionContext context, Exchange exchange, Polling polling, StateGuard guard) {
        this.context = context;
        this.exchange = exchange;
        this.polling = polling;
        this.guard = guard;
        latestPoll = context.in(Duration.ZERO);
        airtimeDue = context.in(AIRTIME_INTERVAL);
        busyAirtimeDue = context.in(BUSY_AIRTIME_INTERVAL);
        exchange.setLateReplies(this::takeLate);
    }

    /** Has the radio open and overhears as it was wished: a board that has booted does neither. */
    void restoreWishes(BoardInfo board) throws LinkException, LostException {
        if (!board.hasRadio()) {
            return;
        }
        restore(context.radio().get(), Request::radio);
        restore(context.overhear().get(), Request::overhear);
    }

    private void restore(Boolean wish, Function<Boolean, Request> wished) throws LinkException, LostException {
        if (wish == null) {
            return;
        }
        Request request = wished.apply(wish);
        try {
            Status status = ask(request).status();
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

    /** Asks for the board's keys. */
    List<Reply.StoredKey> keys() throws LinkException, LostException, ProtocolException {
        Reply reply = ask(Request.listKeys());
        return reply.status() == Status.OK ? reply.storedKeys() : List.of();
    }

    /** Asks for the board's counters, which tell its airtime, too; none if it has none. */
    Map<Counter, Long> statistics() throws LinkException, LostException, ProtocolException {
        Reply reply = ask(Request.statistics());
        return reply.status() == Status.OK ? context.counted(reply) : Map.of();
    }

    /** Raises the board's epoch. @return OK if it has it; BUSY while messages are under way. */
    Status raiseEpoch(int epoch) throws LinkException, LostException, ProtocolException {
        return ask(Request.raiseEpoch(epoch)).status();
    }

    private ActionNames actionsFrom(int offset) throws LinkException, LostException, ProtocolException {
        Reply reply = ask(Request.listActions(offset));
        if (reply.status() != Status.OK) {
            throw new ProtocolException(ProtocolError.BAD_REPLY, "list actions answered with " + reply.status());
        }
        return reply.actionNames();
    }

    /** Returns when the session was closed. */
    void run(Supplier<BoardInfo> present, Renamed renamed) throws LinkException, LostException {
        pollFirst = polling.owesTaken();
        context.queue().setRoom();
        while (!context.queue().isClosed()) {
            PendingRequest<?> request = pollFirst ? null : context.queue().next(context.in(Duration.ZERO));
            if (request != null && !request.result().isDone()) {
                perform(request, present.get(), renamed);
            }
            if (request == null || latestPoll.passed()) {
                poll();
                if (isAirtimeDue()) {
                    readAirtime(present.get());
                }
            }
        }
        if (polling.owesTaken()) {
            confirm();
        }
    }

    /** While messages are under way more often, as they may wait for it; never while somebody waits for the line. */
    private boolean isAirtimeDue() {
        Deadline due = polling.isTransmitting() ? busyAirtimeDue : airtimeDue;
        return due.passed() && !pollFirst && !context.queue().hasNews();
    }

    /** Asks for the airtime. @return in how many s the board lets a new message go; 0 if it does. */
    private long readAirtime(BoardInfo board) throws LinkException, LostException {
        airtimeDue = context.in(AIRTIME_INTERVAL);
        busyAirtimeDue = context.in(BUSY_AIRTIME_INTERVAL);
        try {
            return board.countsAirtime() ? statistics().getOrDefault(Counter.AIRTIME_WAIT, 0L) : 0;
        } catch (ProtocolException e) {
            context.counters().count(SessionCounter.BAD_REPLIES);
            return 0;
        }
    }

    private void perform(PendingRequest<?> pending, BoardInfo board, Renamed renamed)
            throws LinkException, LostException {
        try {
            Request request = pending.source().request(board);
            if (request.command().needsRadio() && !board.hasRadio()) {
                throw new RequestFailedException(pending.description(), Status.NO_RADIO);
            }
            if (request.needsWholeRadio() && board.hasUnicastsOnly()) {
                throw new RequestFailedException(pending.description(), Status.UNICASTS_ONLY);
            }
            if (request.isSealed() && !guard.maySeal()) {
                throw new RequestFailedException(pending.description(), Status.NONCE_EXHAUSTED);
            }
            Reply reply = request.command().storesKey() ? store(request, board) : ask(request);
            if (request.command() == Request.Command.SET_RF_ID && reply.status() == Status.OK) {
                renamed.to(Address.decode(request.frame().message(), 1));
            }
            boolean isFull = reply.status() == Status.QUEUE_FULL;
            long wait = isFull ? readAirtime(board) : 0;
            if (wait > 0) {
                throw new AirtimeUsedException(pending.description(), wait);
            } else if (isFull && pending.isTransmission() && polling.isTransmitting()) {
                context.queue().hold(pending);
            } else {
                pending.answer(reply, exchange.reason());
            }
        } catch (ProtocolException e) {
            context.counters().count(SessionCounter.BAD_REPLIES);
            pending.fail(e);
        } catch (LinkException | LostException e) {
            pending.fail(new OutcomeUnknownException(pending.description(), e.getMessage()));
            throw e;
        } catch (JavinoException e) {
            pending.fail(e);
        }
    }

    private Reply store(Request request, BoardInfo board) throws LinkException, LostException, JavinoException {
        StateGuard.StoredKeyRequest admitted = guard.admit(this, board, request);
        Reply reply = ask(request);
        if (reply.status() == Status.OK) {
            admitted.done(this);
        }
        return reply;
    }

    /** The board holds its reply until it has something to tell, or somebody here has. */
    void poll() throws LinkException, LostException {
        boolean first = pollFirst;
        pollFirst = false;
        Duration hold = context.queue().hasNews() ? Duration.ZERO : context.config().hold();
        try {
            Optional<Reply> reply = askOrLeave(polling.nextPoll(hold, exchange.takeLastReply()));
            if (reply.isPresent()) {
                take(reply.get(), false);
                // Once: a board that has a message each time shall not keep all requests waiting.
                pollFirst = pollFirst && !first;
            }
        } catch (ProtocolException e) {
            badPollReply(e);
        }
        latestPoll = context.in(MOST_INTERVAL);
    }

    private void take(Reply reply, boolean late) throws ProtocolException {
        if (reply.status() != Status.OK) {
            throw new ProtocolException(ProtocolError.BAD_REPLY, "poll answered with " + reply.status());
        }
        polling.take(reply.poll(), late);
        pollsFail = false;
        pollFirst = polling.owesTaken();
    }

    private void takeLate(Frame frame) {
        try {
            Reply reply = Reply.decode(frame);
            // A board that has forgotten the greeting says so in the next reply too.
            if (reply.status() != Status.NOT_GREETED) {
                take(reply, true);
            }
        } catch (ProtocolException e) {
            badPollReply(e);
        }
    }

    /** Says at the end what was taken, so that its sender learns of it and the next run does not get it again. */
    private void confirm() throws LinkException, LostException {
        try {
            take(ask(polling.lastPoll(exchange.takeLastReply())), false);
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

    private Reply ask(Request request) throws LinkException, LostException, ProtocolException {
        return askOrLeave(request).orElseThrow(() -> new IllegalStateException(request + " was held"));
    }

    /** Asks; nothing if this is a poll whose reply {@link #takeLate} will take, as there is something else to ask. */
    private Optional<Reply> askOrLeave(Request request) throws LinkException, LostException, ProtocolException {
        // A listener or a future's dependant may have interrupted this thread; that is no reason to drop the link.
        Thread.interrupted();
        Duration timeout = context.config().replyTimeout();
        // The request is asked until the time of an action is over: a board may be slow, and what follows may reset it.
        Optional<Reply> reply = exchange.ask(request,
                request.command().writesEeprom() ? timeout.plus(EEPROM_TIME) : timeout, this::hasMore,
                attempts -> !context.queue().isClosed());
        if (reply.isPresent() && reply.get().status() == Status.NOT_GREETED) {
            context.counters().count(SessionCounter.RESETS);
            polling.reset();
            throw new LostException(context.name() + ": the board was reset");
        }
        if (reply.isPresent() || exchange.hasLeft()) {
            return reply;
        }
        if (context.queue().isClosed()) {
            throw new LostException(context.name() + ": the session was closed");
        }
        context.counters().count(SessionCounter.SILENCES);
        Duration overdue = exchange.overdue();
        throw new SilenceException(context.name() + (overdue.isZero() ? ": the board left a request unanswered"
                + (exchange.lag().isZero() ? "" : "; is there a delay() in its sketch's loop()?")
                : ": the board has taken a request and not answered it in " + overdue.toSeconds()
                        + " s; the sketch's functions of actions and percepts must return at once"));
    }

    /** Whether there is more to ask; also while a long reading comes, so that the next one may follow it at once. */
    private boolean hasMore() {
        return context.queue().hasNews() || !context.perception().isAwaited() && exchange.readingComes();
    }
}
