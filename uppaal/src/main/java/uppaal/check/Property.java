package uppaal.check;

import java.util.Optional;
import uppaal.ModelException;
import uppaal.language.Clocks;
import uppaal.language.Expressions;
import uppaal.language.Names;
import uppaal.language.Operator;
import uppaal.language.Term;
import uppaal.network.Network;

/**
 * {@code A[] formula}, {@code E<> formula}, {@code A<> formula} or {@code premise --> formula}.
 *
 * @param premise the condition before {@code -->}; else always true
 * @param formula the condition for each state; it is evaluated on an observed state (with {@code deadlock})
 * @param text the property as UPPAAL writes it
 */
public record Property(Quantifier quantifier, Term premise, Term formula, String text) {

    private static final String LEADS_TO = "-->";

    /** Over which states the formula is to be true. */
    public enum Quantifier {
        /** In all. */
        ALWAYS("A[]"),
        /** In at least one. */
        POSSIBLY("E<>"),
        /** In one of each run. */
        EVENTUALLY("A<>"),
        /** In one of each run from any state that has the premise. */
        AFTERWARDS(LEADS_TO);

        private final String symbol;

        Quantifier(String symbol) {
            this.symbol = symbol;
        }
    }

    /**
     * Parses a property.
     *
     * @param where file and element, for messages
     */
    public static Property parse(String text, Names names, String where) {
        String body = text.strip();
        int arrow = body.indexOf(LEADS_TO);
        if (arrow >= 0) {
            return new Property(Quantifier.AFTERWARDS, ofRun(body.substring(0, arrow), names, where),
                    ofRun(body.substring(arrow + LEADS_TO.length()), names, where), body);
        }
        if (body.startsWith(Quantifier.ALWAYS.symbol)) {
            return always(formula(body.substring(Quantifier.ALWAYS.symbol.length()), names, where), body);
        }
        if (body.startsWith(Quantifier.POSSIBLY.symbol)) {
            return possibly(formula(body.substring(Quantifier.POSSIBLY.symbol.length()), names, where), body);
        }
        if (body.startsWith(Quantifier.EVENTUALLY.symbol)) {
            Term formula = ofRun(body.substring(Quantifier.EVENTUALLY.symbol.length()), names, where);
            return new Property(Quantifier.EVENTUALLY, Term.TRUE, formula, body);
        }
        throw ModelException.outside(where, "a query that neither begins with A[], E<> or A<> nor has -->");
    }

    /** A clock that nobody will look at is not counted: its time must be asked for in the network, by a location. */
    private static Term formula(String text, Names names, String where) {
        Term term = Expressions.parse(text, names, where);
        if (Clocks.isIn(term)) {
            throw ModelException.outside(where, "a clock in a query");
        }
        return term;
    }

    private static Term ofRun(String text, Names names, String where) {
        return formula(text, new WithoutDeadlock(names, where), where);
    }

    /** Names without {@code deadlock}, for which UPPAAL does not ask there either. */
    private record WithoutDeadlock(Names names, String where) implements Names {
        @Override
        public Optional<Term> term(String name) {
            if (name.equals(Network.DEADLOCK)) {
                throw ModelException.outside(where, "'deadlock' with A<> or -->");
            }
            return names.term(name);
        }

        @Override
        public Optional<Term> member(String automaton, String name) {
            return names.member(automaton, name);
        }
    }

    /** {@code A[] formula} */
    public static Property always(Term formula, String text) {
        return new Property(Quantifier.ALWAYS, Term.TRUE, formula, text);
    }

    /** {@code E<> formula} */
    public static Property possibly(Term formula, String text) {
        return new Property(Quantifier.POSSIBLY, Term.TRUE, formula, text);
    }

    /** Whether it speaks of whole runs, so that no single state settles it. */
    public boolean ofRuns() {
        return quantifier == Quantifier.EVENTUALLY || quantifier == Quantifier.AFTERWARDS;
    }

    /** Whether a run of which it speaks begins in a state. */
    boolean begins(boolean first, int[] observed) {
        return quantifier == Quantifier.AFTERWARDS ? premise.holds(observed) : first;
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
