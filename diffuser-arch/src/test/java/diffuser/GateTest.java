package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.logging.StreamHandler;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import jason.asSemantics.Agent;
import jason.asSemantics.Message;
import jason.asSemantics.Unifier;
import jason.asSyntax.Literal;

import diffuser.gate.TrustLevel;
import diffuser.mind.Inbox;

import javino.board.ReceivedMessage;
import javino.fake.FakeBoard;
import javino.protocol.Address;
import javino.protocol.Bytes;
import javino.protocol.Content;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Messages from the air against a running agent: the rows of SECURITY.md's table, and attempts to get past it. */
class GateTest {

    private static final String ALL = "////";
    private static final String GROUP = "//SU";
    private static final String ME = "CAFE";

    /** Finds out about a door for partners only. */
    private static final String DOOR = """
            +?door(X)[peer(certified,S)] <- diffuser.note(certified,S); .fail.
            +?door(X) <- diffuser.note(partner); X = 1.
            """;

    /** Notes whatever it does; asks for goals of broadcasts by the plans named opened. */
    private static final String PROGRAM = """
            festival(never).
            own(1).
            trusted("SUPO").
            !start.
            +!start <- .port(radio); .getRFMessages(open); diffuser.note(ready).
            +!probe <- diffuser.note(probed).
            +!go(X) <- diffuser.note(went,X).
            +!open(G)[cast(unicast,S)] : trusted(T)[source(self)] & .term2string(S,T) <- diffuser.note(guarded,G,S).
            +!opened(X)[cast(broadcast,S)] <- diffuser.note(opened,X,S).
            +!opened(X) <- diffuser.note(shut,X).
            +!maybe(X) : festival(X) <- diffuser.note(shut,X).
            +!maybe(X)[cast(broadcast,S)] : festival(X)[source(self)] <- diffuser.note(maybe,X,S).
            +!maybe(X) <- diffuser.note(shut,X).
            +!any(X)[cast(K,S)] <- diffuser.note(any,X,K).
            +!keep(X)[cast(K,S)] <- diffuser.note(keeping,X,K); .suspend.
            +!keep(X)[cast(broadcast,S)] <- diffuser.note(keeping,X,broadcast); .suspend.
            ^!keep(X)[state(dropped)] <- diffuser.note(dropped,X).
            +delivered(_,_,_)[source(percept)] <- diffuser.note(forged).
            +p(X)[source(percept)] <- diffuser.note(forged).
            +p(X)[source(self)] <- diffuser.note(forged).
            +p(X)[source(tester)] <- diffuser.note(forged).
            +p(X)[cast(unicast,S)] <- diffuser.note(sealed,X,S).
            +jag_shutting_down(_) <- diffuser.note(forged).
            """;

    private final FakeBoard board = new FakeBoard("radio");

    /** Listens to nobody. */
    public static final class Deaf extends Agent {

        private static final long serialVersionUID = 1L;

        @Override
        public boolean socAcc(Message message) {
            return message.getSender().equals("test");
        }
    }

    private RunningAgent ready() {
        return RunningAgent.listening(PROGRAM, board);
    }

    /** After what was received before: what is told now is noted next. */
    private void nothingSoFar(RunningAgent agent) {
        board.receive(ME, "LAST", "achieve;go(last)");
        agent.notes("went last");
    }

    private static long refused(RunningAgent agent) throws Exception {
        return agent.diffuser().inbox().refused();
    }

    @ParameterizedTest
    @ValueSource(strings = {"tell;p(1)", "achieve;go(1)", "askOne#AAA;own(X)"})
    void socAcc_thatRefuses_isCountedAndLogged(String message) throws Exception {
        RunningAgent agent = RunningAgent.run(Deaf.class, PROGRAM, board);
        agent.notes("ready");
        board.receive(ME, "SUPO", message);
        agent.warns("the agent's socAcc does not accept it");
        assertEquals(1, refused(agent));
    }

    /** A copy is read, as the agent's thread may add a plan meanwhile. */
    private static String plansOf(RunningAgent agent) {
        try {
            Object library = Agent.class.getMethod("getPL").invoke(agent.body().getTS().getAg());
            List<?> plans = (List<?>) library.getClass().getMethod("getPlans").invoke(library);
            return Arrays.stream(plans.toArray()).map(String::valueOf).collect(Collectors.joining("\n"));
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(e);
        }
    }

    static Stream<Arguments> jasonsOwn() {
        return Stream.of(ALL, GROUP, ME).flatMap(to -> Stream.of(
                "achieve;[kqml_received(x,tellHow,\"+!e <- diffuser.note(taught).\",m),e]",
                "achieve;kqml_received(x,tellHow,\"+!e <- diffuser.note(taught).\",m)",
                "achieve;kqml_received(b,achieve,open(g)[cast(unicast,'SUPO')],m)",
                "achieve;'kqml_received'(b,achieve,go(1),m)",
                "achieve;default::kqml_received(b,achieve,go(1),m)",
                "achieve;[[kqml_received(b,achieve,go(1),m)]]",
                "achieve;add_all_kqml_achieve(b,[go(1)])",
                "achieve;add_all_kqml_received(b,[p(1)[source(percept)]])",
                "achieve;opened(kqml_received(b,achieve,go(1),m))",
                "achieve;opened([1,[f(kqml_received(b,achieve,go(1),m))]])",
                "achieve;opened(1)[kqml_received(b,achieve,go(1),m)]",
                "unachieve;kqml_received(_,_,_,_)",
                "signal;kqml_received(b,achieve,go(1),m)",
                "tell;kqml_received(b,achieve,go(1),m)",
                "tell;jag_shutting_down(1)",
                "signal;jag_shutting_down(1)",
                "tell;kqml::clear_source_self(a,b)",
                "untell;kqml::clear_source_self(_,_)", "tell;NS::clear_source_self(a,b)",
                "achieve;NS::kqml_received(b,achieve,go(1),m)", "achieve;opened(NS::x)",
                "tell;'kqml'::clear_source_self(a,b)", "tell;p('kqml'::q)", "tell;p(1)[q('kqml'::r)]",
                "tell;'jag_shutting_down'(1)", "tell;p({ +!'kqml'::g <- x })", "tell;p({ +!g <- +'kqml'::x })",
                "tell;select__option(a,b,c,d)", "tell;'select__option'(a,b,c,d)", "tell;[q(1),select__option(a,b,c,d)]",
                "tell;~select__option(a,b,c,d)", "tell;x::select__option(a,b,c,d)", "tell;p__f(1,go(_))",
                "signal;f__l(go(1))", "achieve;f__g(go(1))", "untell;p__f(_,_)", "unachieve;f__g(_)")
                .map(content -> Arguments.of(to, content)));
    }

    @ParameterizedTest
    @MethodSource("jasonsOwn")
    void pass_jasonsOwnAtAnyDepth_refusedByEachCast(String to, String content) throws Exception {
        RunningAgent agent = ready();
        String before = plansOf(agent);
        board.receive(to, "ROMB", content);
        board.receive(ME, "ROMB", "achieve;e");
        nothingSoFar(agent);
        assertEquals(before, plansOf(agent));
        assertTrue(refused(agent) + agent.diffuser().inbox().malformed() > 0,
                content + " was let in");
    }

    @ParameterizedTest
    @ValueSource(strings = {
            "tellHow;{ +!kqml_received(S,F,C,M) <- diffuser.note(taught) }",
            "tellHow;\"+!kqml_received(S,F,C,M) <- diffuser.note(taught).\"",
            "tellHow;\"+!kqml\\\\_received(S,F,C,M) <- diffuser.note(taught).\"",
            "tellHow;[{ @l +!e <- x },{ +!kqml_received(S,F,C,M) <- diffuser.note(taught) }]",
            "tellHow;{ @l +!e <- !kqml_received(a,b,c,d) }",
            "tellHow;{ @l +!e <- if (true) { !!kqml_received(a,b,c,d) } }",
            "tellHow;{ +!X <- diffuser.note(taught) }",
            "tellHow;{ +X <- diffuser.note(taught) }",
            "tellHow;{ -!kqml_received(S,F,C,M) <- diffuser.note(taught) }",
            "untellHow;kqml_received",
            "askOne#AbC;kqml_received(_,_,_,_)",
            "askHow#AbC;{ +!kqml_received(_,_,_,_) }",
            "askHow#AbC;\"+!kqml_received(_,_,_,_)\"",
            "tellHow;{ +!'kqml'::e <- x }", "tellHow;\"+!'kqml'::e <- x.\"", "tellHow;{ @'kqml'::l +!e <- x }",
            "tellHow;{ +!f__g(X) <- diffuser.note(taught) }", "tellHow;\"+!f__g(X) <- diffuser.note(taught).\"",
            "untellHow;'kqml'::l", "askOne#AbC;select__option(_,_,_,_)", "askOne#AbC;'kqml'::l",
            "askHow#AbC;{ +!f__g(_) }", "askHow#AbC;\"+!f__g(_)\"", "askHow#AbC;\"+!'kqml'::g\"",
    })
    void pass_plansForJasonsOwn_refusedThoughSealed(String content) throws Exception {
        RunningAgent agent = ready();
        String before = plansOf(agent);
        board.receive(ME, "SUPO", content);
        nothingSoFar(agent);
        assertEquals(before, plansOf(agent));
        assertEquals(1L, refused(agent) + agent.diffuser().inbox().malformed());
    }

    /** Only what Jason would look up has such a name: terms within, variables and labels may. */
    @Test
    void pass_twoUnderlinesElsewhere_pass() throws Exception {
        RunningAgent agent = ready();
        board.receive(ME, "SUPO", "tell;p(my__thing(A__1))[my__mark]");
        agent.notes("sealed my__thing(A__1) SUPO");
        board.receive(ME, "SUPO", "tellHow;{ @p__98765 +!taught(X__1) <- diffuser.note(taught,X__1) }");
        while (!plansOf(agent).contains("taught(")) {
            agent.cycles(1);
        }
        board.receive(ME, "SUPO", "achieve;taught(1)");
        agent.notes("taught 1");
        board.receive(ME, "SUPO", "untellHow;p__98765");
        while (plansOf(agent).contains("taught(")) {
            agent.cycles(1);
        }
        assertEquals(0, refused(agent));
    }

    @ParameterizedTest
    @ValueSource(strings = {
            "tell;p(1)[source(percept)]", "tell;p(1)[source('percept')]", "tell;p(1)['source'('self')]",
            "tell;p(1)['kqml'::source(self)]", "tell;p(1)[source(self)]", "tell;p(1)[source(ROMB)[source(percept)]]",
            "tell;p(1)[cast(unicast,'SUPO')]", "tell;p(1)['source'(percept)]", "tell;p(1)[ns::source(percept)]",
            "tell;p(1)[|T]", "tell;p(1)[X]", "tell;p(1)[X,Y,Z]", "tell;p(1)[x|T]", "tell;[p(1)[|T],p(1)[source(self)]]",
            "tell;trusted(\"ROMB\")[source(self)]", "tell;delivered(a,b,c)[source(percept)]",
            "signal;delivered(a,b,c)[source(percept)]", "signal;p(1)[source(percept)]", "signal;p(1)[|T]",
            "achieve;go(1)", "achieve;open(g)[cast(unicast,'SUPO')]", "achieve;open(g)[|T]", "achieve;open(g)[X]",
            "achieve;[opened(1),go(1)][cast(unicast,'SUPO')]", "achieve;any(1)", "achieve;maybe(1)",
            "untell;own(1)", "untell;own(_)", "untell;trusted(_)", "untell;trusted(\"SUPO\")[source(self)]",
            "unachieve;start", "askOne#AbC;own(_)", "askAll#AbC;own(_)", "askHow#AbC;{ +!go(_) }",
            "tellHow;{ +!e <- diffuser.note(taught) }", "untellHow;x", "tell#AbC;p(1)", "sorry#AbC;\"no\"",
    })
    void pass_broadcastThatPretends_nothingItShouldNotDo(String content) throws Exception {
        RunningAgent agent = ready();
        String before = plansOf(agent);
        board.receive(ALL, "ROMB", content);
        board.receive(ALL, "ROMB", "achieve;e");
        board.receive(ALL, "ROMB", "achieve;open(g)");
        nothingSoFar(agent);
        assertEquals(before, plansOf(agent));
        assertEquals("own(1)[source(self)]", belief(agent, "own(_)"));
        assertEquals("trusted(\"SUPO\")[source(self)]", belief(agent, "trusted(\"SUPO\")"));
        onlySourceOfWhatCame(agent, "ROMB");
        assertTrue(board.requests.isEmpty(), () -> "the agent has spoken: " + board.requests);
    }

    private static String belief(RunningAgent agent, String pattern) {
        Literal found = agent.body().getTS().getAg().findBel(Literal.parseLiteral(pattern),
                new Unifier());
        return String.valueOf(found);
    }

    private static void onlySourceOfWhatCame(RunningAgent agent, String from) {
        for (Literal belief : agent.body().getTS().getAg().getBB()) {
            if (belief.hasAnnot(Literal.parseLiteral("cast(broadcast,x)")) || !belief.getAnnots("cast").isEmpty()) {
                assertEquals("[source(" + from + ")]", belief.getAnnots("source").toString(), belief.toString());
                assertEquals("[cast(broadcast," + from + ")]", belief.getAnnots("cast").toString(), belief.toString());
            }
        }
    }

    @Test
    void pass_goalOfABroadcastThatAPlanAsksFor_runsThatPlanOnly() throws Exception {
        RunningAgent agent = ready();
        board.receive(ALL, "ROMB", "achieve;[opened(1),opened(2)]");
        agent.notesAll("opened 1 ROMB", "opened 2 ROMB");
        board.receive(ALL, "ROMB", "achieve;maybe(never)");
        agent.notes("maybe never ROMB");
        board.receive(ALL, "ROMB", "tell;festival(now)");
        board.receive(ALL, "ROMB", "achieve;maybe(now)");
        nothingSoFar(agent);
        assertEquals(1, refused(agent));
        agent.warns("dropped achieve from ROMB: no plan that asks for it by [cast(broadcast,_)] is applicable now");
        board.receive(ME, "SUPO", "achieve;opened(3)");
        agent.notes("shut 3");
    }

    @Test
    void pass_goalOfABroadcastThatNoPlanAsksFor_reportedOnceWithTheLineToWrite() throws Exception {
        RunningAgent agent = ready();
        board.receive(ALL, "ROMB", "achieve;go(1)");
        board.receive(ALL, "ROMB", "achieve;any(2)");
        nothingSoFar(agent);
        agent.warns("dropped achieve from ROMB: it came as a broadcast, which anyone can send in anyone's name; if"
                + " the agent is to take it, write a plan that asks for it: +!go(X1)[cast(broadcast,S)] <- ...");
        assertEquals(List.of(), List.copyOf(agent.warnings));
        assertEquals(2, refused(agent));
    }

    /** Failure plans of a broadcast's goal must ask for it, too. */
    @Test
    void pass_goalOfABroadcastThatFails_runsFailurePlansThatAskOnly() {
        String program = PROGRAM + """
                +!risky(X)[cast(broadcast,S)] <- diffuser.note(risky,X); .fail.
                -!risky(1) <- diffuser.note(shut).
                -!risky(2)[cast(broadcast,S)] <- diffuser.note(rescued,S).
                -!risky(X) <- diffuser.note(shut).
                """;
        RunningAgent agent = RunningAgent.listening(program, board);
        board.receive(ALL, "ROMB", "achieve;risky(1)");
        agent.notes("risky 1");
        board.receive(ALL, "ROMB", "achieve;risky(2)");
        agent.notes("risky 2");
        agent.notes("rescued ROMB");
        nothingSoFar(agent);
        agent.warns("a goal risky has failed; if a plan is to handle that, write one that asks for it:"
                + " -!risky[cast(broadcast,S)]");
    }

    @Test
    void pass_questionsAndUntellOfACertifiedDevice_arePlansToRefuse() {
        String program = PROGRAM + DOOR + """
                +!kqml_received(S,untell,q(X),_)[peer(certified,S)] <- diffuser.note(kept,X).
                """;
        withACertifiedDevice(board);
        RunningAgent agent = RunningAgent.listening(program, board);
        assertRefusesTheCertifiedDevicesQuestion(agent);
        board.receive(ME, "ROMB", "tell;q(1)");
        board.receive(ME, "ROMB", "untell;q(1)");
        agent.notes("kept 1");
        assertEquals("q(1)[cast(unicast,ROMB),peer(certified,ROMB),source(ROMB)]", belief(agent, "q(_)"));
    }

    /** An agent may lose a belief between a question about it and its look for it. */
    @Test
    void pass_questionAboutABeliefThatGoes_isForPlansToRefuseToo() {
        String program = PROGRAM + DOOR + """
                door(1).
                +!kqml_received(S,askOne,Content,M) <- -door(1); ?Content; .send(S,tell,Content,M).
                """;
        withACertifiedDevice(board);
        assertRefusesTheCertifiedDevicesQuestion(RunningAgent.listening(program, board));
    }

    private void assertRefusesTheCertifiedDevicesQuestion(RunningAgent agent) {
        board.receive(ME, "ROMB", "askOne#AbC;door(X)");
        agent.notes("certified ROMB");
        board.receive(ME, "SUPO", "askOne#AbD;door(X)");
        agent.notes("partner");
    }

    private static FakeBoard withACertifiedDevice(FakeBoard board) {
        board.keys.set("SUPO", Bytes.of(1, 2, 3));
        board.keys.setSession("ROMB", Bytes.of(1, 2, 3));
        return board;
    }

    @Test
    void pass_unicast_isMarkedByTheSendersKeyAndNothingElse() {
        String program = PROGRAM + """
                +r(X)[peer(provisioned,S)] <- diffuser.note(known,X,S).
                +r(X)[peer(certified,S)] <- diffuser.note(certified,X,S).
                +r(X) <- diffuser.note(neither,X).
                """;
        withACertifiedDevice(board);
        RunningAgent agent = RunningAgent.listening(program, board);
        board.receive(ME, "SUPO", "tell;r(1)[peer(certified,\"SUPO\")]");
        agent.notes("known 1 SUPO");
        board.receive(ME, "ROMB", "tell;r(2)[peer(provisioned,\"ROMB\")]");
        agent.notes("certified 2 ROMB");
        // Beside the unicast, it would seem to be a provisioned one of ROMB.
        board.receive(GROUP, "ROMB", "tell;r(3)[peer(provisioned,\"ROMB\")]");
        agent.notes("neither 3");
        board.receive(ALL, "SUPO", "tell;r(4)[peer(provisioned,\"SUPO\")]");
        agent.notes("neither 4");
    }

    @ParameterizedTest
    @ValueSource(strings = {"tellHow;{ +!go(2) <- diffuser.note(taught) }", "untellHow;mine"})
    void pass_plansOfACertifiedDevice_refusedUnlessAPlanAsksForThem(String content) throws Exception {
        withACertifiedDevice(board);
        String performative = content.split(";")[0];
        RunningAgent agent = RunningAgent.listening(PROGRAM + "@mine +!own <- true.", board);
        String before = plansOf(agent);
        board.receive(ME, "ROMB", content);
        agent.warns(
                "it came from a certified device, or under a key that certified devices can get;"
                        + " if the agent is to take it,"
                        + " write a plan that asks for it: +!kqml_received(S," + performative
                        + ",X,_)[peer(certified,S)] <- ...");
        nothingSoFar(agent);
        assertEquals(before, plansOf(agent));
        assertEquals(1, refused(agent));
        agent.close();
        String open =
                "+!kqml_received(S,%s,X,_)[peer(certified,S)] <- diffuser.note(opened,S).".formatted(performative);
        FakeBoard again = withACertifiedDevice(new FakeBoard("radio"));
        RunningAgent asking = RunningAgent.listening(PROGRAM + open, again);
        again.receive(ME, "ROMB", content);
        asking.notes("opened ROMB");
        assertEquals(0, refused(asking));
    }

    @Test
    void peers_withStoredKeys_areBelieved() {
        String program = "!start. +!start <- .port(radio); .getRFMessages(open); diffuser.note(ready)."
                + "+peer(S,K)[source(percept)] <- diffuser.note(S,K).";
        RunningAgent agent = RunningAgent.run(program, withACertifiedDevice(board));
        agent.notesAll("ready", "SUPO provisioned");
    }

    @Test
    void pass_untellOfABroadcast_takesBackOnlyWhatABroadcastOfTheSameSenderTold() throws Exception {
        RunningAgent agent = ready();
        board.receive(ME, "SUPO", "tell;q(1)");
        board.receive(ALL, "SUAM", "tell;q(1)");
        board.receive(ALL, "ROMB", "tell;q(1)");
        board.receive(ALL, "SUPO", "untell;q(_)");
        board.receive(ALL, "ROMB", "untell;q(_)");
        nothingSoFar(agent);
        assertEquals(
                "q(1)[cast(broadcast,SUAM),cast(unicast,SUPO),peer(provisioned,SUPO),source(SUAM),source(SUPO)]",
                belief(agent, "q(_)"));
        assertEquals(1, refused(agent));
        board.receive(ALL, "SUPO", "tell;q(1)");
        board.receive(ALL, "SUPO", "untell;q(1)");
        board.receive(ALL, "SUAM", "untell;q(1)");
        nothingSoFar(agent);
        assertEquals("q(1)[cast(unicast,SUPO),peer(provisioned,SUPO),source(SUPO)]", belief(agent, "q(_)"));
        board.receive(ME, "SUPO", "untell;q(1)");
        nothingSoFar(agent);
        assertEquals("null", belief(agent, "q(_)"));
    }

    /** Jason looks anew for a belief with variables, and may find another. */
    @Test
    void pass_untellOfABroadcastOfWhatHasVariables_leavesWhatWasToldSealed() {
        RunningAgent agent = ready();
        board.receive(ALL, "SUPO", "tell;q(X,Y)");
        board.receive(ME, "SUPO", "tell;q(1,2)");
        board.receive(ALL, "SUPO", "tell;q(1,2)");
        board.receive(ALL, "SUPO", "untell;q(A,A)");
        nothingSoFar(agent);
        assertEquals("q(1,2)[cast(broadcast,SUPO),cast(unicast,SUPO),peer(provisioned,SUPO),source(SUPO)]",
                belief(agent, "q(1,2)[cast(unicast,SUPO)]"));
    }

    @Test
    void pass_untellOfABroadcastOfSeveral_eachIsTakenBack() {
        RunningAgent agent = ready();
        board.receive(ALL, "ROMB", "tell;[q(1),q(2)]");
        board.receive(ALL, "ROMB", "untell;[q(1),q(2)]");
        nothingSoFar(agent);
        assertEquals("null", belief(agent, "q(_)"));
    }

    /** Many at once: each is looked at when the one before has had its effect. */
    @Test
    void pass_tellAndUntellAtOnce_eachIsTakenBack() throws Exception {
        RunningAgent agent = ready();
        Inbox inbox = agent.diffuser().inbox();
        for (int i = 0; i < 20; i++) {
            for (String content : List.of("tell;q(" + i + ")", "untell;q(" + i + ")")) {
                inbox.put(new ReceivedMessage(Address.parse("ROMB"), Address.BROADCAST, 0, Content.parse(content)),
                        TrustLevel.PROVISIONED, agent.name());
            }
        }
        nothingSoFar(agent);
        assertEquals("null", belief(agent, "q(_)"));
        assertEquals(0, refused(agent));
    }

    @Test
    void pass_unachieveOfABroadcast_dropsOnlyWhatABroadcastOfTheSameSenderSet() {
        String program = PROGRAM + "+!keep(X) <- diffuser.note(keeping,X,own); .suspend.";
        RunningAgent agent = RunningAgent.listening(program, board);
        board.receive(ME, "SUPO", "achieve;keep(1)");
        agent.notes("keeping 1 unicast");
        board.receive(ALL, "SUPO", "achieve;keep(2)");
        agent.notes("keeping 2 broadcast");
        agent.achieve("keep(3)");
        agent.notes("keeping 3 own");
        board.receive(ALL, "ROMB", "unachieve;keep(_)");
        board.receive(ALL, "SUPO", "unachieve;keep(1)");
        board.receive(ALL, "SUPO", "unachieve;keep(3)");
        nothingSoFar(agent);
        board.receive(ALL, "SUPO", "unachieve;keep(2)");
        agent.notes("dropped 2");
        board.receive(ME, "SUPO", "unachieve;keep(1)");
        agent.notes("dropped 1");
    }

    /** Jason drops goals at their deadline, and stumbles over one that is no number. */
    @Test
    void pass_goalWithADeadline_isTakenWithoutIt() {
        RunningAgent agent =
                RunningAgent.listening(PROGRAM + "+!kqml_received(S,tellHow,_,_) <- .print(S).", board);
        board.receive(ME, "SUPO", "achieve;keep(1)[hard_deadline(0)]");
        agent.notes("keeping 1 unicast");
        board.receive(ME, "SUPO", "achieve;keep(2)[hard_deadline(x)]");
        agent.notes("keeping 2 unicast");
        nothingSoFar(agent);
        assertEquals(List.of(), List.copyOf(agent.warnings));
    }

    @Test
    void pass_originIsAnAgentOfThisMas_refused() throws Exception {
        RunningAgent agent = ready();
        RunningAgent beside = RunningAgent.named("suam", "");
        board.receive(ME, beside.name(), "tell;p(1)");
        board.receive(ALL, beside.name(), "achieve;opened(1)");
        nothingSoFar(agent);
        agent.warns("dropped tell from suam: an agent of this MAS has that name; give the agent or the device"
                + " another");
        assertEquals(2, refused(agent));
    }

    @ParameterizedTest
    @CsvSource({"tell;p(1)", "untell;own(1)", "achieve;go(1)"})
    void pass_originIsSelf_neverReachesTheAgent(String content) throws Exception {
        RunningAgent agent = ready();
        board.receive(ALL, "self", content);
        board.receive(ME, "self", content);
        nothingSoFar(agent);
        assertEquals("own(1)[source(self)]", belief(agent, "own(_)"));
        assertEquals("null", belief(agent, "p(_)"));
    }

    @Test
    void pass_answerThatNamesJasonsOwn_failsTheIntentionThatWaits() {
        String program = PROGRAM + """
                +!ask <- .setMyRFId("CAFE"); .send("SUPO",askOne,x(_),A); diffuser.note(A).
                -!ask[error(E)] <- diffuser.note(E).
                """;
        RunningAgent agent = RunningAgent.listening(program, board);
        agent.achieve("ask");
        RunningAgent.asked(board, "id CAFE");
        String asked = RunningAgent.next(board.requests, "a question");
        String conversation = asked.substring(asked.indexOf('#'), asked.indexOf(';'));
        board.receive(ME, "SUPO", "tell" + conversation + ";kqml_received(a,b,c,d)");
        agent.notes("no_answer");
    }

    /** As the README shows it, in a program around it. */
    @Test
    void pass_guardOfTheReadme_holdsAgainstATrustedCertifiedDevice() throws Exception {
        String readme = Files.readString(
                Path.of(System.getProperty("javino.root"), "diffuser-arch", "README.md"));
        String guard = readme.lines().filter(line -> line.startsWith("+!open(Gate)[cast(unicast, S)]")).findFirst()
                .orElseThrow();
        String trusted = readme.lines().filter(line -> line.startsWith("trusted(")).findFirst().orElseThrow();
        String program = trusted + """

                !start.
                +!start <- .port(radio); .getRFMessages(open); diffuser.note(ready).
                +!go(X) <- diffuser.note(went,X).
                """ + guard;
        RunningAgent agent = RunningAgent.listening(program, board);
        for (String told : List.of("trusted('ROMB')", "trusted(romb)", "trusted('ROMB')[source(self)]",
                "trusted(X)", "trusted(X)[source(self)]", "trusted('ROMB')[|T]")) {
            board.receive(ALL, "ROMB", "tell;" + told);
            board.receive(ME, "ROMB", "tell;" + told);
        }
        board.receive(ME, "ROMB", "achieve;open(gate)");
        board.receive(ALL, "SUPO", "achieve;open(gate)");
        board.receive(ALL, "SUPO", "achieve;open(gate)[cast(unicast,'SUPO')]");
        nothingSoFar(agent);
        assertTrue(board.requests.isEmpty());
        board.receive(ME, "SUPO", "achieve;open(gate)");
        RunningAgent.asked(board, "act open(gate)");
    }

    /** Whatever Jason's parser says of it, and whatever a plan prints of it. */
    @ParameterizedTest
    @ValueSource(strings = {"tell;p(\"x\\nSEVERE: forged\")", "tell;p(\"\u001b[2J\")", "tell;p(\"a\u202Eb\")",
            "tell;q(\n\n", "tell;p(\"", "tell;p(math.sqrt(\"\\n\"))", "tell;p(math.max(1))", "tell;p(A+1)",
            "tell;p(1/0)",
            "tell;p(-x)", "tell;p(\"a\" + 1)", "tell;p(.count(x))", "tell;p(count(x)+1)", "tell;p(a mod 2)",
            "tell;p(q(1)(2))", "tell;p(\u0000)", "tell;'\n'", "tell;p('\n')", "achieve;p(\"\\n\")", "sing;\n\u001b",
            "tell;p({ q :- X > math.sqrt(\"\\n\") })", "tell;p(X[math.sqrt(\"\\n\")])", "tell;p({ .foo(\"\\n\") })",
            "untellHow;[x,\"\\n\"]", "tellHow;{ +!e <- .print(\"\\n\" }", "achieve;[a,[b]]"})
    void pass_anyText_writesOneLineAtMostWithoutCommands(String content) {
        String program = """
                !start.
                +!start <- .port(radio); .getRFMessages(open); diffuser.note(ready).
                +!go(X) <- diffuser.note(went,X).
                +p(X) : X + 1 > 2 <- .print("told ", X).
                +p(X) : math.abs(X) > 2 <- .print("told ", X).
                +p(X) : .length(X,N) & N > 100 <- .print("told ", X).
                +p(X) : X =.. Y <- .print("told ", X).
                +p(X) <- .print("told ", X); .println(X); .printf("%s", X); .log(info, X); !sum(X).
                +!sum(X) <- Y = X * 2.
                """;
        try (PlainLog log = new PlainLog()) {
            RunningAgent agent = RunningAgent.listening(program, board);
            board.receive(ME, "ROMB", content);
            board.receive(ALL, "ROMB", content);
            nothingSoFar(agent);
            for (LogRecord line : log.lines) {
                assertPlain(line);
                assertFalse(line.getThrown() != null, line.getMessage());
            }
        }
    }

    /** Jason adds where in its code that came to light; what the sender wrote stays in one line, also there. */
    @Test
    void pass_planWithAnActionThatNobodyHas_writesOneLineAndWhereItFailed() {
        try (PlainLog log = new PlainLog()) {
            RunningAgent agent = ready();
            board.receive(ME, "ROMB", "tellHow;{ +!e <- dang.er }");
            // The agent may see to a goal before it has learnt the plan.
            for (int i = 0; i < 100 && log.lines.stream().noneMatch(line -> line.getThrown() != null); i++) {
                board.receive(ME, "ROMB", "achieve;e");
                agent.cycles(5);
            }
            assertTrue(log.lines.stream().anyMatch(line -> line.getThrown() != null));
            log.lines.forEach(GateTest::assertPlain);
        }
    }

    private static void assertPlain(LogRecord line) {
        // Jason's own further lines.
        String text = line.getMessage().replaceAll("\n(?= {4}|intention \\d+:)", " ") + line.getThrown();
        assertTrue(text.codePoints().noneMatch(c -> Character.isISOControl(c) || c == 0x202E), text);
    }

    /** A log that asks its formatter alone, as the window of Jason does, and keeps all that reaches it. */
    private static final class PlainLog extends StreamHandler implements AutoCloseable {

        final List<LogRecord> lines = new CopyOnWriteArrayList<>();

        PlainLog() {
            Logger.getLogger("").addHandler(this);
        }

        @Override
        public void publish(LogRecord line) {
            getFormatter().format(line);
            lines.add(line);
        }

        @Override
        public void close() {
            Logger.getLogger("").removeHandler(this);
        }
    }
}
