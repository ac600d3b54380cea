package diffuser.board;

import java.util.List;

import jason.asSemantics.Unifier;
import jason.asSyntax.Literal;
import jason.asSyntax.LogicalFormula;

/**
 * Chooses which percepts an agent believes. The board's thread uses it too, so its result depends only on the percept.
 *
 * @param kind      says what to do with percepts that match.
 * @param patterns  patterns of which a percept must match one; each has its own variables.
 * @param condition compares values of a percept that matches, or is true.
 */
public record Filter(Kind kind, List<Literal> patterns, LogicalFormula condition) {

    /** The treatment of percepts that match. */
    public enum Kind {
        /** Only they are believed. */
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
