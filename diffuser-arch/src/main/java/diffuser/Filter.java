package diffuser;

import java.util.List;

import jason.asSemantics.Unifier;
import jason.asSyntax.Literal;
import jason.asSyntax.LogicalFormula;

/**
 * Which sensors an agent does not want to believe. It is for the board's thread too, so that what it says depends on a
 * percept alone.
 *
 * @param kind      what it does with percepts that match.
 * @param patterns  of which a percept must match one; what a variable stands for is nothing to the others.
 * @param condition compares values of a percept that matches, or is true.
 */
public record Filter(Kind kind, List<Literal> patterns, LogicalFormula condition) {

    /** What a filter does with percepts that match. */
    public enum Kind {
        /** They alone are believed. */
        EXCEPT,
        /** They are not believed. */
        ONLY
    }

    /** Whether a percept is to be believed. */
    boolean passes(Literal percept) {
        return matches(percept) == (kind == Kind.EXCEPT);
    }

    private boolean matches(Literal percept) {
        return patterns.stream().anyMatch(pattern -> {
            Unifier unifier = new Unifier();
            return unifier.unifies(pattern, percept) && condition.logicalConsequence(null, unifier).hasNext();
        });
    }
}
