package uppaal.language;

import java.util.Optional;

/** The meanings of the names in an expression. */
public interface Names {
    /** The value of a simple name, if it has one. */
    Optional<Term> term(String name);

    /** The value of {@code automaton.name}, which only queries may ask for. */
    default Optional<Term> member(String automaton, String name) {
        return Optional.empty();
    }
}
