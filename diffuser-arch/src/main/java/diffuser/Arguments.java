package diffuser;

import java.time.Duration;
import java.util.Optional;

import jason.JasonException;
import jason.asSemantics.InternalAction;
import jason.asSyntax.NumberTerm;
import jason.asSyntax.Term;

import diffuser.board.BoardName;
import diffuser.gate.Names;

/** Reads arguments that several internal actions share. */
public final class Arguments {

    private static final double MOST_MILLISECONDS = Duration.ofHours(1).toMillis();

    private Arguments() {
    }

    /**
     * {@code open} or {@code block}.
     *
     * @throws JasonException wrong_arguments if it is anything else.
     */
    public static boolean isOpen(InternalAction action, Term argument) throws JasonException {
        return switch (Names.of(argument).orElse("")) {
            case "open" -> true;
            case "block" -> false;
            default -> throw JasonException.createWrongArgument(action,
                    "open or block was expected, not '" + argument + "'.");
        };
    }

    /** A board's name. @throws JasonException wrong_arguments if it is none. */
    public static String board(InternalAction action, Term argument) throws JasonException {
        return BoardName.of(argument).orElseThrow(() -> JasonException.createWrongArgument(action,
                "a board's name such as arm was expected, not '" + argument + "'."));
    }

    /** The board that is the first argument, and was opened; none, for all boards, if there is only one argument. */
    public static Optional<String> boardBefore(InternalAction action, Diffuser diffuser, Term[] args)
            throws JasonException {
        if (args.length > 1) {
            diffuser.requireDevice(board(action, args[0]));
        }
        return args.length == 1 ? Optional.empty() : BoardName.of(args[0]);
    }

    /**
     * Milliseconds, 0 to 3600000, of which fractions are cut off.
     *
     * @throws JasonException wrong_arguments if it is anything else.
     */
    public static Duration milliseconds(InternalAction action, Term argument) throws JasonException {
        double milliseconds = argument.isNumeric() ? ((NumberTerm) argument).solve() : -1;
        if (!(milliseconds >= 0 && milliseconds <= MOST_MILLISECONDS)) {
            throw JasonException.createWrongArgument(action, "milliseconds from 0 to " + (long) MOST_MILLISECONDS
                    + " were expected, not '" + argument + "'.");
        }
        return Duration.ofMillis((long) milliseconds);
    }
}
