package diffuser;

import jason.JasonException;
import jason.asSemantics.InternalAction;
import jason.asSyntax.Term;

/** Reads arguments that several internal actions share. */
public final class Arguments {

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
}
