package javino.board;

import java.time.Duration;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import javino.JavinoException;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;
import javino.protocol.Address;
import javino.protocol.BoardInfo;
import javino.protocol.Counter;
import javino.protocol.Outcome;
import javino.protocol.ProtocolException;
import javino.protocol.Request;

/** The work of the session's thread: opens the link, greets the board, has it served, and begins again. */
final class Session implements Runnable {

    private final LinkOpener opener;
    private final SessionContext context;
    private final Polling polling;
    private volatile BoardState state = BoardState.OFFLINE;
    private volatile BoardInfo info;
    private final CompletableFuture<BoardInfo> greeted = new CompletableFuture<>();
    private final StateGuard guard;
    /** Whether the board may have booted since its epoch was seen to, or may be another. */
    private boolean fresh;
    private String offlineWhy;
    private Deadline patience;
    private final ReopenPause reopenPause;
    private long greetedAt;
    /** When nobody waits any longer for what a lost board was transmitting; null while it is there. */
    private Deadline abandoning;

    Session(LinkOpener opener, SessionContext context) {
        this.opener = opener;
        this.context = context;
        this.polling = new Polling(context);
        this.guard = new StateGuard(context);
        greetedAt = context.time().nanos();
        reopenPause = new ReopenPause(context.config().reopenInterval());
    }

    BoardState state() {
        return state;
    }

    /** The board as it was greeted last, with its present address. */
    Optional<BoardInfo> info() {
        return Optional.ofNullable(info);
    }

    /** The board as it was greeted first, or why it could not be. */
    CompletableFuture<BoardInfo> greeted() {
        return greeted;
    }

    /** On the session's thread, after a set RF id was answered: what was noted of that address counts from now on. */
    private void renamed(Service service, Address id) throws LinkException, LostException, ProtocolException {
        if (!info.rfId().equals(Optional.of(id))) {
            info = info.withRfId(id);
            raiseEpoch(service, true);
        }
    }

    /** On the session's thread, after a transmission was answered. */
    void transmitting(int number, CompletableFuture<Outcome> end) {
        polling.transmitting(number, end);
    }

    @Override
    public void run() {
        try {
            while (!context.queue().isClosed()) {
                connect();
            }
        } finally {
            // Closed already, but for a link that throws what no link should: then nobody is to wait in vain.
            context.queue().close(context.name() + ": the session ended by an unexpected error");
            if (state != BoardState.INCOMPATIBLE) {
                state = BoardState.CLOSED;
            }
            context.queue().drain().forEach(request -> request.failOffline(context.queue().closedWhy()));
            context.perception().end();
            polling.close();
            greeted.completeExceptionally(new JavinoException(context.queue().closedWhy()));
        }
    }

    private void connect() {
        try (Link link = opener.open()) {
            context.queue().setWaker(link::wake);
            use(link);
        } catch (LinkException e) {
            goOffline(e.getMessage());
            pause(context.config().reopenInterval());
        } catch (SilenceException e) {
            goOffline(e.getMessage());
            pause(reopenPause.after(Duration.ofNanos(context.time().nanos() - greetedAt)));
        }
    }

    private void pause(Duration duration) {
        Deadline end = context.in(duration);
        Duration step = context.config().reopenInterval();
        do {
            failExpired();
            context.queue().pause(step.toNanos() < end.nanosLeft() ? step : Duration.ofNanos(end.nanosLeft()));
        } while (!end.passed() && !context.queue().isClosed());
    }

    private void use(Link link) throws LinkException, SilenceException {
        Greeting greeting = new Greeting(link, context, this::keepGreeting);
        fresh = true;
        while (!context.queue().isClosed()) {
            try {
                greet(greeting);
            } catch (SilenceException e) {
                throw e;
            } catch (LostException e) {
                goOffline(e.getMessage());
            } catch (LinkException e) {
                context.counters().count(SessionCounter.LINK_FAILURES);
                throw e;
            }
        }
    }

    private void greet(Greeting greeting) throws LinkException, LostException {
        patience = context.in(context.config().patience());
        try {
            Optional<BoardInfo> board = greeting.greet();
            if (board.isPresent() && welcome(board.get())) {
                serve(greeting);
            }
        } catch (ProtocolException e) {
            context.counters().count(SessionCounter.BAD_REPLIES);
            goOffline(context.name() + ": the device answers hello, but not as a Javino board does: "
                    + e.getMessage());
            context.queue().pause(context.config().helloInterval());
        }
    }

    private void serve(Greeting greeting) throws LinkException, LostException, ProtocolException {
        if (info.isLegacy()) {
            nowOnline();
            new LegacyService(context, greeting.legacyExchange()).run(info);
        } else {
            Service service = new Service(context, greeting.exchange(), polling, guard);
            info = info.withActions(service.actions());
            boolean lags = !greeting.exchange().lag().isZero();
            Map<Counter, Long> counters = lags || info.countsAirtime() ? service.statistics() : Map.of();
            if (lags) {
                SketchTimes.ofLoop(counters).ifPresent(context.listener()::warn);
            }
            if (fresh) {
                raiseEpoch(service, false);
                fresh = false;
            }
            service.restoreWishes(info);
            nowOnline();
            service.run(() -> info, id -> renamed(service, id));
        }
    }

    /** Raises the board's epoch, before anybody may send. */
    private void raiseEpoch(Service service, boolean renamed)
            throws LinkException, LostException, ProtocolException {
        info = guard.raiseEpoch(service, info, renamed);
        polling.renamed(info);
    }

    private void nowOnline() {
        state = BoardState.ONLINE;
        offlineWhy = null;
        abandoning = null;
        context.listener().tell(listener -> listener.online(info));
        greeted.complete(info);
    }

    private boolean keepGreeting() {
        failExpired();
        if (patience.passed()) {
            goOffline(context.name() + ": the port is open, but no Javino board answers; is its sketch flashed, "
                    + "without a delay() in loop(), and at the same baud rate?");
        }
        return !context.queue().isClosed();
    }

    private boolean welcome(BoardInfo board) {
        if (board.protocolVersion() != Request.PROTOCOL_VERSION && !board.isLegacy()) {
            String why = context.name() + ": the board speaks version " + board.protocolVersion()
                    + " of the protocol and this program version " + Request.PROTOCOL_VERSION
                    + "; flash a sketch that was built with the same release of Javino";
            context.queue().close(why);
            state = BoardState.INCOMPATIBLE;
            tellOffline(why);
            return false;
        }
        context.counters().count(SessionCounter.GREETINGS);
        greetedAt = context.time().nanos();
        info = board;
        fresh |= polling.greeted(board);
        return true;
    }

    private void goOffline(String why) {
        boolean wasOnline = state == BoardState.ONLINE;
        state = BoardState.OFFLINE;
        context.perception().end();
        if (wasOnline) {
            abandoning = context.in(context.config().patience());
            context.queue().drain().forEach(request -> request.failOffline(why));
        }
        // Whoever closed the session knows it.
        if (!context.queue().isClosed()) {
            tellOffline(why);
        }
    }

    private void tellOffline(String why) {
        if (!Objects.equals(why, offlineWhy)) {
            offlineWhy = why;
            context.listener().tell(listener -> listener.offline(why));
            greeted.completeExceptionally(new JavinoException(why));
        }
    }

    private void failExpired() {
        String why = offlineWhy == null ? context.name() + ": the board does not answer" : offlineWhy;
        context.queue().expired().forEach(request -> request.failOffline(why));
        if (abandoning != null && abandoning.passed()) {
            abandoning = null;
            polling.close();
        }
    }
}
