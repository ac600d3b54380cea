package mobility;

import java.util.regex.Pattern;

import jason.asSyntax.ArithExpr;
import jason.asSyntax.ArithFunctionTerm;
import jason.asSyntax.Atom;
import jason.asSyntax.CyclicTerm;
import jason.asSyntax.ListTerm;
import jason.asSyntax.Literal;
import jason.asSyntax.MapTerm;
import jason.asSyntax.NumberTermImpl;
import jason.asSyntax.ObjectTerm;
import jason.asSyntax.PlanBody;
import jason.asSyntax.SetTerm;
import jason.asSyntax.StringTerm;
import jason.asSyntax.Term;
import jason.asSyntax.UnnamedVar;
import jason.asSyntax.VarTerm;
import jason.asSyntax.directives.FunctionRegister;
import jason.bb.BeliefBase;

import diffuser.gate.MalformedTextException;
import diffuser.gate.TermWriter;
import diffuser.gate.Terms;
import diffuser.gate.Texts;

/** Writes terms as texts that read back elsewhere, or says why there is none. */
final class TermTexts {

    /** As CArtAgO calls what its artifacts hand to agents. */
    private static final Pattern HANDLE = Pattern.compile("cobj_\\d+");
    private static final int MOST_BRIEF = 80;

    /** Names a variable without a name. */
    interface Naming {
        VarTerm of(UnnamedVar variable);
    }

    private TermTexts() {
    }

    /** @param why something has no text that could travel, in one line. */
    static RefusedException cannot(String why) {
        return new RefusedException("cannot_travel", why);
    }

    static String text(Term term, Naming naming) throws RefusedException {
        try {
            return TermWriter.write(named(term, naming));
        } catch (MalformedTextException e) {
            throw cannot(e.getMessage());
        }
    }

    /** The text of a value, in which nothing is left to be computed. */
    static String value(Term term, Naming naming) throws RefusedException {
        return text(plain(term), naming);
    }

    /** With numbers in place of what Jason's parser takes for an expression, as {@code -3}. */
    static Term plain(Term term) throws RefusedException {
        return TermReader.datum(brief(term), term.clone());
    }

    /** The steps of a body, without braces around them. */
    static String body(PlanBody body, Naming naming) throws RefusedException {
        PlanBody copy = body.clonePB();
        for (PlanBody step = copy; step != null; step = step.getBodyNext()) {
            // Each has a note of its own.
            step.setAsBodyTerm(true);
            step.setAsBodyTerm(false);
        }
        return text(copy, naming);
    }

    /** A copy in which all variables have names. */
    static Term named(Term term, Naming naming) throws RefusedException {
        return Terms.replace(term.clone(), part -> {
            check(part);
            return part instanceof UnnamedVar variable ? like(variable, naming.of(variable)) : part;
        });
    }

    /** A variable of another name in the same place. */
    static VarTerm like(VarTerm old, VarTerm name) {
        VarTerm result = (VarTerm) name.cloneNS(old.getNS());
        result.setNegated(old.negated() ? Literal.LNeg : Literal.LPos);
        if (old.hasAnnot()) {
            result.setAnnots(old.getAnnots());
        }
        return result;
    }

    /** Refuses what has no text. */
    static void check(Term part) throws RefusedException {
        if (part instanceof ObjectTerm || part instanceof SetTerm || part instanceof MapTerm) {
            throw cannot("it holds a Java object, " + brief(part));
        }
        if (part instanceof CyclicTerm) {
            throw cannot("it holds a term that contains itself");
        }
        if (part.getClass() == Atom.class && HANDLE.matcher(((Atom) part).getFunctor()).matches()) {
            throw cannot("it holds an artifact's handle, " + part);
        }
        if (part instanceof NumberTermImpl number && !Double.isFinite(number.solve())) {
            throw cannot("it holds a number that has no text, " + number);
        }
        if (part instanceof VarTerm variable && Variables.numberOf(variable) >= 0) {
            throw cannot("a variable's name is " + part + ", by which others travel; rename it");
        }
        boolean unknown = part instanceof ArithFunctionTerm function && !(part instanceof ArithExpr)
                && !function.getFunctor().equals(TermReader.COUNT)
                && FunctionRegister.getFunction(function.getFunctor(), function.getArity()) == null;
        if (unknown) {
            throw cannot("it uses a function that is registered here, " + brief(part));
        }
    }

    /** Without the note that the agent itself is the source, if nobody else is. */
    static Literal withoutSelf(Literal literal) {
        Literal copy = literal.copy();
        ListTerm sources = copy.getSources();
        if (sources != null && sources.size() == 1 && copy.hasAnnot(BeliefBase.TSelf)) {
            copy.delAnnot(BeliefBase.TSelf);
        }
        return copy;
    }

    /** A term in one short line, for messages. */
    static String brief(Term term) {
        String text = term instanceof StringTerm string ? string.getString() : String.valueOf(term);
        String line = Texts.withoutCommands(text);
        return line.length() <= MOST_BRIEF ? line : line.substring(0, MOST_BRIEF) + "…";
    }
}
