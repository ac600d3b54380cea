package diffuser.gate;

import java.io.StringReader;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

import jason.JasonException;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.ArithExpr;
import jason.asSyntax.ArithFunctionTerm;
import jason.asSyntax.Atom;
import jason.asSyntax.InternalActionLiteral;
import jason.asSyntax.ListTerm;
import jason.asSyntax.ListTermImpl;
import jason.asSyntax.Literal;
import jason.asSyntax.LiteralImpl;
import jason.asSyntax.NumberTermImpl;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody;
import jason.asSyntax.Pred;
import jason.asSyntax.Rule;
import jason.asSyntax.StringTerm;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;
import jason.asSyntax.parser.ParseException;
import jason.asSyntax.parser.SimpleCharStream;
import jason.asSyntax.parser.TokenMgrError;
import jason.asSyntax.parser.as2jTokenManager;

import diffuser.report.Failure;

import javino.Printable;
import javino.protocol.Content;
import javino.protocol.Conversation;
import javino.protocol.Performative;

/** Turns terms into the texts that travel, and texts into terms (SPEC 3). */
public final class Texts {

    private static final Set<Class<?>> LITERALS =
            Set.of(Atom.class, Structure.class, Pred.class, LiteralImpl.class);

    private static final String FORCES = Arrays.stream(Performative.values()).filter(Performative::isSaid)
            .map(Performative::toString).collect(Collectors.joining(", "));

    /** Jason's parser takes twice as long with each level of braces, or of annotations of variables. */
    private static final int DEEPEST = 10;
    private static final Set<String> OPENING = Set.of("{", "[");
    private static final Set<String> CLOSING = Set.of("}", "]");

    private Texts() {
    }

    /**
     * The performative of that name, as a program gives it.
     *
     * @throws JasonException wrong_arguments if it is none that can travel.
     */
    public static Performative performative(String name) throws JasonException {
        return Performative.of(name).filter(Performative::isSaid).orElseThrow(() -> new JasonException(
                "the radio takes only " + FORCES + ", not " + name, JasonException.WRONG_ARGS));
    }

    /**
     * The content of a message from one agent to another.
     *
     * @throws JasonException bad_content if the term is not what goes with the performative, its text does not read
     * back, or every gate refuses it; too_long if it is longer than any message.
     */
    public static Content content(Performative performative, Optional<Conversation> conversation, Term term)
            throws JasonException {
        try {
            String text = TermWriter.write(each(Gate.admit(term), Plans::withoutGeneratedLabel));
            checked(performative, conversation.isPresent(), text);
            return new Content(performative, conversation, text);
        } catch (MalformedTextException | Gate.RefusedException e) {
            throw unsayable(e);
        } catch (IllegalArgumentException e) {
            throw new Failure("too_long", e.getMessage()).toException();
        }
    }

    /**
     * A term that an agent is about to send and gives as a text.
     *
     * @throws JasonException bad_content if it is no term.
     */
    public static Term said(String text) throws JasonException {
        try {
            return read(text);
        } catch (MalformedTextException e) {
            throw unsayable(e);
        }
    }

    /**
     * A term from an agent of this MAS that is trusted no more than another device: as it would come from there.
     *
     * @param answer whether it answers a question.
     * @param said   admitted by the gate.
     * @throws MalformedTextException if it is not what goes with the performative, or its text does not read back.
     */
    public static Term asFromTheAir(Performative performative, boolean answer, Term said)
            throws MalformedTextException {
        return checked(performative, answer, TermWriter.write(said));
    }

    private static Term checked(Performative performative, boolean conversing, String text)
            throws MalformedTextException {
        expectNoCommand(text);
        Term term = read(text, performative);
        check(text, term, performative, conversing);
        return term;
    }

    private static JasonException unsayable(Exception e) {
        return new Failure("bad_content", "this cannot be sent: " + e.getMessage()).toException();
    }

    /**
     * An action as the board reads it, {@code name} or {@code name(arguments)}, without annotations.
     *
     * @throws JasonException wrong_arguments if a variable in it has no value.
     */
    public static String action(Literal action) throws JasonException {
        if (!action.isGround()) {
            throw new JasonException("the action " + action + " has a variable without a value",
                    JasonException.WRONG_ARGS);
        }
        Literal plain = action.copy();
        plain.clearAnnots();
        return plain.toString();
    }

    /** Reads a percept: a literal without variables. */
    public static Literal readPercept(String text) throws MalformedTextException {
        Term term = read(text);
        if (!isBelief(term)) {
            throw new MalformedTextException(text, "a belief was expected");
        }
        if (!term.isGround()) {
            throw new MalformedTextException(text, "it has a variable");
        }
        return (Literal) term;
    }

    /**
     * What a sketch has printed as its reason for refusing an action: the term that it is, if a percept might have it,
     * else a string.
     */
    public static Term reason(String text) {
        try {
            expectNoCommand(text);
            Term term = Gate.admit(read(text));
            expect(isDatum(term) && term.isGround(), text, "a term without variables was expected");
            return term;
        } catch (MalformedTextException | Gate.RefusedException e) {
            return ASSyntax.createString(withoutCommands(text));
        }
    }

    /** Reads what a message says: what goes with its performative. */
    public static Term readContent(Content content) throws MalformedTextException {
        return checked(content.performative(), content.conversation().isPresent(), content.term());
    }

    /**
     * Plans are not evaluated: what they compute, they compute when they run. Those that come as strings are read here,
     * so that what was looked at is what Jason takes.
     */
    private static Term read(String text, Performative performative) throws MalformedTextException {
        return switch (performative) {
            case TELL_HOW -> each(parsed(text), term -> term.isString() ? plan(((StringTerm) term).getString()) : term);
            case UNTELL_HOW ->
                each(read(text), term -> term.isString() ? label(((StringTerm) term).getString()) : term);
            case ASK_HOW -> each(read(text), term -> term.isString() ? trigger(((StringTerm) term).getString()) : term);
            case TELL, UNTELL, ACHIEVE, UNACHIEVE, SIGNAL, ASK_ONE, ASK_ALL, SORRY -> read(text);
        };
    }

    /** Changes a term, or each in a list. A variable is an instance of ListTerm, too. */
    static <E extends Exception> Term each(Term term, Terms.Change<E> change) throws E {
        if (!term.isList() || term.isVar()) {
            return change.of(term);
        }
        ListTerm all = new ListTermImpl();
        for (Term single : (ListTerm) term) {
            all.add(change.of(single));
        }
        return all;
    }

    private static Term plan(String text) throws MalformedTextException {
        Plan plan = parsed(text, ASSyntax::parsePlan);
        plan.setAsPlanTerm(true);
        return plan;
    }

    /** With the sign before it or without. */
    private static Term label(String text) throws MalformedTextException {
        return parsed(text.startsWith("@") ? text.substring(1) : text);
    }

    private static Term trigger(String text) throws MalformedTextException {
        return parsed(text, ASSyntax::parseTrigger);
    }

    private static void check(String text, Term term, Performative performative, boolean conversing)
            throws MalformedTextException {
        boolean fits = switch (performative) {
            case TELL, UNTELL -> conversing ? isDatum(term) : all(term, Texts::isBelief);
            case ACHIEVE, UNACHIEVE, SIGNAL, UNTELL_HOW -> all(term, Texts::isBelief);
            case ASK_ONE, ASK_ALL -> isBelief(term);
            case ASK_HOW -> term instanceof Trigger || term.isPlanBody() || term.isString();
            // Nobody looks into plans within a plan.
            case TELL_HOW -> all(term, each -> each.isString() || each instanceof Plan plan && !plan.hasSubPlans()
                    && plan.getGoalCondition() == null);
            case SORRY -> term.isString();
        };
        expect(fits, text, expected(performative, conversing));
    }

    private static String expected(Performative performative, boolean conversing) {
        return switch (performative) {
            case TELL, UNTELL, ACHIEVE, UNACHIEVE, SIGNAL -> conversing
                    ? "beliefs, numbers, strings or a list of such were expected"
                    : "a belief, a goal or a list of such was expected";
            case ASK_ONE, ASK_ALL -> "a belief was expected";
            case ASK_HOW -> "a triggering event such as { +!go(_) } was expected";
            case TELL_HOW -> "a plan such as { +!go <- run }, or a list of such, was expected";
            case UNTELL_HOW -> "a plan's label or a list of such was expected";
            case SORRY -> "a string was expected";
        };
    }

    /**
     * Refuses what commands a terminal, or hides.
     *
     * @throws MalformedTextException if such a character is in it.
     */
    public static void expectNoCommand(String text) throws MalformedTextException {
        expect(text.codePoints().noneMatch(Printable::isCommand), text,
                "it has a character that commands a terminal, or"
                        + " is not seen; of these only line feeds may be sent");
    }

    /** The same, with blanks in the place of what commands a terminal. */
    public static String withoutCommands(String text) {
        return text.codePoints().mapToObj(each -> Printable.isCommand(each) ? " " : Character.toString(each))
                .collect(Collectors.joining());
    }

    private static void expect(boolean met, String text, String what) throws MalformedTextException {
        if (!met) {
            throw new MalformedTextException(text, what);
        }
    }

    /** Whether a condition holds of a term, or of all in a list. A variable is an instance of ListTerm, too. */
    private static boolean all(Term term, Predicate<Term> condition) {
        return term.isList() ? ((ListTerm) term).stream().allMatch(condition) : condition.test(term);
    }

    /** Whether a question may be answered with it: Jason's askOne binds anything to the variable that waits. */
    private static boolean isDatum(Term term) {
        return all(term, single -> isBelief(single) || single instanceof NumberTermImpl || single.isString()
                || single.isList() && isDatum(single));
    }

    /** Plain literals only: Jason's classes for variables, formulas, plans and internal actions extend these. */
    public static boolean isBelief(Term term) {
        return LITERALS.contains(term.getClass());
    }

    private static Term read(String text) throws MalformedTextException {
        try {
            Term term = parsed(text);
            expectNoFunction(term, text);
            // Evaluated, since Jason parses -3 as an expression and not as a number.
            return term.capply(new Unifier());
        } catch (RuntimeException e) {
            throw new MalformedTextException(text, firstLine(e));
        }
    }

    /**
     * Nobody else's text is computed, except for the sign of a number: a function may do anything, and logs its faults.
     */
    private static void expectNoFunction(Term term, String text) throws MalformedTextException {
        if (term instanceof ArithFunctionTerm function) {
            boolean sign = term instanceof ArithExpr expression && expression.getOp() == ArithExpr.ArithmeticOp.minus
                    && function.getArity() == 1 && function.getTerm(0) instanceof NumberTermImpl;
            expect(sign, text, "a number was expected, not something to compute");
        } else {
            expect(!(term instanceof InternalActionLiteral), text, "an internal action cannot be sent");
            for (Term part : parts(term)) {
                // An internal action in a plan is called only when the plan runs.
                boolean call = term instanceof PlanBody && part instanceof InternalActionLiteral;
                for (Term read : call ? parts(part) : List.of(part)) {
                    expectNoFunction(read, text);
                }
            }
        }
    }

    /** The parts of a term. */
    public static List<Term> parts(Term term) {
        Stream<Term> parts = Stream.of();
        if (term instanceof Plan plan) {
            parts = Stream.of(plan.getLabel(), plan.getTrigger(), plan.getContext(), plan.getBody());
        } else if (term instanceof PlanBody body) {
            parts = Stream.of(body.getBodyTerm(), body.getBodyNext());
        } else if (term instanceof Trigger trigger) {
            parts = Stream.of(trigger.getLiteral());
        } else if (term instanceof ListTerm list && !term.isVar()) {
            parts = list.stream();
        } else if (term instanceof Literal literal) {
            parts = Stream.concat(IntStream.range(0, literal.getArity()).mapToObj(literal::getTerm),
                    Stream.of(literal.hasAnnot() ? literal.getAnnots() : null,
                            literal instanceof Rule rule ? rule.getBody() : null));
        }
        return parts.filter(Objects::nonNull).toList();
    }

    private static Term parsed(String text) throws MalformedTextException {
        return parsed(text, ASSyntax::parseTerm);
    }

    /**
     * One of Jason's parsers.
     *
     * @param <T> the result for a text.
     */
    public interface Parser<T> {
        /** @throws ParseException if it is no such text. */
        T parse(String text) throws ParseException;
    }

    /**
     * Reads a text without computing anything in it.
     *
     * @throws MalformedTextException if the parser does not take it.
     */
    public static <T extends Term> T parsed(String text, Parser<T> parser) throws MalformedTextException {
        try (ParserOutput output = new ParserOutput()) {
            expect(depth(text) <= DEEPEST, text, "it nests too many braces, lists and annotations");
            T term = parser.parse(text);
            expect(output.isEmpty(), text, "Jason's parser stumbles over it");
            return term;
        } catch (ParseException | TokenMgrError | RuntimeException e) {
            throw new MalformedTextException(text, firstLine(e));
        }
    }

    /** How deep braces, lists and annotations are nested. */
    private static int depth(String text) {
        as2jTokenManager tokens = new as2jTokenManager(new SimpleCharStream(new StringReader(text)));
        int depth = 0;
        int most = 0;
        for (String token = tokens.getNextToken().image; !token.isEmpty(); token = tokens.getNextToken().image) {
            depth += OPENING.contains(token) ? 1 : CLOSING.contains(token) ? -1 : 0;
            most = Math.max(most, depth);
        }
        return most;
    }

    private static String firstLine(Throwable thrown) {
        return String.valueOf(thrown.getMessage()).lines().findFirst().orElse("");
    }
}
