package diffuser.gate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.util.Optional;
import java.util.Random;

import jason.JasonException;
import jason.asSyntax.ASSyntax;

import javino.protocol.Content;
import javino.protocol.Conversation;
import javino.protocol.Performative;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

@Tag("newerJava")
class TextsTest {

    @ParameterizedTest
    @ValueSource(
            strings = {"p", "p(1)", "~p(a,\"b c\")", "proximity(17.5)", "p([1,2],q(r))", "p(-3)", "p[source(self)]"})
    void readPercept_belief_readsBackAsItself(String text) throws Exception {
        assertEquals(text, Texts.readPercept(text).toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", " ", "p(", "p)", "p(1) q(2)", "p,q", "p.", "p;q", "X", "p(X)", "_", "3", "\"p\"", "[p]",
            "1+2", "p & q", "not p", "p :- q", ".print(p)", "{ +!p <- q }", "{ !p; !q }", "+!p", "!p", "\u0000",
            "p(\u0001)",
            "\"", "/*", "p\n)", "java.lang.System.exit(0)",
            "true", "ns::X"})
    void readPercept_anythingElse_isMalformed(String text) {
        assertThrows(MalformedTextException.class, () -> Texts.readPercept(text));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\0', value = {"tell#AbC | 3", "tell#AbC | \"p\"",
            "tell#AbC | [p,[1,\"x\"],q(-2)]", "tell | [p,q(X)]", "askOne#AbC | p(X)", "untellHow | [a,b]",
            "sorry#AbC | \"no\""})
    void readContent_whatGoesWithThePerformative_readsBackAsItself(String head, String text) throws Exception {
        assertEquals(text, Texts.readContent(Content.parse(head + ";" + text)).toString());
    }

    @Test
    void content_term_isWrittenOrRefused() throws Exception {
        assertEquals(Content.parse("tell;p(1)"),
                Texts.content(Performative.TELL, Optional.empty(), ASSyntax.parseTerm("p(1)")));
        assertRefused("bad_content", () -> Texts.content(Performative.TELL, Optional.empty(), ASSyntax.parseTerm("3")));
        assertRefused("bad_content",
                () -> Texts.content(Performative.TELL, Optional.empty(), ASSyntax.parseTerm("p(\"\u001b[2J\")")));
        assertRefused("too_long",
                () -> Texts.content(Performative.TELL, Optional.empty(), ASSyntax.parseTerm("p".repeat(490))));
        assertRefused("bad_content", () -> Texts.said("p("));
    }

    @Test
    void performative_sorryOrNone_isRefused() throws Exception {
        assertEquals(Performative.ASK_ONE, Texts.performative("askOne"));
        assertRefused("wrong_arguments", () -> Texts.performative("sorry"));
        assertRefused("wrong_arguments", () -> Texts.performative("shout"));
    }

    @Test
    void action_literal_losesItsAnnotationsAndHasNoVariable() throws Exception {
        assertEquals("turn(3)", Texts.action(ASSyntax.parseLiteral("turn(3)[slow]")));
        assertRefused("wrong_arguments", () -> Texts.action(ASSyntax.parseLiteral("turn(X)")));
    }

    private static void assertRefused(String error, Executable saying) {
        assertEquals("error(" + error + ")",
                assertThrows(JasonException.class, saying).getErrorTerms().get(0).toString());
    }

    @Test
    @Tag("verify")
    void readContent_randomText_isReadOrMalformedAndNothingElse() {
        Random random = new Random(7);
        String alphabet = "pqX_(),.[]~\"' 19+-*/&|{}<>!?;:@#\\\u0000ü\n";
        for (int i = 0; i < 5_000; i++) {
            StringBuilder text = new StringBuilder();
            for (int length = random.nextInt(12); length > 0; length--) {
                text.append(alphabet.charAt(random.nextInt(alphabet.length())));
            }
            for (Performative performative : Performative.values()) {
                readOrMalformed(performative, "p" + text);
            }
        }
    }

    private static void readOrMalformed(Performative performative, String text) {
        Optional<Conversation> conversation = performative.isQuestion() || performative == Performative.SORRY
                ? Optional.of(new Conversation(1)) : Optional.empty();
        try {
            Texts.readContent(new Content(performative, conversation, text));
        } catch (MalformedTextException e) {
            assertTrue(e.getMessage().startsWith("\"" + text + "\": "), e.getMessage());
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\0', value = {
            "tell        | 3",
            "tell        | \"p\"",
            "tell        | { +!p <- q }",
            "tell#AbC    | { +!p <- q }",
            "tell#AbC    | X",
            "tell#AbC    | .stopMAS",
            "tell#AbC    | [p,[.stopMAS]]",
            "untell#AbC  | X",
            "signal      | 3",
            "achieve     | .stopMAS",
            "askOne#AbC  | 3",
            "askOne#AbC  | [p]",
            "askOne#AbC  | X",
            "askOne#AbC  | .stopMAS",
            "askAll#AbC  | { +!p }",
            "askHow#AbC  | p",
            "askHow#AbC  | { @l +!p <- q }",
            "askHow#AbC  | X",
            "tellHow     | p",
            "tellHow     | { +!p }",
            "tellHow     | { !p; !q }",
            "tellHow     | .stopMAS",
            "tellHow     | X",
            "tellHow     | [{ +!p <- q },p]",
            "tellHow     | [{ +!p <- q }|X]",
            "tellHow     | { +!p <- q",
            "untellHow   | 3",
            "untellHow   | X",
            "untellHow   | { @l +!p <- q }",
            "sorry#AbC   | p",
    })
    void readContent_notWhatGoesWithThePerformative_isMalformed(String head, String text) {
        Content content = Content.parse(head + ";" + text);
        assertThrows(MalformedTextException.class, () -> Texts.readContent(content));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"p(\"\u001b[2J\")", "p(\"\r\")", "p(\"\n\")", "p(\"\u009b\")", "p(\"\u2028\")", "p(\"\u202e\")",
                    "p(\"\u2066\")", "p(1)\n"})
    void readContent_characterThatCommandsATerminal_isMalformed(String text) {
        assertThrows(MalformedTextException.class, () -> Texts.readContent(new Content(Performative.TELL, text)));
    }

    /** By Unicode's properties: none that turns the direction of writing, and none that is not seen. */
    @Test
    void readContent_characterThatIsNotSeen_isMalformed() throws Exception {
        for (int character : new int[] {0x061C, 0x200B, 0x200D, 0x200E, 0x200F, 0x2060, 0x2069, 0xAD, 0x34F, 0x115F,
                0x180E, 0x3164, 0xFE0F, 0xFEFF, 0xFFA0, 0xFFF0, 0xE0001, 0xE0020, 0xE0100}) {
            String text = "p(\"a" + Character.toString(character) + "b\")";
            assertThrows(MalformedTextException.class, () -> Texts.readContent(new Content(Performative.TELL, text)),
                    Integer.toHexString(character));
            assertEquals("a b", Texts.withoutCommands("a" + Character.toString(character) + "b"));
        }
        Texts.readContent(new Content(Performative.TELL, "p(\"\u00e9\u4e2d\u0627\ud83d\ude00\")"));
    }

    /** The output of Jason's parser when it stumbles is nobody's to see; that it has stumbled is known. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\0', value = {"tell | { +!a <- { +!a <- { a } } }",
            "tell | p({ +!a <- { +!a <- { a } } })", "tellHow | { +!a <- { +!b <- c } }",
            "tellHow | { +!a <- !{ +!b } }",
            "tellHow | \"+!a. { @l +!b. @l +!c. }\"", "achieve | p({ +!a <- { +!b } ||| c })",
            "tellHow | { +!a <- b |&| { +!b <- c } }"})
    void readContent_whereTheParserStumbles_isMalformedInSilence(String performative, String text) {
        PrintStream before = System.err;
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        System.setErr(new PrintStream(printed, true));
        try {
            assertMalformed(Performative.of(performative).orElseThrow(), text);
        } finally {
            System.setErr(before);
        }
        assertEquals("", printed.toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"p({ +!a[source(self)] : b[cast(unicast,x)] <- c[peer(certified,x)] })",
            "p({ q[source(self)] :- r[source(percept)] & not s[cast(x,y)] })", "p(a[[source(self)],x([b[home(c)]])])",
            "p(X[source(self)])", "p([a[source(self)]|T])", "p[x(a[demanded(b),reason(b)])]",
            "p({ !a[source(self)]; ?b[X] })"})
    void clean_marksAtAnyDepth_areGone(String text) throws Exception {
        String clean = Gate.clean(ASSyntax.parseTerm(text)).toString();
        assertTrue(!clean.matches(".*(source|cast|peer|home|demanded|reason).*|.*\\[X.*"), clean);
    }

    @ParameterizedTest
    @ValueSource(strings = {"p(1+2)", "p(math.sqrt(4))", "p(-(-3))", "[p(1),p(2*3)]", "p(q[r(1+1)])", "p(.date(1,2,3))",
            "p(X[math.sqrt(4)])", "p({ q :- X > math.sqrt(4) })", "p({ !q(math.sqrt(4)) })", "p({ +!q <- r(1+1) })",
            "p({ +q(1+1) })"})
    void readContent_somethingToCompute_isMalformed(String text) {
        assertThrows(MalformedTextException.class, () -> Texts.readContent(new Content(Performative.TELL, text)));
    }

    @Test
    void readContent_deeplyNested_isRead() throws Exception {
        Texts.readContent(new Content(Performative.TELL, "p(".repeat(160) + "1" + ")".repeat(160)));
    }

    /** As deep as a content can be: the parser comes back, with a plan or without. */
    @ParameterizedTest
    @CsvSource({"(,x,),230", "'[','x',']',230", "{,x,},230", "'{ ',x,' }',115", "'p(',x,')',155", "'not ',x,,115",
            "-,1,,450",
            "'!x;',!y,,150", "'if(x){',x,'}',65", "'.a({ ',x,' })',55", "'x[',x,']',155",
            "'(x & ',x,')',75"})
    void readContent_deepPlan_isReadOrMalformed(String opening, String inside, String closing, int depth) {
        String text =
                "{ +!g <- " + opening.repeat(depth) + inside + (closing == null ? "" : closing).repeat(depth) + " }";
        readOrMalformed(Performative.TELL_HOW, text);
    }

    /** Jason's parser would take twice as long with each level. */
    @ParameterizedTest
    @CsvSource({"A[,],150", "_[,],150", "_1[,],110", "p(-A[,]),65", "({,};b),70", "({+a(A[x]),};b),30"})
    @Timeout(60)
    void readContent_nestedInAWayThatTakesForEver_isMalformedAtOnce(String opening, String closing, int depth) {
        String text = opening.repeat(depth) + "x" + closing.repeat(depth);
        assertMalformed(Performative.TELL, "p({" + text + "})");
        assertMalformed(Performative.TELL_HOW, "{ +!g <- " + text + " }");
        assertMalformed(Performative.TELL_HOW, "\"+!g <- " + text + ".\"");
        assertMalformed(Performative.ASK_HOW, "\"+!g(" + text + ")\"");
    }

    private static void assertMalformed(Performative performative, String text) {
        Optional<Conversation> conversation = Optional.of(new Conversation(1)).filter(c -> performative.isQuestion());
        assertThrows(MalformedTextException.class,
                () -> Texts.readContent(new Content(performative, conversation, text)), text);
    }
}
