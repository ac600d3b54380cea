package javino.board;

import java.time.Duration;
import java.util.Optional;
import javino.legacy.LegacyMessage;
import javino.link.LinkException;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.ProtocolException;
import javino.protocol.Reply;
import javino.protocol.Request;
import javino.protocol.Status;

/** Serves a board that speaks the older protocol, until it is lost (SPEC 8.2). For the session's thread only. */
final class LegacyService {

    /**
     * From an answer to the next question, at least: at 9600 bit/s an exchange takes some 70 ms, and actions wait for
     * it.
     */
    private static final Duration PAUSE = Duration.ofMillis(100);
    /** How often to look whether the link is still there while nothing is asked. */
    private static final Duration LOOK_INTERVAL = Duration.ofSeconds(1);
    /** How many questions in a row may stay without an answer. */
    private static final int MOST_SILENCES = 2;

    private final SessionContext context;
    private final LegacyExchange exchange;
    private final Perception perception;
    private Deadline next;
    private int silences;
    private long skipped;
    private boolean damaged;

    LegacyService(SessionContext context, LegacyExchange exchange) {
        this.context = context;
        this.exchange = exchange;
        perception = context.perception();
        skipped = exchange.skipped();
        next = context.in(Duration.ZERO);
    }

    /** Returns when the session was closed. */
    void run(BoardInfo board) throws LinkException, LostException {
        if (Boolean.TRUE.equals(context.radio().get())) {
            context.listener().warn(new LegacyBoardException(Request.radio(true).toString()).getMessage());
        }
        while (!context.queue().isClosed()) {
            PendingRequest<?> request = context.queue().next(next);
            if (request != null && !request.result().isDone()) {
                perform(request, board);
            }
            // No request: it is time, or a wish has changed.
            if (request == null || next.passed()) {
                look();
            }
        }
    }

    private void perform(PendingRequest<?> pending, BoardInfo board) throws LinkException {
        try {
            Request request = pending.source().request(board);
            if (request.command() == Request.Command.ACT) {
                exchange.act(message(request));
                pending.answer(new Reply(Status.OK, Bytes.EMPTY), Optional.empty());
            } else {
                pending.fail(new LegacyBoardException(pending.description()));
            }
        } catch (LegacyBoardException e) {
            pending.fail(e);
        } catch (RequestFailedException | ProtocolException e) {
            // The board lacks more for this request than an address.
            pending.fail(new LegacyBoardException(pending.description()));
        } catch (LinkException e) {
            pending.fail(new OutcomeUnknownException(pending.description(), e.getMessage()));
            throw e;
        }
    }

    private static LegacyMessage message(Request act) throws LegacyBoardException {
        Bytes action = act.frame().message().from(1);
        if (action.length() > LegacyMessage.MAX_LENGTH) {
            throw new LegacyBoardException(act.toString(), "in which an action has at most " + LegacyMessage.MAX_LENGTH
                    + " bytes of UTF-8, not " + action.length());
        }
        return new LegacyMessage(action);
    }

    private void look() throws LinkException, LostException {
        boolean wanted = perception.update();
        if (wanted && perception.dueIn().isZero()) {
            perception.asked();
            askPercepts();
        } else if (!wanted) {
            exchange.listen();
        }
        tellOfDamage();
        next = context.in(wanted ? PAUSE : LOOK_INTERVAL);
    }

    private void askPercepts() throws LinkException, LostException {
        Duration timeout = context.config().replyTimeout().multipliedBy(context.config().attempts());
        Optional<LegacyMessage> answer = exchange.askPercepts(timeout, () -> !context.queue().isClosed());
        if (answer.isPresent()) {
            silences = 0;
            perception.take(answer.get().percepts(), false, false);
        } else if (++silences == MOST_SILENCES && !context.queue().isClosed()) {
            context.counters().count(SessionCounter.SILENCES);
            throw new LostException(context.name() + ": the board left " + MOST_SILENCES + " requests unanswered");
        }
    }

    /** Once for a row of them: there may be ten a second. */
    private void tellOfDamage() {
        long more = exchange.skipped() - skipped;
        skipped += more;
        if (more > 0 && !damaged) {
            context.listener().warn(more + " bytes from the board were skipped, as they are no message: the line is"
                    + " damaged, or its percepts are longer than " + LegacyMessage.MAX_LENGTH + " bytes together");
        }
        damaged = more > 0;
    }
}
