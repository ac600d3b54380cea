package uppaal.check;

import java.util.Optional;
import uppaal.ModelException;
import uppaal.language.Clocks;
import uppaal.language.Expressions;
import uppaal.language.Names;
import uppaal.language.Operator;
import uppaal.language.Term;

/**
 * {@code A[] formula} or {@code E<> formula}.
 *
 * @param formula what is asked of each state; it is evaluated on an observed state (with {@code deadlock})
 * @param text the property as UPPAAL writes it
 */
public record Property(Quantifier quantifier, Term formula, String text) {

    private static final String ALWAYS = "A[]";
    private static final String POSSIBLY = "E<>";

    /** Over which states the formula is to be true. */
    public enum Quantifier { ALWAYS, POSSIBLY }

    /**
     * Parses a property.
     *
     * @param where file and element, for messages
     */
    public static Property parse(String text, Names names, String where) {
        String body = text.strip();
        if (body.startsWith(ALWAYS)) {
            return always(formula(body.substring(ALWAYS.length()), names, where), body);
        }
        if (body.startsWith(POSSIBLY)) {
            return possibly(formula(body.substring(POSSIBLY.length()), names, where), body);
        }
        throw ModelException.outside(where, "a query that begins neither with A[] nor with E<>");
    }

    /** A clock that nobody will look at is not counted: its time must be asked for in the network, by a location. */
    private static Term formula(String text, Names names, String where) {
        Term term = Expressions.parse(text, names, where);
        if (Clocks.isIn(term)) {
            throw ModelException.outside(where, "a clock in a query");
        }
        return term;
    }

    /** {@code A[] formula} */
    public static Property always(Term formula, String text) {
        return new Property(Quantifier.ALWAYS, formula, text);
    }

    /** {@code E<> formula} */
    public static Property possibly(Term formula, String text) {
        return new Property(Quantifier.POSSIBLY, formula, text);
    }

    /** Whether this one state settles it: refutes {@code A[]} or shows {@code E<>}. */
    public boolean settledBy(int[] observed) {
        return formula.holds(observed) == (quantifier == Quantifier.POSSIBLY);
    }

    /** The left and the right side of {@code A[] left imply right}. */
    public Optional<Term.Binary> implication() {
        return quantifier == Quantifier.ALWAYS && formula instanceof Term.Binary binary
                && binary.operator() == Operator.IMPLY ? Optional.of(binary) : Optional.empty();
    }
}
