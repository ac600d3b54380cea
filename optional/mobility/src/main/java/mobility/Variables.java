package mobility;

import java.util.HashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import jason.asSyntax.Term;
import jason.asSyntax.UnnamedVar;
import jason.asSyntax.VarTerm;

/**
 * The numbers of variables without a name, in the order in which they are written: {@code V_1} and so on, since a list
 * cannot end with a variable without a name in its text.
 */
final class Variables {

    private static final Pattern NUMBERED = Pattern.compile("V_(\\d{1,4})");

    private final Map<Term, Integer> numbers = new HashMap<>();

    VarTerm name(UnnamedVar variable) {
        return new VarTerm("V_" + numbers.computeIfAbsent(variable, unknown -> numbers.size() + 1));
    }

    /** The number that a variable's name stands for; -1 if it is a variable of the program. */
    static int numberOf(VarTerm variable) {
        Matcher number = NUMBERED.matcher(variable.getFunctor());
        return number.matches() ? Integer.parseInt(number.group(1)) : -1;
    }

    /** The number that it has got, or one that is higher than all. */
    int number(Term variable) {
        return numbers.getOrDefault(variable, Integer.MAX_VALUE);
    }
}
