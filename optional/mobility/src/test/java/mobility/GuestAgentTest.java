package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.locks.LockSupport;
import java.util.regex.Pattern;

import jason.JasonException;
import jason.asSemantics.Agent;
import jason.asSemantics.Message;
import jason.asSemantics.Unifier;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.InternalActionLiteral;
import jason.asSyntax.Literal;
import jason.asSyntax.Term;

import diffuser.gate.Terms;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Rights of an agent that has come under inquilinism. */
class GuestAgentTest {

    private static final String PROGRAM = """
            +!try <- !it; +was(done).
            +!it <- %s.
            -!try[error(E)] <- +was(E).
            """;

    /** No test waits for so many cycles unless it fails. */
    private static final int PATIENCE = 100_000;

    private static String outcome(String step) throws Exception {
        Image image = new Image(PROGRAM.formatted(step).trim(), "I+!try");
        Stage stage = Stage.of(AgentStateReader.read(image), new GuestAgent());
        stage.front(new Mobile());
        Literal was = null;
        for (int i = 0; i < PATIENCE && was == null; i++) {
            stage.run(1);
            LockSupport.parkNanos(100_000);
            was = stage.ts.getAg().findBel(ASSyntax.parseLiteral("was(E)"), new Unifier());
        }
        return was.getTerm(0).toString() + stage.done;
    }

    @ParameterizedTest
    @ValueSource(strings = {".print(a)", "X = math.max(1,2); X = 2; +b(X); ?b(2)", ".findall(X,p(X),L); .length(L,0)",
            ".send(bob,tell,hello)", ".send(bob,untell,hello)", ".send(bob,askOne,p(_))", ".send(bob,askAll,p(_))",
            ".send(bob,signal,p)", ".broadcast(tell,x)", ".wait(1)", ".my_name(M)", "if (true) { +c } else { a }",
            "for (.member(X,[1,2])) { +d(X) }", ".map.create(M); .map.put(M,a,1)", ".add_plan({ +!n <- +n }); !n"})
    void step_allowed_isDone(String step) throws Exception {
        assertEquals("done[]", outcome(step));
    }

    @ParameterizedTest
    @ValueSource(strings = {".stopMAS", ".create_agent(x,\"y.asl\")", ".kill_agent(bob)", ".clone(x)",
            ".save_agent(\"/tmp/x\")", ".include(\"x.asl\")", ".list_files(\"/\",F)", ".act(light(on))",
            ".port(\"/dev/ttyUSB0\")", ".percepts(open)", ".diffuse(\"////\",tell,x)", ".deliver(\"ROMA\",tell,x)",
            "jason.stdlib.stopMAS", "mobility.bomb(1)", "mobility.leave", ".send(bob,achieve,x)",
            ".send(bob,tellHow,\"+!a <- b.\")", ".send(bob,untellHow,\"l\")", ".send(bob,askHow,\"+!a\")",
            ".send(bob,unachieve,x)", ".broadcast(achieve,x)", ".df_register(x)", ".set_random_seed(1)",
            ".send(bob,askOne,mobility.bomb(1))", ".send(bob,askOne,.stopMAS)", ".send(bob,askOne,(p(X) & .stopMAS))",
            ".send(bob,askAll,not .stopMAS)", ".send(bob,tell,{ p :- .stopMAS })", ".send(bob,tell,[{ p :- a }])",
            ".term2string(T,\"jag_shutting_down(1)\"); .send(bob,signal,T)", ".send(bob,askOne,X)",
            ".send(bob,tell,\"p(1)\")", "X = { .stopMAS }; X", ".eval(X,.stopMAS); X = true",
            ".term2string(X,\".stopMAS\"); X"})
    void step_notAllowed_fails(String step) throws Exception {
        String outcome = outcome(step);
        // A test that fails in a context has no error of its own.
        assertEquals(step.startsWith(".eval") ? "constraint_failed[]" : "guest[]", outcome);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '#', value = {"tell # p(1)[cast(unicast,'SUPP'),source(bob),a(2)] # p(1)[a(2)]",
            "tell # [p(1)[cast(unicast,'SUPP')],q(-2)] # [p(1),q(-2)]", "askOne # p(X)[Y] # p(X)",
            "signal # go[error(x)] # go"})
    void message_leavesWhatAnotherDeviceCouldSay(String performative, String said, String left) throws Exception {
        Message message = new Message(performative, "guest", "bob", ASSyntax.parseTerm(said));
        new GuestAgent().check(message);
        assertEquals(left, message.getPropCont().toString());
    }

    private static GuestAgent asked(String performative, String id) {
        GuestAgent guest = new GuestAgent();
        guest.selectMessage(
                new ArrayDeque<>(List.of(new Message(performative, "bob", "guest", ASSyntax.createAtom("p"), id))));
        return guest;
    }

    private static Message answer(String performative, String to, String said, String id) throws Exception {
        Message message = new Message(performative, "guest", to, ASSyntax.parseTerm(said));
        message.setInReplyTo(id);
        return message;
    }

    @ParameterizedTest
    @ValueSource(strings = {"[1,\"a\",[p(2)]]", "3", "p(4)"})
    void answer_mayBeAnyDatum(String said) throws Exception {
        Message message = answer("tell", "bob", said, "samid1");
        asked("askOne", "samid1").check(message);
        assertEquals(said, message.getPropCont().toString());
    }

    /** A value without a mark would be taken for that of whoever was asked. */
    @ParameterizedTest
    @CsvSource({"askOne,tell,bob,samid2", "askOne,tell,eve,samid1", "askOne,tell,bob,rf1", "askOne,tell,bob,asleep",
            "askOne,tell,bob,moveOut/javino/1", "askOne,signal,bob,samid1", "askHow,tell,bob,samid1",
            "askHow,tellHow,bob,samid1", "tell,tell,bob,samid1"})
    void answer_toNoQuestionThatItWasAsked_isRefused(String question, String performative, String to, String id)
            throws Exception {
        for (String said : List.of("3", "\"a\"", "[1,2]", "p(4)", "[]")) {
            Message message = answer(performative, to, said, id);
            assertThrows(JasonException.class, () -> asked(question, "samid1").check(message));
        }
    }

    @Test
    void answer_twice_isRefused() throws Exception {
        GuestAgent guest = asked("askOne", "samid1");
        guest.check(answer("tell", "bob", "1", "samid1"));
        Message again = answer("tell", "bob", "2", "samid1");
        assertThrows(JasonException.class, () -> guest.check(again));
    }

    @ParameterizedTest
    @ValueSource(strings = {"p({ .stopMAS })", "{ +!q <- .stopMAS }", "[p(.stopMAS)]"})
    void whatAnotherHasLookedUp_isLookedUpAnew(String said) throws Exception {
        Stage host = Stage.of("b(" + said + ").");
        Term known = host.ts.getAg().findBel(ASSyntax.parseLiteral("b(_)"), new Unifier()).getTerm(0);
        Queue<Message> messages = new ArrayDeque<>(List.of(new Message("tell", "bob", "guest", known)));
        Message message = new GuestAgent().selectMessage(messages);
        List<InternalActionLiteral> found = new ArrayList<>();
        Terms.visit((Term) message.getPropCont(), part -> {
            if (part instanceof InternalActionLiteral action) {
                found.add(action);
            }
        });
        assertEquals(1, found.size());
        assertNull(found.get(0).getIA(null));
    }

    @Test
    void externalAction_fails() throws Exception {
        assertEquals("action_failed[]", outcome("light(on)"));
    }

    @Test
    void jasonsOwnPlans_haveWhatTheyNeed() throws Exception {
        try (InputStream plans = Agent.class.getResourceAsStream("/asl/kqmlPlans.asl")) {
            List<String> refused = Pattern.compile("(?<![\\w)\\]])\\.[a-z_]+(?=\\()")
                    .matcher(new String(plans.readAllBytes(), StandardCharsets.UTF_8)).results()
                    .map(found -> found.group()).distinct().filter(name -> !GuestAgent.allows(name)).toList();
            assertEquals(List.of(), refused);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
