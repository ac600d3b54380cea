package diffuser.board;

import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Atom;
import jason.asSyntax.Literal;
import jason.asSyntax.Term;

import diffuser.gate.Gate;
import diffuser.gate.MalformedTextException;

/** The names of an agent's boards: their percepts and actions are within it, as in {@code arm(light(5))}. */
public final class BoardName {

    /** Of the main board, whose percepts and actions are in no name. */
    public static final String MAIN = "";

    private static final Pattern PLAIN = Pattern.compile("[a-z][A-Za-z0-9_]*");
    /** What a filter, or Jason, would read otherwise. */
    private static final Set<String> TAKEN = Set.of("except", "only", "value", "remove", "true", "false");

    private BoardName() {
    }

    /** The name that a term is; none if it is no plain atom, or has another meaning to the architecture or to Jason. */
    public static Optional<String> of(Term term) {
        String name = term.isAtom() ? ((Atom) term).getFunctor() : MAIN;
        return PLAIN.matcher(name).matches() && !TAKEN.contains(name) && !Percepts.isOwn(name) && passes(name)
                ? Optional.of(name) : Optional.empty();
    }

    private static boolean passes(String name) {
        try {
            Percepts.admitted(name + "(x)");
            return true;
        } catch (MalformedTextException | Gate.RefusedException e) {
            return false;
        }
    }

    /** A percept of that board as the agent believes it. Its annotations are the belief's, where plans ask for them. */
    static Literal within(String board, Literal percept) {
        if (board.equals(MAIN)) {
            return percept;
        }
        Literal plain = percept.copy();
        plain.clearAnnots();
        Literal belief = ASSyntax.createLiteral(board, plain);
        if (percept.hasAnnot()) {
            belief.setAnnots(percept.getAnnots().cloneLT());
        }
        return belief;
    }
}
