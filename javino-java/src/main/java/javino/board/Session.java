package javino.board;

import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ThreadLocalRandom;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.ProtocolError;
import javino.protocol.ProtocolException;
import javino.protocol.Request;
import javino.protocol.Status;

/** What the session's thread does: opens the link, greets the board, serves requests, polls, and begins again. */
final class Session implements Runnable {

    private final LinkOpener opener;
    private final BoardConfig config;
    private final RequestQueue queue;
    private final Wishes wishes;
    private final Tally tally;
    private final ListenerGuard listener;
    private final Inbox inbox;
    private volatile BoardState state = BoardState.OFFLINE;
    private volatile BoardInfo info;
    private String offlineWhy;
    private Deadline nextPoll;

    Session(LinkOpener opener, BoardConfig config, RequestQueue queue, Wishes wishes, Tally tally,
            ListenerGuard listener) {
        this.opener = opener;
        this.config = config;
        this.queue = queue;
        this.wishes = wishes;
        this.tally = tally;
        this.listener = listener;
        this.inbox = new Inbox(wishes, listener, tally);
    }

    /** The board was greeted, and is lost again; the link may still be good. */
    private static final class LostException extends Exception {

        private static final long serialVersionUID = 1L;

        LostException(String why) {
            super(why);
        }
    }

    BoardState state() {
        return state;
    }

    /** The board as it was greeted last, with its present address. */
    Optional<BoardInfo> info() {
        return Optional.ofNullable(info);
    }

    @Override
    public void run() {
        while (!queue.isClosed()) {
            try (Link link = opener.open()) {
                useLink(link);
            } catch (LinkException e) {
                goOffline(e.getMessage());
                failExpired();
                queue.pause(config.reopenInterval());
            }
        }
        if (state != BoardState.INCOMPATIBLE) {
            state = BoardState.CLOSED;
        }
        queue.drain().forEach(request -> request.failOffline(queue.closedWhy()));
    }

    private void useLink(Link link) throws LinkException {
        // Random, so that a reply to the program that had the port before is hardly taken for one to this.
        Exchange exchange = new Exchange(link, ThreadLocalRandom.current().nextInt(0x100), tally);
        while (!queue.isClosed()) {
            try {
                if (greet(exchange)) {
                    serve(exchange);
                }
            } catch (LostException e) {
                goOffline(e.getMessage());
            } catch (LinkException e) {
                tally.count(SessionCounter.LINK_FAILURES);
                throw e;
            }
        }
    }

    /** Says hello until the board answers; false if the session was closed, or the answer makes no sense. */
    private boolean greet(Exchange exchange) throws LinkException {
        Deadline patience = Deadline.in(config.patience());
        try {
            Optional<Exchange.Answer> answer = exchange.ask(new Request.Hello(), config.helloInterval(),
                    attempts -> keepGreeting(patience));
            if (answer.isEmpty()) {
                return false;
            }
            if (answer.get().reply().status() != Status.OK) {
                throw new ProtocolException(ProtocolError.BAD_REPLY,
                        "hello answered with " + answer.get().reply().status());
            }
            return welcome(answer.get().reply().boardInfo());
        } catch (ProtocolException e) {
            tally.count(SessionCounter.BAD_REPLIES);
            goOffline(opener.name() + ": what is there answers hello, but not as a Javino board does: "
                    + e.getMessage());
            queue.pause(config.helloInterval());
            return false;
        }
    }

    private boolean keepGreeting(Deadline patience) {
        failExpired();
        if (patience.passed()) {
            goOffline(opener.name() + ": the port is open, but no Javino board answers; is its sketch flashed, "
                    + "and at the same baud rate?");
        }
        return !queue.isClosed();
    }

    private boolean welcome(BoardInfo board) {
        if (board.protocolVersion() != Request.PROTOCOL_VERSION) {
            String why = opener.name() + ": the board speaks version " + board.protocolVersion()
                    + " of the protocol and this program version " + Request.PROTOCOL_VERSION
                    + "; flash a sketch that was built with the same release of Javino";
            queue.close(why);
            state = BoardState.INCOMPATIBLE;
            tellOffline(why);
            return false;
        }
        tally.count(SessionCounter.GREETINGS);
        info = board;
        inbox.greeted(board);
        return true;
    }

    private void serve(Exchange exchange) throws LinkException, LostException {
        restoreRadio(exchange);
        state = BoardState.ONLINE;
        offlineWhy = null;
        listener.online(info);
        nextPoll = Deadline.in(Duration.ZERO);
        while (!queue.isClosed()) {
            Pending<?> request = queue.next(nextPoll);
            if (request != null && !request.result().isDone()) {
                perform(exchange, request);
            }
            // Also when woken early: a wish has changed.
            if (request == null || nextPoll.passed()) {
                poll(exchange);
            }
        }
    }

    private void restoreRadio(Exchange exchange) throws LinkException, LostException {
        Boolean wanted = wishes.radio();
        if (wanted == null) {
            return;
        }
        Request request = new Request.Radio(wanted);
        try {
            Status status = ask(exchange, request).reply().status();
            if (status != Status.OK) {
                listener.warning(new RequestFailedException(request.toString(), status).getMessage());
            }
        } catch (ProtocolException e) {
            badReply(request, e);
        }
    }

    private void perform(Exchange exchange, Pending<?> pending) throws LinkException, LostException {
        try {
            Request request = pending.source().request(info);
            pending.answer(ask(exchange, request).reply());
        } catch (RequestFailedException e) {
            pending.fail(e);
        } catch (ProtocolException e) {
            tally.count(SessionCounter.BAD_REPLIES);
            pending.fail(e);
        } catch (LinkException | LostException e) {
            pending.fail(new OutcomeUnknownException(pending.description(), e.getMessage()));
            throw e;
        }
    }

    private void poll(Exchange exchange) throws LinkException, LostException {
        Request.Poll poll = inbox.nextPoll();
        boolean more = false;
        try {
            Exchange.Answer answer = ask(exchange, poll);
            if (answer.reply().status() == Status.OK) {
                var reply = answer.reply().poll();
                inbox.take(poll, reply);
                more = reply.more();
            } else {
                throw new ProtocolException(ProtocolError.BAD_REPLY,
                        "poll answered with " + answer.reply().status());
            }
        } catch (ProtocolException e) {
            badReply(poll, e);
        }
        nextPoll = Deadline.in(more ? Duration.ZERO : config.pollInterval());
    }

    private Exchange.Answer ask(Exchange exchange, Request request)
            throws LinkException, LostException, ProtocolException {
        // A listener or a future's dependant may have interrupted this thread; that is no reason to drop the link.
        Thread.interrupted();
        Exchange.Answer answer = exchange.ask(request, config.replyTimeout(),
                attempts -> attempts < config.attempts() && !queue.isClosed()).orElse(null);
        if (answer == null && queue.isClosed()) {
            throw new LostException(opener.name() + ": the session was closed");
        }
        if (answer == null) {
            tally.count(SessionCounter.SILENCES);
            throw new LostException(opener.name() + ": the board left a request unanswered");
        }
        if (answer.reply().status() == Status.NOT_GREETED) {
            tally.count(SessionCounter.RESETS);
            throw new LostException(opener.name() + ": the board was reset");
        }
        return answer;
    }

    private void badReply(Request request, ProtocolException why) {
        tally.count(SessionCounter.BAD_REPLIES);
        listener.warning("the reply to " + request + " was dropped: " + why.getMessage());
    }

    /** On the session's thread, after a set RF id was answered. */
    void renamed(Address id) {
        info = info.withRfId(id);
        inbox.renamed(info);
    }

    private void goOffline(String why) {
        boolean wasOnline = state == BoardState.ONLINE;
        state = BoardState.OFFLINE;
        if (wasOnline) {
            queue.drain().forEach(request -> request.failOffline(why));
        }
        // Who closed the session knows it.
        if (!queue.isClosed()) {
            tellOffline(why);
        }
    }

    private void tellOffline(String why) {
        if (!Objects.equals(why, offlineWhy)) {
            offlineWhy = why;
            listener.offline(why);
        }
    }

    private void failExpired() {
        String why = offlineWhy == null ? opener.name() + ": the board does not answer" : offlineWhy;
        queue.expired().forEach(request -> request.failOffline(why));
    }
}
