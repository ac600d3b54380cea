package uppaal.language;

import java.util.Optional;

/** What the names in an expression stand for. */
public interface Names {
    /** The value of a simple name, if it has one. */
    Optional<Term> term(String name);

    /** The value of {@code automaton.name}, which only queries may ask for. */
    default Optional<Term> member(String automaton, String name) {
        return Optional.empty();
    }
}
