package jason.stdlib;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;

import jason.JasonException;
import jason.asSyntax.ListTerm;
import jason.asSyntax.Literal;
import jason.asSyntax.LogExpr;
import jason.asSyntax.LogicalFormula;
import jason.asSyntax.RelExpr;
import jason.asSyntax.Term;

import diffuser.Arguments;
import diffuser.Diffuser;
import diffuser.DiffuserAction;
import diffuser.board.BoardName;
import diffuser.board.BoardSettings;
import diffuser.board.Filter;
import diffuser.gate.Names;

/**
 * <p>Internal action: <b><code>.filter(<i>B</i>,<i>Kind</i>,<i>Percepts</i>,<i>Condition</i>)</code></b>.
 *
 * <p>Description: chooses which of the board's percepts are believed. Several filters hold at the same time. The belief
 * <code>port(_,_)</code> is no percept of a sensor, and stays. The action can be called before there is a board.
 *
 * <p>Parameters:<ul>
 * <li>+ B (atom, optional): the board of that name; without it all boards are meant.
 * <li>+ Kind (atom): <code>except</code>: only these percepts are believed; <code>only</code> or <code>value</code>:
 *     only these are not; <code>remove</code>, alone or with a kind or <code>all</code>: removes these filters.
 * <li>+ Percepts (literal or list of literals): patterns of what the sketch says, whose variables match any value.
 * <li>+ Condition (comparison, optional): a percept matches only if the comparison holds for the pattern's variables.
 * </ul>
 *
 * <p>Examples:<ul>
 * <li> <code>.filter(except, light(_))</code>: of the sensors only <code>light</code> is believed.
 * <li> <code>.filter(only, distance(X), X &gt; 200)</code>: distances above 200 are not believed.
 * <li> <code>.filter(remove)</code>
 * </ul>
 */
public class filter extends DiffuserAction {

    private static final long serialVersionUID = 1L;

    @Override
    public int getMaxArgs() {
        return 4;
    }

    @Override
    protected void perform(Diffuser diffuser, Term[] args) throws JasonException {
        boolean named = args.length > 1 && BoardName.of(args[0]).isPresent();
        UnaryOperator<BoardSettings> change = change(named ? Arrays.copyOfRange(args, 1, args.length) : args);
        diffuser.change(named ? Arguments.boardBefore(this, diffuser, args) : Optional.empty(), change);
    }

    private UnaryOperator<BoardSettings> change(Term[] args) throws JasonException {
        return switch (Names.of(args[0]).orElse("")) {
            case "except" -> adding(Filter.Kind.EXCEPT, args);
            case "only", "value" -> adding(Filter.Kind.ONLY, args);
            case "remove" -> removing(args);
            default -> throw unknown(args[0]);
        };
    }

    private UnaryOperator<BoardSettings> removing(Term[] args) throws JasonException {
        return switch (args.length == 1 ? "all" : Names.of(args[1]).orElse("")) {
            case "all" -> old -> old.withoutFilters(List.of(Filter.Kind.values()));
            case "except" -> old -> old.withoutFilters(List.of(Filter.Kind.EXCEPT));
            case "only", "value" -> old -> old.withoutFilters(List.of(Filter.Kind.ONLY));
            default -> throw JasonException.createWrongArgument(this,
                    "all, except or only was expected after remove, not '" + args[1] + "'.");
        };
    }

    private UnaryOperator<BoardSettings> adding(Filter.Kind kind, Term[] args) throws JasonException {
        if (args.length == 1 || args.length == getMaxArgs()) {
            throw JasonException.createWrongArgument(this, "a percept, and perhaps a comparison, was expected too, such"
                    + " as .filter(" + args[0] + ", light(_)).");
        }
        Filter filter = new Filter(kind, patterns(args[1]), args.length == 2 ? Literal.LTrue : condition(args[2]));
        return old -> old.withFilter(filter);
    }

    private List<Literal> patterns(Term percepts) throws JasonException {
        List<Literal> patterns = new ArrayList<>();
        // A variable is an instance of ListTerm, too.
        for (Term percept : percepts.isList() ? ((ListTerm) percepts).getAsList() : List.of(percepts)) {
            if (!percept.isLiteral() || percept.isVar()) {
                throw JasonException.createWrongArgument(this,
                        "a percept such as light(X), or a list of such, was expected, not '" + percepts + "'.");
            }
            patterns.add((Literal) percept);
        }
        return patterns;
    }

    private LogicalFormula condition(Term condition) throws JasonException {
        if (!compares(condition)) {
            throw JasonException.createWrongArgument(this, "a comparison of the percept's values, such as X < 20, was"
                    + " expected, not '" + condition + "'.");
        }
        return (LogicalFormula) condition;
    }

    /** Whether no belief is asked for, as the board's thread knows none. */
    private static boolean compares(Term condition) {
        return condition instanceof RelExpr
                || condition instanceof LogExpr parts && parts.getTerms().stream().allMatch(filter::compares);
    }

    private JasonException unknown(Term kind) {
        return JasonException.createWrongArgument(this, "except, only or remove was expected, not '" + kind
                + "'; filters are not read from files: write .filter(except, light(_)) to believe light alone, or"
                + " .filter(only, light(_)) to believe all but light.");
    }
}
