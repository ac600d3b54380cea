package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;

import diffuser.mind.Ability;
import diffuser.mind.Openness;

import javino.fake.FakeBoard;
import javino.protocol.Counter;
import javino.protocol.Outcome;
import javino.protocol.Status;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The belief {@code openness(S)} of agents with a board. */
class OpennessBeliefTest {

    /** Notes each change, and nothing else but that what was asked of it is done. */
    private static final String PROGRAM = """
            !start.
            +!start <- .port(antenna); .setMyRFId("SUPO"); %s; diffuser.note(ready).
            +!allow(Name, What) <- .infrastructure(Name, What).
            +!radio(S) <- .getRFMessages(S).
            +!silence(Ms) <- .silence(Ms).
            +!send <- .diffuse("ROMA", tell, x).
            +!other <- .port(missing).
            +!probe <- diffuser.note(probed).
            +openness(S) <- diffuser.note(S).
            -openness(S) <- diffuser.note(no, S).
            """;

    /** An agent that has come from totally closed to a state. */
    private static RunningAgent in(Openness state, FakeBoard board) {
        RunningAgent agent = open(board);
        if (state.abilities().contains(Ability.MOB)) {
            agent.achieve("allow(lte,[mob])");
            changes(agent, "closed", "open");
        }
        if (!state.abilities().contains(Ability.COM)) {
            board.port.unplug();
            changes(agent, state.abilities().contains(Ability.MOB) ? "open" : "closed", state.atom());
        }
        return agent;
    }

    private static FakeBoard board() {
        return new FakeBoard("antenna").setCounter(Counter.RADIO_RECEIVED, 0);
    }

    private static RunningAgent open(FakeBoard board) {
        RunningAgent agent = RunningAgent.run(PROGRAM.formatted(".getRFMessages(open)"), board);
        agent.notesAll("totallyClosed", "no totallyClosed", "closed", "ready");
        return agent;
    }

    /** From now on nobody is told to be silent, however late the agent is to see that somebody was heard. */
    private static void stopCounting(FakeBoard board) {
        board.refuse("statistics", Status.UNKNOWN_COMMAND);
    }

    private static void goOnCounting(FakeBoard board) {
        board.refuse("statistics", Status.UNKNOWN_COMMAND, 0);
    }

    private static void changes(RunningAgent agent, String from, String to) {
        agent.notesAll("no " + from, to);
    }

    @ParameterizedTest
    @FigureOne
    void figureOne_eachTransition_isAChangeOfTheBelief(Openness from, String symbol, Openness to) throws Exception {
        FakeBoard board = board();
        RunningAgent agent = in(from, board);
        assertEquals(from, agent.diffuser().openness());
        switch (symbol) {
            case "-com" -> board.port.unplug();
            case "+com" -> board.port.plug();
            case "-mob" -> agent.achieve("allow(lte,[])");
            default -> agent.achieve("allow(lte,[mob])");
        }
        changes(agent, from.atom(), to.atom());
        assertEquals(to, agent.diffuser().openness());
        assertEquals(to.atom(), agent.diffuser().getStatus().get("openness"));
    }

    @Test
    void belief_noPortOpened_isTotallyClosedFromTheFirst() {
        String program = "!start. +!start : openness(totallyClosed)[source(percept)] <- diffuser.note(known).";
        RunningAgent agent = RunningAgent.run(program);
        agent.notes("known");
    }

    @ParameterizedTest
    @ValueSource(strings = {".percepts(open)", ".getRFMessages(block)"})
    void radioNotOpened_staysTotallyClosed(String instead) {
        RunningAgent agent = RunningAgent.run(PROGRAM.formatted(instead), board());
        agent.notesAll("totallyClosed", "ready");
        agent.notesNothingElse();
    }

    @Test
    void boardHasNoAddress_staysTotallyClosedUntilItHas() {
        String program = PROGRAM.replace("; .setMyRFId(\"SUPO\")", "").formatted(".getRFMessages(open)")
                + "+!name <- .setMyRFId(\"SUPO\").";
        RunningAgent agent = RunningAgent.run(program, board());
        agent.notesAll("totallyClosed", "ready");
        agent.notesNothingElse();
        agent.achieve("name");
        changes(agent, "totallyClosed", "closed");
    }

    @Test
    void boardRefusesItsAddress_staysTotallyClosed() {
        FakeBoard board = board().refuse("id SUPO", Status.STORE_FAILED);
        String program = PROGRAM.formatted(".getRFMessages(open)") + "-!start <- .getRFMessages(open); !probe.";
        RunningAgent agent = RunningAgent.run(program, board);
        agent.notesAll("totallyClosed", "probed");
        agent.notesNothingElse();
    }

    @Test
    void boardKnowsItsAddress_agentNeedNotSetIt() {
        String program = PROGRAM.replace("; .setMyRFId(\"SUPO\")", "").formatted(".getRFMessages(open)");
        RunningAgent agent = RunningAgent.run(program, board().setRfId("SUPO"));
        agent.notesAll("totallyClosed", "no totallyClosed", "closed", "ready");
    }

    @Test
    void radioBlockedAndOpened_communicabilityIsLostAndRestored() {
        RunningAgent agent = open(board());
        agent.achieve("radio(block)");
        changes(agent, "closed", "totallyClosed");
        agent.achieve("radio(open)");
        changes(agent, "totallyClosed", "closed");
    }

    @Test
    void boardFallsSilentAndAnswersAgain_communicabilityIsLostAndRestored() {
        FakeBoard board = board();
        RunningAgent agent = open(board);
        board.line.setSilent(true);
        changes(agent, "closed", "totallyClosed");
        board.line.setSilent(false);
        changes(agent, "totallyClosed", "closed");
    }

    @Test
    void anotherPortOpened_onlyTheNewBoardCounts() {
        FakeBoard board = board();
        RunningAgent agent = open(board);
        agent.achieve("other");
        changes(agent, "closed", "totallyClosed");
        agent.notesNothingElse();
    }

    @Test
    void communicability_severalMeans_isLostWithTheLast() {
        FakeBoard board = board();
        RunningAgent agent = open(board);
        agent.achieve("allow(lte,[com])");
        agent.achieve("allow(\"wifi\",[com])");
        agent.notesNothingElse();
        board.port.unplug();
        agent.warns("the board is off");
        agent.notesNothingElse();
        agent.achieve("allow(wifi,[])");
        agent.notesNothingElse();
        agent.achieve("allow(lte,[])");
        changes(agent, "closed", "totallyClosed");
        agent.achieve("allow(lte,[mob,com])");
        changes(agent, "totallyClosed", "open");
    }

    @Test
    void silence_nobodyIsHeardAndSomebodyAgain_communicabilityIsLostAndRestored() {
        FakeBoard board = board();
        board.setRise(Counter.RADIO_RECEIVED, 1);
        RunningAgent agent = open(board);
        agent.achieve("silence(20)");
        agent.notesNothingElse();
        board.setRise(Counter.RADIO_RECEIVED, 0);
        changes(agent, "closed", "totallyClosed");
        board.setRise(Counter.RADIO_RECEIVED, 1);
        changes(agent, "totallyClosed", "closed");
    }

    @Test
    void silence_setLaterAndTakenBack_counts() {
        FakeBoard board = board();
        RunningAgent agent = open(board);
        agent.achieve("silence(20)");
        changes(agent, "closed", "totallyClosed");
        agent.achieve("silence(0)");
        changes(agent, "totallyClosed", "closed");
        agent.notesNothingElse();
    }

    @Test
    void silence_messageComes_isHeardAtOnceAndForAWhile() {
        FakeBoard board = board();
        RunningAgent agent = open(board);
        agent.achieve("silence(20)");
        changes(agent, "closed", "totallyClosed");
        stopCounting(board);
        board.receive("////", "ROMA", "tell;x");
        changes(agent, "totallyClosed", "closed");
        goOnCounting(board);
        changes(agent, "closed", "totallyClosed");
    }

    @Test
    void silence_messageIsDelivered_isHeard() {
        FakeBoard board = board().endAll(Outcome.DELIVERED);
        RunningAgent agent = open(board);
        agent.achieve("silence(20)");
        changes(agent, "closed", "totallyClosed");
        stopCounting(board);
        agent.achieve("send");
        changes(agent, "totallyClosed", "closed");
    }

    @Test
    void silence_messageIsUndelivered_isNotHeard() {
        FakeBoard board = board().endAll(Outcome.UNDELIVERED);
        String program = PROGRAM + "+undelivered(_,_,_) <- diffuser.note(undelivered).";
        RunningAgent agent = RunningAgent.run(program.formatted(".getRFMessages(open)"), board);
        agent.notesAll("totallyClosed", "no totallyClosed", "closed", "ready");
        agent.achieve("silence(20)");
        changes(agent, "closed", "totallyClosed");
        agent.achieve("send");
        agent.notes("undelivered");
        agent.notesNothingElse();
    }

    @Test
    void silence_boardHasNoCounters_isReportedAndMeansNothing() {
        FakeBoard board = board().refuse("statistics", Status.UNKNOWN_COMMAND);
        RunningAgent agent = open(board);
        agent.achieve("silence(5)");
        agent.warns("cannot tell whether the radio hears anybody: statistics failed: UNKNOWN_COMMAND");
        agent.notesNothingElse();
    }

    @Test
    void silence_boardGoesAndComes_listensAnew() {
        FakeBoard board = board();
        RunningAgent agent = open(board);
        agent.achieve("silence(20)");
        changes(agent, "closed", "totallyClosed");
        stopCounting(board);
        board.port.unplug();
        board.port.plug();
        changes(agent, "totallyClosed", "closed");
        goOnCounting(board);
        changes(agent, "closed", "totallyClosed");
    }
}
