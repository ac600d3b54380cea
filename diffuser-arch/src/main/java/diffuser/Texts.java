package diffuser;

import java.util.Set;

import jason.JasonException;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Atom;
import jason.asSyntax.ListTerm;
import jason.asSyntax.Literal;
import jason.asSyntax.LiteralImpl;
import jason.asSyntax.Pred;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import jason.asSyntax.parser.ParseException;
import jason.asSyntax.parser.TokenMgrError;

import javino.protocol.Content;
import javino.protocol.Force;

/** Turns terms into the texts that travel, and texts into terms (SPEC 3). */
public final class Texts {

    private static final Set<Class<?>> LITERALS =
            Set.of(Atom.class, Structure.class, Pred.class, LiteralImpl.class);

    private Texts() {
    }

    /**
     * What one agent says to another.
     *
     * @param force the name of a force.
     * @param text  a term's.
     * @throws JasonException wrong_arguments if the force is none that can travel, bad_content if the text does not
     *                        read back as what agents say, too_long if it is longer than any message.
     */
    public static Content content(String force, String text) throws JasonException {
        Force known = Force.of(force).filter(any -> !any.requiresSeal()).orElseThrow(() -> new JasonException(
                "by radio go tell, untell, achieve and unachieve, not " + force, JasonException.WRONG_ARGS));
        said(text);
        try {
            return new Content(known, text);
        } catch (IllegalArgumentException e) {
            throw new Failure("too_long", e.getMessage()).toException();
        }
    }

    /**
     * What an agent is about to say, as its text reads.
     *
     * @throws JasonException bad_content if it is nothing that agents say.
     */
    static Term said(String text) throws JasonException {
        try {
            return readContent(text);
        } catch (MalformedTextException e) {
            throw new Failure("bad_content", "this cannot be sent: " + e.getMessage()).toException();
        }
    }

    /**
     * An action as the board reads it, {@code name} or {@code name(arguments)}, without annotations.
     *
     * @throws JasonException wrong_arguments if a variable in it has no value.
     */
    public static String action(Literal action) throws JasonException {
        if (!action.isGround()) {
            throw new JasonException("the action " + action + " has a variable without a value",
                    JasonException.WRONG_ARGS);
        }
        Literal plain = action.copy();
        plain.clearAnnots();
        return plain.toString();
    }

    /** Reads a percept: a literal without variables. */
    static Literal readPercept(String text) throws MalformedTextException {
        Term term = read(text);
        if (!isBelief(term)) {
            throw new MalformedTextException(text, "a belief was expected");
        }
        if (!term.isGround()) {
            throw new MalformedTextException(text, "it has a variable");
        }
        return (Literal) term;
    }

    /** Reads what a message says: a belief or goal, or a list of such. */
    static Term readContent(String text) throws MalformedTextException {
        Term term = read(text);
        // A variable is an instance of ListTerm, too.
        boolean understood = term.isList() ? ((ListTerm) term).stream().allMatch(Texts::isBelief) : isBelief(term);
        if (!understood) {
            throw new MalformedTextException(text, "a belief, a goal or a list of such was expected");
        }
        return term;
    }

    /** Plain literals only: Jason's classes for variables, formulas, plans and internal actions extend these. */
    private static boolean isBelief(Term term) {
        return LITERALS.contains(term.getClass());
    }

    private static Term read(String text) throws MalformedTextException {
        try {
            // Evaluated, since Jason parses -3 as an expression and not as a number.
            return ASSyntax.parseTerm(text).capply(new Unifier());
        } catch (ParseException | TokenMgrError | RuntimeException e) {
            throw new MalformedTextException(text, firstLine(e));
        }
    }

    private static String firstLine(Throwable thrown) {
        return String.valueOf(thrown.getMessage()).lines().findFirst().orElse("");
    }
}
