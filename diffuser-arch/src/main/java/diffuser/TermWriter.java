package diffuser;

import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.Atom;
import jason.asSyntax.ListTerm;
import jason.asSyntax.Literal;
import jason.asSyntax.LogicalFormula;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.Rule;
import jason.asSyntax.StringTerm;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;

/**
 * Writes a term as a text that reads back as the term. Jason's own text of one is for people: it leaves out what its
 * parser takes off strings, and does not quote the atom {@code ROMA}, which then reads as a variable.
 */
public final class TermWriter {

    /** What Jason's parser takes for a string; of its escapes it resolves only \n and \". */
    private static final Pattern STRING =
            Pattern.compile("(?:[^\"\\\\\\n\\r]|\\\\(?:[ntbrf\\\\'\"]|[0-3][0-7]{2}|[0-7]{1,2}))*+");
    private static final Pattern ATOM = Pattern.compile("(?:[a-z]|\\.\\w)(?:\\w|\\.\\w)*+|'[^']*'");

    private TermWriter() {
    }

    /** @throws MalformedTextException if a string in it has no text that reads back, as with a single backslash. */
    public static String write(Term term) throws MalformedTextException {
        return readable(term.clone()).toString();
    }

    /** The term, with all strings and atoms in it so that Jason's text of it reads back. Changes what it is given. */
    private static Term readable(Term term) throws MalformedTextException {
        if (term instanceof StringTerm string) {
            return ASSyntax.createString(escaped(string.getString()));
        }
        if (term instanceof Plan plan) {
            return readablePlan(plan);
        }
        if (term instanceof PlanBody body) {
            return readableBody(body);
        }
        if (term instanceof Rule rule) {
            Rule result = new Rule((Literal) readable(rule.getHead()), (LogicalFormula) readable(rule.getBody()));
            result.setAsTerm(rule.isTerm());
            return result;
        }
        if (term instanceof Trigger trigger) {
            trigger.setLiteral((Literal) readable(trigger.getLiteral()));
            return trigger;
        }
        if (term.isList()) {
            return readableList((ListTerm) term);
        }
        if (term instanceof Structure structure && !term.isVar()) {
            return readableStructure(structure);
        }
        return term.getClass() == Atom.class ? readableAtom((Atom) term) : term;
    }

    /** Jason keeps no braces for what {@code if}, {@code while} and {@code for} have in braces. */
    private static Term part(Term term) throws MalformedTextException {
        if (term instanceof PlanBody body) {
            body.setAsBodyTerm(true);
        }
        return readable(term);
    }

    private static Plan readablePlan(Plan plan) throws MalformedTextException {
        plan.setAsPlanTerm(true);
        readable(plan.getTrigger());
        readable(plan.getBody());
        if (plan.getLabel() != null) {
            // Jason notes there which file it read the plan from.
            plan.getLabel().delAnnots(plan.getLabel().getAnnots("url"));
            readable(plan.getLabel());
        }
        if (plan.getContext() != null) {
            readable(plan.getContext());
        }
        return plan;
    }

    private static PlanBody readableBody(PlanBody body) throws MalformedTextException {
        for (PlanBody step = body; step != null; step = step.getBodyNext()) {
            if (step.getBodyTerm() != null) {
                step.setBodyTerm(part(step.getBodyTerm()));
            }
        }
        return body;
    }

    private static ListTerm readableList(ListTerm list) throws MalformedTextException {
        for (ListTerm cell = list; cell != null && !cell.isVar() && !cell.isEmpty(); cell = cell.getNext()) {
            cell.setTerm(part(cell.getTerm()));
        }
        return list;
    }

    private static Structure readableStructure(Structure structure) throws MalformedTextException {
        for (int i = 0; i < structure.getArity(); i++) {
            structure.setTerm(i, part(structure.getTerm(i)));
        }
        if (structure.hasAnnot()) {
            readableList(structure.getAnnots());
        }
        return structure;
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
