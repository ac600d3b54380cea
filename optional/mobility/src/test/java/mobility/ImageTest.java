package mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

import jason.JasonException;
import jason.asSemantics.Agent;
import jason.asSemantics.Event;
import jason.asSemantics.Intention;
import jason.asSemantics.Option;
import jason.asSyntax.ASSyntax;
import jason.asSyntax.Plan;
import jason.asSyntax.Trigger;

import diffuser.report.Failure;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** An agent is the same after its texts have been written and read. */
@Tag("newerJava")
class ImageTest {

    @Test
    void agent_writtenInSomeStep_goesOnBehindIt() throws Exception {
        Stage there = Stage.of("!tour(3). +!tour(N) : N > 0 <- say(N); mobility.leave; say(then,N+1).").moved();
        there.run(10);
        assertEquals(List.of("say then 4"), there.done);
    }

    @Test
    void subgoal_returnsValueToItsCaller_throughTwoLevels() throws Exception {
        Stage there = Stage.of("""
                !start.
                +!start <- !outer(X,k); say(X).
                +!outer(Y,K) <- !inner(Z); Y = r(Z,K).
                +!inner(W) <- mobility.leave; W = 5.
                """).moved();
        there.run(20);
        assertEquals(List.of("say r(5,k)"), there.done);
    }

    @Test
    void failure_findsItsGoal() throws Exception {
        Stage there = Stage.of("""
                !start.
                +!start <- !risky(1,X); say(after,X).
                +!risky(N,X) <- !deeper(N); X = unreached.
                -!risky(N,X)[error(E)] <- say(failed,N,E); X = rescued.
                +!deeper(N) <- mobility.leave; .fail(oops).
                """).moved();
        there.run(20);
        assertEquals(List.of("say failed 1 internal_action", "say after rescued"), there.done);
    }

    /** Jason notes with a failure the file in which the plan was, by its whole name. */
    @Test
    void failure_thatIsHandled_tellsNoFileOfThisComputer() throws Exception {
        Image image = Stage.of("""
                !go.
                +!go <- .fail(oops).
                -!go[code(C)] <- mobility.leave; say(C).
                """).leave();
        assertFalse(image.state().contains("code_src"), image.state());
        assertTrue(image.state().contains("code_line("), image.state());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "; say(never)", "; !never"})
    void agent_thatStays_failsWithTheReason(String then) throws Exception {
        Image image = Stage.of("""
                !go.
                +!go <- !tour(7); say(end).
                +!tour(N) <- mobility.leave%s.
                -!tour(N)[error(E)] <- say(N,E).
                """.formatted(then)).leave();
        Stage here = Stage.of(AgentStateReader.read(image), new Agent(),
                Optional.of(new Failure("undelivered", "nobody there")));
        assertEquals(List.of("say 7 undelivered", "say end"), here.run(20).done);
    }

    @Test
    void program_isTheSameOnEachSide() throws Exception {
        Stage here = Stage.of("""
                limit(7). seen(b,2)[deg(3)]. seen(a,1). ~wet. text("a \\"b\\"\\nc"). odd('ROMA').
                near(X,Y) :- limit(L) & X - Y < L & not far(100).
                far(X) :- .count(seen(_,_)) > X | X = -3.
                !go.
                @mine[atomic,note("x")] +!go : near(1,2) & limit(N) <- if (N > 3) { +big } else { !small; -big };
                    while (cond(Q) & Q < 4) { +foo(Q) }; for (seen(A,_)) { note(A) }; X = .count(seen(_,_));
                    .wait({+done(_)},100); W = {!a; ?b(_)}; Z = math.max(1,-2); mobility.leave; say(X,Z,N).
                @[atomic] +!small.
                +!g[scope] <: limit(9) <- a. { @in +e(V) <- b(V). -!c <- d. }
                +!h(_1,[_1|T],_2) : p(_2) <- a(T).
                """);
        here.run(3);
        Image image = AgentStateWriter.write(here.ts, null);
        assertEquals("""
                far(X) :- ((.count(seen(_,_)) > X) | (X = (-3))).
                near(X,Y) :- (limit(L) & (((X-Y) < L) & not (far(100)))).
                @mine[atomic,note("x")] +!go : (near(1,2) & limit(N)) <- .if_then_else((N > 3),{ +big },\
                { !small; -big }); .loop((cond(Q) & (Q < 4)),{ +foo(Q) }); .foreach(seen(A,_),{ note(A) }); \
                (X = .count(seen(_,_))); .wait({ +done(_) },100); (W = { !a; ?b(_) }); (Z = math.max(1,(-2))); \
                mobility.leave; say(X,Z,N).
                @[atomic] +!small.
                +!g[scope] <: limit(9) <- a. { @in +e(V) <- b(V). -!c <- d. }
                +!h(V1,[V1|T],V2) : p(V2) <- a(T).""", image.program());
        assertEquals("""
                Bbig
                Blimit(7)
                Bodd('ROMA')
                Bseen(b,2)[deg(3)]
                Bseen(a,1)
                Btext("a \\"b\\"\\nc")
                B~wet""", image.state().lines().filter(line -> line.startsWith("B")).collect(Collectors.joining("\n")));
        assertEquals(image, AgentStateWriter.write(Stage.of(image).ts, null));
    }

    @Test
    void percepts_stayBehind_andOtherSourcesTravel() throws Exception {
        Stage here = Stage.of("+hot(X) <- say(X).");
        here.ts.getAg().getBB().add(ASSyntax.parseLiteral("hot(1)[source(percept)]"));
        here.ts.getAg().getBB().add(ASSyntax.parseLiteral("hot(2)[source(bob),source(percept)]"));
        here.ts.getAg().getBB().add(ASSyntax.parseLiteral("hot(3)[source(self),source(ROMA),cast(unicast,ROMA)]"
                .replace("ROMA", "'ROMA'")));
        here.ts.getC().addExternalEv(ASSyntax.parseTrigger("+hot(4)[source(percept)]"));
        here.ts.getC().addExternalEv(ASSyntax.parseTrigger("+hot(5)[source(bob)]"));
        String state = AgentStateWriter.write(here.ts, null).state();
        assertEquals("Bhot(3)[cast(unicast,'ROMA'),source('ROMA'),source(self)]\nBhot(2)[source(bob)]\n"
                + "I+hot(5)[source(bob)]", state);
    }

    @Test
    void intentionOfPercept_travels() throws Exception {
        Stage here = Stage.of("+hot(X)[source(S)] <- mobility.leave; say(X,S).");
        here.ts.getC().addExternalEv(ASSyntax.parseTrigger("+hot(4)[source(percept)]"));
        assertEquals(List.of("say 4 percept"), here.moved().run(5).done);
    }

    @Test
    void goalOfBroadcast_isBegun() throws Exception {
        // As the gate chooses a plan for it.
        Stage here = Stage.of("+!go(X) <- say(X,1). +!go(X) <- say(X,2).");
        Trigger trigger = ASSyntax.parseTrigger("+!go(7)[source(bob)]");
        Plan second = Library.of(here.ts.getAg()).own().get(1);
        Event event = new Event(trigger, Intention.EmptyInt);
        event.setOption(new Option(second, second.isRelevant(trigger, null)));
        here.ts.getC().addEvent(event);
        Stage there = Stage.of(AgentStateWriter.write(here.ts, null));
        assertEquals(List.of("say 7 2"), there.run(5).done);
    }

    @Test
    void wait_beginsAnew() throws Exception {
        Stage there =
                Stage.of(AgentStateWriter.write(Stage.of("!go. +!go <- .wait({+over(X)}); say(X).").run(5).ts, null));
        there.run(5);
        assertEquals(List.of(), there.done);
        there.ts.getAg().addBel(ASSyntax.parseLiteral("over(3)"));
        assertEquals(List.of("say 3"), there.run(8).done);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '#', value = {
            "!go. +!go <- hang(1). # its intention for +!go[source(self)] waits for hang(1)",
            "!go. +!go <- .send(bob,askOne,p(X),A); say(A). # waits for .send(bob,askOne,p(X),A)",
            "!go. +!go <- !in. +!in <- mobility.leave. # its intention for +!go[source(self)] waits for mobility.leave",
            "!go. +!go <- { .wait(9000) } |&| { .wait(9000) }. # share their goals",
            "!go. +!go <- .queue.create(Q); .wait(9000); say(Q). # it holds a Java object",
            "!go. +!go <- .set.create(S); +p(S). # the belief p(",
            "p(cobj_12). # it holds an artifact's handle, cobj_12",
            "+!kqml_received(A,B,C,D) <- a. # it names a goal or event of Jason itself: kqml_received",
            "+jag_shutting_down <- a. # it names a goal or event of Jason itself: jag_shutting_down",
            "+!go(V_1) <- a(V_1). # a variable's name is V_1"})
    void agent_thatCannotTravel_saysWhy(String program, String why) {
        Stage stage = Stage.of(program).run(6);
        String before = stage.ts.getC().toString();
        JasonException e = assertThrows(JasonException.class, () -> AgentStateWriter.write(stage.ts, null));
        assertEquals("[error(cannot_travel)", e.getErrorTerms().toString().substring(0, 21));
        assertTrue(e.getMessage().startsWith("traveller cannot travel: ") && e.getMessage().contains(why),
                e.getMessage());
        assertEquals(1, e.getMessage().lines().count());
        assertEquals(before, stage.ts.getC().toString());
    }
}
