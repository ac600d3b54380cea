package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;

import jason.infra.local.LocalEnvironment;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import javino.board.BoardConfig;
import javino.fake.FakeBoard;

class PerceptsTest {

    private static final String PROGRAM = """
            !start.
            +!start <- .port(board); .percepts(open).
            +!open  <- .percepts(open).
            +!block <- .percepts(block).
            +p(X)   <- diffuser.note(plus,X).
            -p(X)   <- diffuser.note(minus,X).
            +e(X)   <- diffuser.note(plus,e,X).
            -e(X)   <- diffuser.note(minus,e,X).
            +other(X) <- diffuser.note(other,X).
            -other(X) <- diffuser.note(other,gone).
            +port(_,S) <- diffuser.note(S).
            -port(_,S) <- diffuser.note(no,S).
            """;

    @Test
    void percepts_sensorsChange_beliefsAppearAreReplacedAndDisappear() {
        FakeBoard board = new FakeBoard("board").perceive("p(1)");
        RunningAgent agent = RunningAgent.run(PROGRAM, board);
        agent.notesAll("on", "plus 1");
        board.perceive("p(2)", "p(3)");
        agent.notesAll("minus 1", "plus 2", "plus 3");
        board.perceive("p(3)");
        agent.notes("minus 2");
        board.perceive();
        agent.notes("minus 3");
    }

    @Test
    void percepts_blockedAndOpened_beliefsGoAndComeButThePortStays() throws Exception {
        FakeBoard board = new FakeBoard("board").perceive("p(1)");
        RunningAgent agent = RunningAgent.run(PROGRAM, board);
        agent.notesAll("on", "plus 1");
        agent.achieve("block");
        agent.notes("minus 1");
        agent.achieve("open");
        agent.notes("plus 1");
    }

    @ParameterizedTest
    @ValueSource(strings = {".port(board); .percepts(open)", ".percepts(open); .port(board)",
            ".port(board); .percepts(open); .percepts(block); .percepts(open)",
            ".limit(3600000); .port(board); .percepts(open)"})
    void percepts_opened_areBelievedInTheNextStep(String opening) {
        for (int i = 0; i < 10; i++) {
            FakeBoard board = new FakeBoard("board").perceive("p(42)");
            RunningAgent agent =
                    RunningAgent.run("!start. +!start <- " + opening + "; ?p(X); diffuser.note(X).", board);
            agent.notes("42");
            agent.close();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {".percepts(open); diffuser.note(went)",
            ".percepts(open); .port(board); .percepts(open); diffuser.note(went)",
            ".port(board); .percepts(open); ?not q; diffuser.note(went)",
            ".port(missing); .percepts(open); ?not q; diffuser.note(went)"})
    void percepts_openedWhereNothingIsPerceived_goesOn(String plan) {
        RunningAgent.run("!start. +!start <- " + plan + ".", new FakeBoard("board")).notes("went");
    }

    /** No stalled board counts as lost. */
    public static final class PatientDiffuser extends ScriptedDiffuser {

        private static final long serialVersionUID = 1L;

        @Override
        protected BoardConfig boardConfig() {
            return quick(Duration.ofHours(1));
        }
    }

    /** As {@code delay} in a sketch's function of percepts does. */
    @ParameterizedTest
    @ValueSource(strings = {".port(board); .percepts(open)", ".percepts(open); .port(board)"})
    void percepts_openedWhereAReadingLasts_goesOnWithoutIt(String plan) {
        FakeBoard board = new FakeBoard("board").perceive("p(1)");
        board.stallAt("poll");
        RunningAgent agent = RunningAgent.run("""
                !start.
                +!start <- %s; diffuser.note(went).
                +port(_,off) <- diffuser.note(off).
                +p(X) <- diffuser.note(p,X).
                """.formatted(plan), null, List.of(PatientDiffuser.class.getName()), board);
        agent.notes("went");
        board.resume();
        agent.notes("p 1");
    }

    /** Jason has the intention selected still that has ended in the cycle before. */
    @Test
    void openPort_betweenTwoCycles_opensIt() throws Exception {
        openLater.opened = new CompletableFuture<>();
        RunningAgent.run("!start. +!start <- diffuser.openLater.", new FakeBoard("board"));
        openLater.opened.get();
    }

    /** If readings are rare, a plan does not wait for the next one. */
    @Test
    void percepts_openedAgainLongBeforeTheNextReading_goesOn() {
        RunningAgent agent = RunningAgent.run("""
                !start.
                +!start <- .limit(3600000); .port(board); .percepts(open); ?p(X); .percepts(open); ?p(X);
                    diffuser.note(X).
                """, new FakeBoard("board").perceive("p(1)"));
        agent.notes("1");
    }

    @Test
    void percepts_neverOpened_noBeliefs() {
        FakeBoard board = new FakeBoard("board").perceive("p(1)");
        String program = "!start. +!start <- .port(board). +p(X) <- diffuser.note(p). +q <- diffuser.note(q)."
                + "+port(_,S) <- diffuser.note(S).";
        RunningAgent agent = RunningAgent.run(program, board);
        agent.notes("on");
        agent.cycles(3);
        agent.believe("q");
        agent.notes("q");
    }

    @Test
    void percepts_someMalformed_skippedOneByOneAndReportedOnce() throws Exception {
        FakeBoard board =
                new FakeBoard("board").perceive("p(1)", "p(", "P", "p(X)", "3", ".print(hello)", "", "p(2)");
        RunningAgent agent = RunningAgent.run(PROGRAM, board);
        agent.notesAll("on", "plus 1", "plus 2");
        agent.warns("skipped a percept of the board on board that is no AgentSpeak, \"p(\"");
        agent.warns("\"P\"");
        agent.warns("\"p(X)\": it has a variable");
        agent.warns("\"3\"");
        agent.warns("\".print(hello)\"");
        agent.warns("\"\"");
        board.perceive("p(1)", "p(");
        agent.notes("minus 2");
        assertEquals(List.of(), List.copyOf(agent.warnings));
        assertEquals(7L, agent.diffuser().getStatus().get("perceptsMalformed"));
    }

    /** A board is no more than another outside: with other sources its percepts would stay for ever. */
    @Test
    void percepts_annotationsWithAMeaning_areTakenOff() {
        FakeBoard board = new FakeBoard("board").perceive("p(1)[source(self)]", "p(2)['source'(self),sure(3)]",
                "p(3)[cast(unicast,'SUPO'),peer(provisioned,'SUPO')]", "p(a[source(self)])");
        RunningAgent agent = RunningAgent.run("""
                !start.
                +!start <- .port(board); .percepts(open); ?p(2)[sure(S)]; diffuser.note(sure,S).
                -p(X) <- diffuser.note(minus,X).
                +!probe <- .count(p(_),N); .count(p(_)[source(percept)],M); .count(p(_)[source(self)],K);
                    .count(p(_)[cast(_,_)],C); diffuser.note(N,M,K,C).
                """, board);
        agent.notes("sure 3");
        agent.achieve("probe");
        agent.notes("4 4 0 0");
        board.perceive();
        agent.notesAll("minus 1", "minus 2", "minus 3", "minus a");
        agent.achieve("probe");
        agent.notes("0 0 0 0");
    }

    /** They would be taken for what the architecture itself lets the agent perceive, or mean something to Jason. */
    @ParameterizedTest
    @ValueSource(strings = {"port(\"board\",off)", "'port'(\"board\",off)", "select__option(a,b,c,d)", "p__f(1,go)",
            "kqml::x(1)", "'kqml'::x(1)", "jag_shutting_down(1)", "kqml_received(a,b,c,d)", "p(kqml::x)"})
    void percepts_ofOthersMeaning_areLeftOutCountedAndNamed(String percept) throws Exception {
        FakeBoard board = new FakeBoard("board").perceive(percept, "p(my__thing)");
        RunningAgent agent = RunningAgent.run(PROGRAM + "+!probe <- .count(select__option(_,_,_,_),N);"
                + ".count(port(_,off),M); diffuser.note(N,M).", board);
        agent.notesAll("on", "plus my__thing");
        agent.warns("skipped a percept of the board on board, \"" + percept + "\": ");
        agent.achieve("probe");
        agent.notes("0 0");
        assertTrue((long) agent.diffuser().getStatus().get("perceptsMalformed") > 0);
    }

    @Test
    void percepts_boardGoesAndComes_beliefsFollowIt() {
        FakeBoard board = new FakeBoard("board").perceive("p(1)");
        RunningAgent agent = RunningAgent.run(PROGRAM, board);
        agent.notesAll("on", "plus 1");
        board.port.unplug();
        agent.notesAll("no on", "off", "minus 1");
        board.port.plug();
        agent.notesAll("no off", "on", "plus 1");
    }

    @Test
    void perceive_environmentHasPerceptsToo_bothStay() throws Exception {
        LocalEnvironment environment = RunningAgent.environment();
        TestEnvironment world = (TestEnvironment) environment.getUserEnvironment();
        world.show("e(1)");
        FakeBoard board = new FakeBoard("board").perceive("p(1)");
        RunningAgent agent = RunningAgent.run(PROGRAM, environment,
                List.of(ScriptedDiffuser.class.getName()), board);
        agent.notesAll("plus e 1", "on", "plus 1");
        board.perceive("p(2)");
        agent.notesAll("minus 1", "plus 2");
        world.show("e(2)");
        agent.notesAll("minus e 1", "plus e 2");
        board.perceive();
        agent.notes("minus 2");
    }

    @Test
    void perceive_anotherArchitectureBehind_bothStay() {
        FakeBoard board = new FakeBoard("board").perceive("p(1)");
        RunningAgent agent = RunningAgent.run(PROGRAM, null,
                List.of(ScriptedDiffuser.class.getName(), PerceivingArch.class.getName()), board);
        agent.notesAll("other 1", "on", "plus 1");
        board.perceive("p(2)");
        agent.notesAll("minus 1", "plus 2");
    }

    @Test
    void perceive_anotherArchitectureInFront_bothStay() {
        FakeBoard board = new FakeBoard("board").perceive("p(1)");
        RunningAgent agent = RunningAgent.run(PROGRAM, null,
                List.of(PassingArch.class.getName(), ScriptedDiffuser.class.getName()), board);
        agent.notesAll("on", "plus 1");
        board.perceive("p(2)");
        agent.notesAll("minus 1", "plus 2");
    }

    @Test
    void perceive_noPortOpened_nothingChangesForTheAgent() throws Exception {
        LocalEnvironment environment = RunningAgent.environment();
        ((TestEnvironment) environment.getUserEnvironment()).show("e(1)");
        RunningAgent agent = RunningAgent.run("+e(X) <- diffuser.note(e,X).", environment,
                List.of(ScriptedDiffuser.class.getName()));
        agent.notes("e 1");
    }
}
