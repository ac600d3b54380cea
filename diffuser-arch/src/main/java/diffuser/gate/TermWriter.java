package diffuser.gate;

import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Atom;
import jason.asSyntax.Literal;
import jason.asSyntax.NumberTermImpl;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.StringTerm;
import jason.asSyntax.Term;

/**
 * Writes a term as a text that reads back as the term. Jason's own text of one is for people: it leaves out what its
 * parser takes off strings, and does not quote the atom {@code ROMA}, which then reads as a variable.
 */
public final class TermWriter {

    /** Texts that Jason's parser takes for a string; of its escapes it resolves only \n and \". */
    private static final Pattern STRING =
            Pattern.compile("(?:[^\"\\\\\\n\\r]|\\\\(?:[ntbrf\\\\'\"]|[0-3][0-7]{2}|[0-7]{1,2}))*+");
    private static final Pattern ATOM = Pattern.compile("(?:[a-z]|\\.\\w)(?:\\w|\\.\\w)*+|'[^']*'");

    private TermWriter() {
    }

    /** @throws MalformedTextException if what is in it has no text that reads back, as 1/0 or a single backslash. */
    public static String write(Term term) throws MalformedTextException {
        boolean inBraces = !(term instanceof PlanBody body) || body.isBodyTerm();
        Term copy = Terms.replace(term.clone(), TermWriter::readable);
        if (copy instanceof PlanBody body) {
            body.setAsBodyTerm(inBraces);
        }
        return copy.toString();
    }

    /** A part of a term, so that Jason's text of it reads back. */
    private static Term readable(Term part) throws MalformedTextException {
        if (part instanceof StringTerm string) {
            return ASSyntax.createString(escaped(string.getString()));
        }
        if (part instanceof NumberTermImpl number && !Double.isFinite(number.solve())) {
            throw new MalformedTextException(part.toString(), "a number that is not finite reads back as a variable");
        }
        if (part instanceof PlanBody body) {
            // Jason keeps no braces for what if, while and for have in braces.
            body.setAsBodyTerm(true);
        } else if (part instanceof Plan plan) {
            plan.setAsPlanTerm(true);
            plan.getBody().setAsBodyTerm(false);
            if (plan.getLabel() != null) {
                // Jason notes there which file it read the plan from.
                plan.getLabel().delAnnots(plan.getLabel().getAnnots("url"));
            }
        }
        return part.getClass() == Atom.class ? readableAtom((Atom) part) : part;
    }

    private static Atom readableAtom(Atom atom) {
        boolean plain = ATOM.matcher(atom.getFunctor()).matches() || atom.getFunctor().contains("'")
                || atom.getNS() != Literal.DefaultNS;
        return plain ? atom : ASSyntax.createAtom("'" + atom.getFunctor() + "'");
    }

    private static String escaped(String value) throws MalformedTextException {
        String text = value.replace("\n", "\\n").replace("\"", "\\\"");
        boolean same = StandardCharsets.UTF_8.newEncoder().canEncode(value) && STRING.matcher(text).matches()
                && text.replace("\\n", "\n").replace("\\\"", "\"").equals(value);
        if (!same) {
            throw new MalformedTextException(value, "a string with a single backslash, a carriage return or half a"
                    + " character does not read back");
        }
        return text;
    }
}
