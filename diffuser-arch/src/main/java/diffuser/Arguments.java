package diffuser;

import java.time.Duration;

import jason.JasonException;
import jason.asSemantics.InternalAction;
import jason.asSyntax.NumberTerm;
import jason.asSyntax.Term;

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
