package diffuser;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Term;
import jason.asSyntax.parser.ParseException;

/** Terms of tests. */
final class Literals {

    private Literals() {
    }

    static Term of(String text) {
        try {
            return ASSyntax.parseTerm(text);
        } catch (ParseException e) {
            throw new IllegalArgumentException(e);
        }
    }
}
