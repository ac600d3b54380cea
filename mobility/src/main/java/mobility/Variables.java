package mobility;

import java.util.HashMap;
import java.util.Map;

import jason.asSyntax.Term;
import jason.asSyntax.UnnamedVar;
import jason.asSyntax.VarTerm;

/** The numbers of variables without a name, in the order in which they are written. */
final class Variables {

    private final Map<Term, Integer> numbers = new HashMap<>();

    VarTerm name(UnnamedVar variable) {
        return new VarTerm("_" + numbers.computeIfAbsent(variable, unknown -> numbers.size() + 1));
    }

    /** The number that it has got, or one that is higher than all. */
    int number(Term variable) {
        return numbers.getOrDefault(variable, Integer.MAX_VALUE);
    }
}
