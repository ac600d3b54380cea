package mobility;

import java.io.StringReader;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import jason.asSemantics.Agent;
import jason.asSemantics.InternalAction;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.ArithExpr;
import jason.asSyntax.ArithFunctionTerm;
import jason.asSyntax.InternalActionLiteral;
import jason.asSyntax.ListTerm;
import jason.asSyntax.Literal;
import jason.asSyntax.NumberTermImpl;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.Pred;
import jason.asSyntax.Rule;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.asSyntax.UnnamedVar;
import jason.asSyntax.VarTerm;
import jason.asSyntax.parser.ParseException;
import jason.asSyntax.parser.SimpleCharStream;
import jason.asSyntax.parser.TokenMgrError;
import jason.asSyntax.parser.as2j;
import jason.asSyntax.parser.as2jConstants;
import jason.asSyntax.parser.as2jTokenManager;
import jason.bb.BeliefBase;

import diffuser.gate.Gate;
import diffuser.gate.MalformedTextException;
import diffuser.gate.Names;
import diffuser.gate.Plans;
import diffuser.gate.Terms;
import diffuser.gate.Texts;

/** Reads the texts of an agent from elsewhere. Terms are only looked at: nothing in them is computed. */
final class TermReader {

    /** The one function that belongs to each agent, and not to Jason as a whole. */
    static final String COUNT = ".count";

    private static final Agent NOBODY = new Nobody();

    /** Jason's parser and its terms call themselves for each; so many need a quarter of a thread's usual stack. */
    private static final int MOST_TOKENS = 4096;
    /** No program of ours has more than a dozen; a stack bears thousands. */
    private static final int DEEPEST = 100;
    private static final String STDLIB = "jason.stdlib";
    private static final String JASONS_LABELS = "kqml";
    /** The name here of a label that has only annotations. */
    static final String NO_LABEL = "undefined";

    private final boolean numbersVariables;
    /** The variables without a name, by their numbers. */
    private final List<UnnamedVar> fresh = new ArrayList<>();

    private TermReader(boolean numbersVariables) {
        this.numbersVariables = numbersVariables;
    }

    /** A reader for one part of an agent's state: a belief, or an event with its intention. */
    static TermReader ofState() {
        return new TermReader(true);
    }

    private static TermReader ofProgram() {
        return new TermReader(false);
    }

    static Rule rule(String text) throws RefusedException {
        return ofProgram().checked(text, parser -> (Rule) parser.belief());
    }

    static Plan plan(String text) throws RefusedException {
        Plan plan = parsed(text, as2j::plan);
        TermReader reading = ofProgram();
        for (Plan part : Library.all(plan)) {
            refuseJasonsOwn(text, part);
            if (part.getGoalCondition() != null) {
                refuseJasonsOwn(text, part.getGoalCondition());
            }
            reading.revised(text, part);
        }
        if (text.startsWith("@[")) {
            // Jason 3.2 and 3.3 call it differently.
            Pred label = new Pred(NO_LABEL);
            label.setAnnots(plan.getLabel().getAnnots());
            plan.setLabel(label);
        }
        refuseLabel(text, plan);
        return plan;
    }

    private static void refuseLabel(String text, Plan plan) throws RefusedException {
        if (plan.getLabel() != null) {
            String name = Names.unquoted(plan.getLabel().getFunctor());
            expect(!name.startsWith(JASONS_LABELS) && !Plans.GENERATED.matcher(name).matches(), text,
                    "its label is one of Jason's own");
        }
    }

    static Literal belief(String text) throws RefusedException {
        Term term = ofState().checked(text, as2j::term);
        expect(Texts.isBelief(term), text, "a belief was expected");
        Literal belief = ((Literal) datum(text, term)).forceFullLiteralImpl();
        expect(!belief.hasAnnot(BeliefBase.TPercept), text, "what is perceived there is no percept here");
        return fromSelf(belief);
    }

    /** @param past whether what it says has happened: then a percept may have been its cause. */
    Trigger trigger(String text, boolean past) throws RefusedException {
        Trigger trigger = checked(text, as2j::trigger);
        Literal literal = trigger.getLiteral();
        expect(Texts.isBelief(literal), text, "an event was expected");
        literal = ((Literal) datum(text, literal)).forceFullLiteralImpl();
        expect(past && !trigger.isGoal() || !literal.hasAnnot(BeliefBase.TPercept), text,
                "what is perceived there is no percept here");
        trigger.setLiteral(fromSelf(literal));
        trigger.setAsTriggerTerm(false);
        return trigger;
    }

    private static Literal fromSelf(Literal literal) {
        if (!literal.hasSource()) {
            literal.addAnnot(BeliefBase.TSelf);
        }
        return literal;
    }

    PlanBody body(String text) throws RefusedException {
        return checked(text, as2j::plan_body);
    }

    /** Pairs of a variable and its value, all separated by commas. */
    Map<VarTerm, Term> values(String text) throws RefusedException {
        return values(text, checked("[" + text + "]", as2j::term));
    }

    static Map<VarTerm, Term> values(String text, Term list) throws RefusedException {
        expect(list.isList(), text, "values of variables were expected");
        List<Term> parts = new ArrayList<>((ListTerm) list);
        expect(parts.size() % 2 == 0 && ((ListTerm) list).getTail() == null, text,
                "pairs of a variable and a value were expected");
        Map<VarTerm, Term> values = new HashMap<>();
        for (int i = 0; i < parts.size(); i += 2) {
            expect(parts.get(i) instanceof VarTerm variable && !variable.hasAnnot() && !variable.negated()
                    && !parts.get(i).equals(parts.get(i + 1)), text, "a variable was expected");
            expect(values.put((VarTerm) parts.get(i), datum(text, parts.get(i + 1))) == null, text,
                    "a variable has two values");
        }
        return values;
    }

    // Checks

    /** One of the parser's ways to read. */
    private interface Kind<T> {
        T read(as2j parser) throws ParseException;
    }

    /** Knows the functions that each agent has. An internal action's class is looked for when the action runs. */
    private static final class Nobody extends Agent {

        private static final long serialVersionUID = 1L;

        Nobody() {
            initDefaultFunctions();
            Library.give(this);
        }

        @Override
        public InternalAction getIA(String name) {
            return null;
        }
    }

    private <T extends Term> T checked(String text, Kind<T> kind) throws RefusedException {
        T term = parsed(text, kind);
        refuseJasonsOwn(text, term);
        return revised(text, term);
    }

    private static <T extends Term> T parsed(String text, Kind<T> kind) throws RefusedException {
        try {
            Texts.expectNoCommand(text);
            expectModest(text);
            return Texts.parsed(text, whole -> {
                as2j parser = new as2j(new StringReader(whole));
                parser.setAg(NOBODY);
                T term = kind.read(parser);
                if (parser.getNextToken().kind != as2jConstants.EOF) {
                    throw new ParseException("there is something behind it");
                }
                return term;
            });
        } catch (MalformedTextException e) {
            throw refused(text, e.getMessage().substring(e.getMessage().indexOf("\": ") + 3));
        } catch (StackOverflowError e) {
            throw refused(text, "it nests too deeply");
        }
    }

    private static void expectModest(String text) throws RefusedException {
        as2jTokenManager tokens = new as2jTokenManager(new SimpleCharStream(new StringReader(text)));
        int count = 0;
        int depth = 0;
        try {
            for (var token = tokens.getNextToken(); token.kind != as2jConstants.EOF; token = tokens.getNextToken()) {
                count++;
                depth += token.image.equals("(") ? 1 : token.image.equals(")") ? -1 : 0;
                expect(count <= MOST_TOKENS && depth <= DEEPEST, text, "it is too long or nests too deeply");
            }
        } catch (TokenMgrError e) {
            throw refused(text, "it has a character that AgentSpeak does not know");
        }
    }

    private static void refuseJasonsOwn(String text, Term term) throws RefusedException {
        try {
            Gate.refuseJasonsOwn(Terms.<RuntimeException>replace(term.clone(), TermReader::withPlainActions));
        } catch (Gate.RefusedException e) {
            throw refused(text, e.getMessage());
        }
    }

    /**
     * A body whose plain actions are of no namespace: a variable for theirs, as in the plans of JaCaMo, matches nothing
     * of Jason's. Their names and parts stay.
     */
    private static Term withPlainActions(Term term) {
        if (term instanceof PlanBody body) {
            for (PlanBody step = body; step != null && !step.isEmptyBody(); step = step.getBodyNext()) {
                boolean plain = step.getBodyType() == PlanBody.BodyType.action && !step.getBodyTerm().isVar()
                        && step.getBodyTerm() instanceof Literal action && action.getNS().isVar();
                if (plain) {
                    step.setBodyTerm(step.getBodyTerm().cloneNS(Literal.DefaultNS));
                }
            }
        }
        return term;
    }

    /** With variables of its own. */
    @SuppressWarnings("unchecked")
    private <T extends Term> T revised(String text, T term) throws RefusedException {
        return (T) Terms.replace(term, part -> {
            if (part instanceof UnnamedVar variable) {
                // Jason takes _1 for the same variable wherever it stands, also in other plans.
                expect(variable.myId > 0, text, "a variable has a number");
            } else if (part instanceof VarTerm variable && numbersVariables && Variables.numberOf(variable) >= 0) {
                return TermTexts.like(variable, fresh(Variables.numberOf(variable)));
            }
            if (part instanceof InternalActionLiteral action) {
                expectAction(text, action.getFunctor());
            }
            return part;
        });
    }

    /** In the order of the numbers, since Jason looks at which of two is the older one. */
    private UnnamedVar fresh(int number) {
        while (fresh.size() <= number) {
            fresh.add(new UnnamedVar());
        }
        return fresh.get(number);
    }

    private static void expectAction(String text, String name) throws RefusedException {
        try {
            Class<?> action = Class.forName(name.startsWith(".") ? STDLIB + name : name, false,
                    TermReader.class.getClassLoader());
            expect(InternalAction.class.isAssignableFrom(action), text, name + " is no internal action");
        } catch (ClassNotFoundException | LinkageError e) {
            throw new RefusedException("lacks", "this MAS lacks the internal action " + name);
        }
    }

    /** A value: nothing in it is to be computed but what plans in it compute when they run. */
    static Term datum(String text, Term term) throws RefusedException {
        if (term instanceof PlanBody || term instanceof Plan || term instanceof Rule) {
            return term;
        }
        if (term instanceof ArithFunctionTerm function) {
            boolean sign = term instanceof ArithExpr expression && expression.getOp() == ArithExpr.ArithmeticOp.minus
                    && function.getArity() == 1 && function.getTerm(0) instanceof NumberTermImpl;
            expect(sign, text, "a number was expected, not something to compute");
            return new NumberTermImpl(-((NumberTermImpl) function.getTerm(0)).solve());
        }
        if (term.isVar()) {
            return term;
        }
        if (term.isList()) {
            for (ListTerm cell = (ListTerm) term; cell != null && !cell.isVar(); cell = cell.getNext()) {
                if (cell.getTerm() != null) {
                    cell.setTerm(datum(text, cell.getTerm()));
                }
            }
        } else if (term instanceof Literal literal) {
            for (int i = 0; i < literal.getArity(); i++) {
                literal.setTerm(i, datum(text, literal.getTerm(i)));
            }
            if (literal.hasAnnot()) {
                datum(text, literal.getAnnots());
            }
        }
        return term;
    }

    static void expect(boolean met, String text, String what) throws RefusedException {
        if (!met) {
            throw refused(text, what);
        }
    }

    private static RefusedException refused(String text, String why) {
        return new RefusedException("bad_agent", TermTexts.brief(ASSyntax.createString(text)) + ": "
                + TermTexts.brief(ASSyntax.createString(why)));
    }
}
