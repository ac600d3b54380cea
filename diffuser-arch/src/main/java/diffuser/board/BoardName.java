package diffuser.board;

import java.util.Optional;
import java.util.regex.Pattern;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Atom;
import jason.asSyntax.Literal;
import jason.asSyntax.Term;

/** The names of an agent's boards: their percepts and actions are within it, as in {@code arm(light(5))}. */
public final class BoardName {

    /** Of the main board, whose percepts and actions are in no name. */
    public static final String MAIN = "";

    /** Not what a filter or Jason would read otherwise; nor with two underlines, which may mean something to Jason. */
    private static final Pattern PLAIN =
            Pattern.compile("(?!(except|only|value|remove|true|false)$)[a-z](_?[A-Za-z0-9])*");

    private BoardName() {
    }

    /** The name that a term is; none if it is no plain atom, or has another meaning. */
    public static Optional<String> of(Term term) {
        return Optional.of(term).filter(Term::isAtom).map(atom -> ((Atom) atom).getFunctor())
                .filter(name -> PLAIN.matcher(name).matches()
                        && Percepts.OWN.stream().noneMatch(own -> own.startsWith(name + "/")));
    }

    /** A percept of that board as the agent believes it. Its annotations are the belief's, where plans ask for them. */
    static Literal within(String board, Literal percept) {
        if (board.equals(MAIN)) {
            return percept;
        }
        Literal plain = percept.copy();
        plain.clearAnnots();
        return ASSyntax.createLiteral(board, plain).setAnnots(percept.getAnnots());
    }
}
