package diffuser.report;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeoutException;

import jason.JasonException;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.ListTerm;
import jason.asSyntax.Literal;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;

import javino.board.AirtimeUsedException;
import javino.board.BoardOfflineException;
import javino.board.LegacyBoardException;
import javino.board.OutcomeUnknownException;
import javino.board.QueueFullException;
import javino.board.RequestFailedException;
import javino.protocol.Status;

/**
 * Why a board's action or message failed, in terms that a plan can match: {@code error(Error)} and
 * {@code error_msg(Message)}. The errors are listed in docs/errors.md.
 *
 * @param error   an atom's name, such as {@code no_key}.
 * @param message one line: what was wrong and, where it helps, what to do.
 * @param detail  {@code reason(Term)} if the sketch gave one; {@code seconds(S)}, when to try again, if that is known.
 */
public record Failure(String error, String message, Optional<Literal> detail) {

    private static final String TOO_LONG = nameOf(Status.TOO_LONG);
    private static final String UNDELIVERED = "undelivered";
    private static final int MOST_BRIEF = 80;
    /** Those that each error of Jason's has: error and error_msg. */
    private static final int BASIC_TERMS = 2;
    private static final Map<Class<?>, String> ERRORS = Map.of(BoardOfflineException.class, "port_off",
            OutcomeUnknownException.class, "outcome_unknown", LegacyBoardException.class, "legacy_board",
            QueueFullException.class, "queue_full");

    /** A failure without more to tell. */
    public Failure(String error, String message) {
        this(error, message, Optional.empty());
    }

    /** Reads what a future of the board failed with. */
    public static Failure of(Throwable thrown) {
        if (thrown instanceof CompletionException && thrown.getCause() != null) {
            return of(thrown.getCause());
        }
        if (thrown instanceof JasonException exception) {
            ListTerm terms = exception.getErrorTerms();
            return new Failure(((Structure) terms.get(0)).getTerm(0).toString(), exception.getMessage(),
                    terms.stream().skip(BASIC_TERMS).map(Literal.class::cast).findFirst());
        }
        if (thrown instanceof TimeoutException) {
            return new Failure("timeout", "the board has not answered in time; it may or may not have done it");
        }
        if (thrown instanceof AirtimeUsedException used) {
            return new Failure("airtime_used", used.getMessage(),
                    Optional.of(ASSyntax.createLiteral("seconds", ASSyntax.createNumber(used.seconds()))));
        }
        String error = thrown instanceof RequestFailedException refused ? nameOf(refused.status())
                : ERRORS.getOrDefault(thrown.getClass(), "board_error");
        return new Failure(error, String.valueOf(thrown.getMessage()));
    }

    private static String nameOf(Status status) {
        return status.name().toLowerCase(Locale.ROOT);
    }

    /** Whether a message was sent and not acknowledged. */
    public boolean isUndelivered() {
        return error.equals(UNDELIVERED);
    }

    /** Whether something has more bytes than fit. */
    public boolean isTooLong() {
        return error.equals(TOO_LONG);
    }

    /** The message if it is short, else the error. */
    public String brief() {
        return message.length() <= MOST_BRIEF ? message : error;
    }

    /** The same, with the sketch's reason. */
    public Failure because(Term why) {
        return new Failure(error, message, Optional.of(ASSyntax.createLiteral("reason", why)));
    }

    /** As an exception of an internal action. */
    public JasonException toException() {
        JasonException exception = new JasonException(message, ASSyntax.createAtom(error));
        detail.ifPresent(exception::addErrorAnnot);
        return exception;
    }

    /** {@code reason(Reason)}, or {@code error(Error)} without one: Jason itself adds that an action has failed. */
    public Literal annotation() {
        return detail.orElseGet(() -> ASSyntax.createLiteral("error", ASSyntax.createAtom(error)));
    }

    /** {@code [error(Error), error_msg(Message)]}, and perhaps {@code reason(Reason)} or {@code seconds(S)}. */
    public ListTerm annotations() {
        return toException().getErrorTerms();
    }
}
