package uppaal.language;

import java.util.ArrayList;
import java.util.List;
import uppaal.ModelException;

/**
 * The words of conditions about clocks: {@code clock <= n}, {@code clock >= n} or {@code clock == n}, joined by
 * {@code &&} to each other and to what is said of variables. So every constraint is closed and free of diagonals, and
 * what can be reached at any real times can be reached at integer ones.
 */
public final class Clocks {
    private Clocks() {
    }

    /**
     * A comparison of a clock.
     *
     * @param slot the clock's
     * @param limit without clocks
     */
    public record Bound(int slot, Operator operator, Term limit) {
    }

    /**
     * All comparisons of clocks in a guard or an invariant.
     *
     * @throws ModelException when it says anything else of a clock
     */
    public static List<Bound> bounds(Term condition, String where) {
        List<Bound> bounds = new ArrayList<>();
        collect(condition, where, bounds);
        return bounds;
    }

    private static void collect(Term term, String where, List<Bound> bounds) {
        if (term instanceof Term.Binary binary && binary.operator() == Operator.AND) {
            collect(binary.left(), where, bounds);
            collect(binary.right(), where, bounds);
        } else if (isIn(term)) {
            bounds.add(bound(term, where));
        }
    }

    private static Bound bound(Term term, String where) {
        if (term instanceof Term.Binary binary && binary.left() instanceof Term.Clock clock && !isIn(binary.right())
                && List.of(Operator.AT_MOST, Operator.AT_LEAST, Operator.EQUAL).contains(binary.operator())) {
            return new Bound(clock.slot(), binary.operator(), binary.right());
        }
        throw ModelException.outside(where,
                "what is said of a clock here (only 'clock <= n', 'clock >= n' and 'clock == n', joined by '&&', are "
                        + "read)");
    }

    /** Whether any clock is in a term. */
    public static boolean isIn(Term term) {
        return term instanceof Term.Clock || term.operands().stream().anyMatch(Clocks::isIn);
    }
}
