package diffuser.gate;

import java.util.Optional;
import java.util.regex.Pattern;

import jason.asSyntax.Atom;
import jason.asSyntax.StringTerm;
import jason.asSyntax.Term;

/**
 * Reads what users write for a port or an address: {@code "COM5"}, {@code ttyACM0}, or {@code COM5}, which Jason
 * takes for a variable. A variable without a value stands for its own name.
 */
public final class Names {

    /**
     * Jason's prefix to the name of a variable that it renames, as it does when the variable goes through a goal:
     * {@code _12COM5}. By default it drops the name altogether, and only {@code _12} is left.
     */
    private static final Pattern RENAMING = Pattern.compile("^(_\\d+)+");

    private Names() {
    }

    /** The name that a term stands for; none if the term is no name: a number, a structure, {@code _}. */
    public static Optional<String> of(Term term) {
        if (term instanceof StringTerm string) {
            return nonEmpty(string.getString());
        }
        if (term.isVar()) {
            return nonEmpty(RENAMING.matcher(((Atom) term).getFunctor()).replaceFirst(""))
                    .filter(name -> !name.startsWith("_"));
        }
        if (term.isAtom()) {
            return nonEmpty(unquoted(((Atom) term).getFunctor()));
        }
        return Optional.empty();
    }

    /** A functor without the quotes in which a program may write it, and which Jason keeps. */
    public static String unquoted(String functor) {
        boolean quoted = functor.length() >= 2 && functor.startsWith("'") && functor.endsWith("'");
        return quoted ? functor.substring(1, functor.length() - 1) : functor;
    }

    private static Optional<String> nonEmpty(String name) {
        return name.isEmpty() ? Optional.empty() : Optional.of(name);
    }
}
