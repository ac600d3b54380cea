package diffuser.gate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

import jason.asSyntax.ASSyntax;
import jason.asSyntax.ListTermImpl;
import jason.asSyntax.LogExpr;
import jason.asSyntax.LogicalFormula;
import jason.asSyntax.Plan;
import jason.asSyntax.PlanBody.BodyType;
import jason.asSyntax.PlanBodyImpl;
import jason.asSyntax.Pred;
import jason.asSyntax.RelExpr;
import jason.asSyntax.StringTerm;
import jason.asSyntax.Structure;
import jason.asSyntax.Term;
import jason.asSyntax.Trigger;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Terms survive their texts. */
class TermWriterTest {

    private static final int RUNS = 2_000;

    /** Random terms as agents may have them at run time, where strings hold any character that a text can carry. */
    private static final class Terms {

        private static final String[] CHARACTERS =
                {"a", "Z", " ", "\"", "\n", "\\\\", "\\t", "'", ";", "{", "}", "#", "\u00e9",
                        "\u20ac", "\ud83d\ude00", "//", "/*", "%", "X"};

        private final Random random;

        Terms(long seed) {
            random = new Random(seed);
        }

        Plan plan() {
            Pred label = new Pred(name());
            if (random.nextBoolean()) {
                label.addAnnot(term(1));
            }
            PlanBodyImpl body = step(2);
            for (int more = random.nextInt(4); more > 0; more--) {
                body.add(step(2));
            }
            Trigger trigger = new Trigger(pick(Trigger.TEOperator.add, Trigger.TEOperator.del),
                    pick(Trigger.TEType.achieve, Trigger.TEType.test, Trigger.TEType.belief),
                    ASSyntax.createLiteral(name(), terms(2)).forceFullLiteralImpl());
            Plan plan = new Plan(label, trigger, random.nextBoolean() ? context(2) : null, body);
            plan.setAsPlanTerm(true);
            return plan;
        }

        private PlanBodyImpl step(int depth) {
            BodyType type = pick(BodyType.action, BodyType.achieve, BodyType.achieveNF, BodyType.test, BodyType.addBel,
                    BodyType.delBel, BodyType.delAddBel, BodyType.internalAction, BodyType.constraint);
            return switch (type) {
                case internalAction -> new PlanBodyImpl(type, internalAction(depth));
                case constraint -> new PlanBodyImpl(type, comparison(depth));
                default -> new PlanBodyImpl(type, ASSyntax.createLiteral(name(), terms(depth)));
            };
        }

        private Term internalAction(int depth) {
            Structure call = new Structure(pick(".print", ".send", ".concat"));
            call.addTerms(terms(depth));
            call.addTerm(random.nextInt(4) == 0 ? body(depth - 1) : string());
            try {
                return new jason.asSyntax.InternalActionLiteral(call, null);
            } catch (Exception e) {
                throw new IllegalStateException(e);
            }
        }

        private Term body(int depth) {
            PlanBodyImpl body = step(Math.max(0, depth));
            body.setAsBodyTerm(true);
            return body;
        }

        private LogicalFormula context(int depth) {
            return depth == 0 ? comparison(0) : switch (random.nextInt(4)) {
                case 0 -> new LogExpr(context(depth - 1), pick(LogExpr.LogicalOp.and, LogExpr.LogicalOp.or),
                        context(depth - 1));
                case 1 -> new LogExpr(LogExpr.LogicalOp.not, context(depth - 1));
                case 2 -> ASSyntax.createLiteral(name(), terms(depth));
                default -> comparison(depth);
            };
        }

        private RelExpr comparison(int depth) {
            return new RelExpr(ASSyntax.createVar("X"), pick(RelExpr.RelationalOp.eq, RelExpr.RelationalOp.lt),
                    term(depth));
        }

        private Term[] terms(int depth) {
            List<Term> terms = new ArrayList<>();
            for (int more = random.nextInt(3); more > 0; more--) {
                terms.add(term(depth));
            }
            return terms.toArray(Term[]::new);
        }

        Term term(int depth) {
            return switch (random.nextInt(depth > 0 ? 6 : 4)) {
                case 0 -> string();
                case 1 -> ASSyntax.createNumber(random.nextBoolean() ? random.nextInt(100) : number());
                case 2 -> ASSyntax.createVar(pick("X", "Y"));
                case 3 -> ASSyntax.createAtom(name());
                case 4 -> list(depth - 1);
                default -> literal(depth - 1);
            };
        }

        /** A number of any size; none below zero, which Jason's parser takes for something to compute. */
        private double number() {
            double number = Math.abs(Double.longBitsToDouble(random.nextLong()));
            return Double.isFinite(number) ? number : 0;
        }

        private Term list(int depth) {
            ListTermImpl list = new ListTermImpl();
            list.addAll(List.of(terms(depth)));
            return list;
        }

        private Term literal(int depth) {
            Structure literal = new jason.asSyntax.LiteralImpl(random.nextInt(4) > 0, name())
                    .addTerms(terms(depth)) instanceof Structure made ? made : null;
            if (random.nextBoolean()) {
                literal.addAnnots(ASSyntax.createStructure("note", string()));
            }
            return literal;
        }

        StringTerm string() {
            StringBuilder text = new StringBuilder();
            for (int more = random.nextInt(6); more > 0; more--) {
                text.append(pick(CHARACTERS));
            }
            return ASSyntax.createString(text.toString());
        }

        private String name() {
            return pick("p", "go2", "aB_c", "q.r".substring(0, 1));
        }

        @SafeVarargs
        private <T> T pick(T... from) {
            return from[random.nextInt(from.length)];
        }
    }

    @Test
    void write_randomTerm_readsBackAsItself() throws Exception {
        Terms terms = new Terms(1);
        for (int i = 0; i < RUNS; i++) {
            Term term = terms.term(3);
            String before = term.toString();
            assertEquals(term, ASSyntax.parseTerm(TermWriter.write(term)), TermWriter.write(term));
            assertEquals(before, term.toString(), "writing changes nothing");
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void write_numberThatIsNotFinite_isRefusedAtAnyDepth(double number) {
        Term term = ASSyntax.createLiteral("p", ASSyntax.createList(ASSyntax.createNumber(number)));
        assertThrows(MalformedTextException.class, () -> TermWriter.write(term));
    }

    @Test
    void write_randomPlan_readsBackAsItself() throws Exception {
        Terms terms = new Terms(2);
        for (int i = 0; i < RUNS; i++) {
            Plan plan = terms.plan();
            String before = plan.toString();
            Plan read = (Plan) ASSyntax.parseTerm(TermWriter.write(plan));
            // Jason's own text tells two plans apart, strings and all; and its equality of plans is by their labels.
            assertEquals(before, read.toString());
            assertEquals(before, plan.toString(), "writing changes nothing");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {
            "{ @l[source(self)] +!go(X) : (near(X) & not (stop)) <- !run; .print(\"\u00fc\",X); ?speed(V); +done }",
            "{ +!go <- .fork(and,{ !a },{ !b; !c }) }",
            "{ @p[atomic] -light(L) <- -+dark(L) }",
            "{ +!go }",
            "[a,[b,\"c d\"],~e(f)[g]]",
    })
    void write_text_isTheSame(String text) throws Exception {
        assertEquals(text, TermWriter.write(ASSyntax.parseTerm(text)));
    }

    @ParameterizedTest
    @CsvSource({"ROMA,'''ROMA'''", "bus1,bus1", "SU//,'''SU//'''", "9abc,'''9abc'''", ".print,.print"})
    void write_atomOfAnyName_readsBackAsAnAtom(String name, String expected) throws Exception {
        assertEquals(expected, TermWriter.write(ASSyntax.createAtom(name)));
        assertEquals("saw(" + expected + ")",
                TermWriter.write(ASSyntax.createLiteral("saw", ASSyntax.createAtom(name))));
    }

    @Test
    void write_planFromAFile_leavesOutWhichOne() throws Exception {
        assertEquals("{ @l[a] +!go }", TermWriter.write(ASSyntax.parseTerm("{ @l[a,url(\"/home/me/my.asl\")] +!go }")));
    }

    @Test
    void write_planWithoutBraces_getsThem() throws Exception {
        Plan plan = ASSyntax.parsePlan("+!go <- .print(\"a\\nb\").");
        assertEquals("{ +!go <- .print(\"a\\nb\") }", TermWriter.write(plan));
    }

    @ParameterizedTest
    @ValueSource(strings = {"\\", "a\\d", "\\n", "\\\"", "\r", "a\\", "\ud800"})
    void write_stringThatCannotReadBack_throws(String value) {
        assertThrows(MalformedTextException.class,
                () -> TermWriter.write(ASSyntax.createLiteral("p", ASSyntax.createString(value))));
    }

    @ParameterizedTest
    @ValueSource(strings = {"+!a <- .if_then_else(b,{ c },{ !d; e }).", "+!a <- .loop(b,{ +c }).",
            "+!a <- f([1,2|T]); +{ p(\"x\\ny\") :- q('ROMA') }."})
    void plan_withBracesTailsAndRules_readsBack(String text) throws Exception {
        assertEquals("{ " + text.substring(0, text.length() - 1) + " }", TermWriter.write(ASSyntax.parsePlan(text)));
    }
}
