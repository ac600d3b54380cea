package diffuser;

import java.time.Duration;
import java.util.Optional;

import jason.JasonException;
import jason.asSemantics.InternalAction;
import jason.asSyntax.NumberTerm;
import jason.asSyntax.Term;

import diffuser.board.BoardName;
import diffuser.gate.Names;
import diffuser.report.Failure;

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

    /**
     * A board's name.
     *
     * @throws JasonException wrong_arguments if it is none.
     */
    public static String board(InternalAction action, Term argument) throws JasonException {
        return BoardName.of(argument).orElseThrow(() -> JasonException.createWrongArgument(action,
                "a board's name such as arm was expected, not '" + argument + "'."));
    }

    /**
     * The board that is the first of two arguments; none if there is one argument, for all boards.
     *
     * @throws JasonException wrong_arguments if it is no name; no_port if no such board was opened.
     */
    public static Optional<String> boardBefore(InternalAction action, Diffuser diffuser, Term[] args)
            throws JasonException {
        if (args.length == 1) {
            return Optional.empty();
        }
        String name = board(action, args[0]);
        diffuser.requireDevice(name);
        return Optional.of(name);
    }

    /** @throws JasonException second_radio if the radio of a board beside the main one is meant: of two arguments. */
    public static void expectMain(InternalAction action, Term[] args) throws JasonException {
        if (args.length > 1) {
            throw new Failure("second_radio", "an agent has one radio, its main board's; give the board "
                    + board(action, args[0]) + " to another agent for a second one").toException();
        }
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
