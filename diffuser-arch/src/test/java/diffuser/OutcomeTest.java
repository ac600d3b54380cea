package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import javino.fake.FakeBoard;
import javino.protocol.Counter;
import javino.protocol.Outcome;
import javino.protocol.Status;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The outcomes that an agent hears of messages that it sent with {@code .diffuse} and {@code .send}. */
class OutcomeTest {

    /** Notes all that it hears, and that none of it is believed. */
    private static final String PROGRAM = """
            !start.
            +!start <- .port(antenna); .setMyRFId("SUPO"); diffuser.note(ready).
            +!do <- %s; diffuser.note(taken).
            +delivered(To,F,C)[source(percept)] : not delivered(_,_,_) <- diffuser.note(delivered,{To},F,C).
            +undelivered(To,F,C)[source(percept),error(E)] : not undelivered(_,_,_) <-
                diffuser.note(undelivered,{To},F,C,E).
            +!other <- .port(missing).
            +seen <- diffuser.note(seen).
            +!probe <- diffuser.note(probed).
            """.replace("{To}", "quoted(To)");

    private final FakeBoard board = new FakeBoard("antenna");

    private RunningAgent doing(String action) {
        RunningAgent agent = RunningAgent.run(PROGRAM.formatted(action), board);
        agent.notes("ready");
        RunningAgent.asked(board, "id SUPO");
        agent.achieve("do");
        return agent;
    }

    private RunningAgent taken(String action, String request) {
        RunningAgent agent = doing(action);
        RunningAgent.asked(board, request);
        agent.notes("taken");
        return agent;
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\0', value = {
            ".diffuse(\"ROMA\",tell,help)             | ROMA tell;help             | quoted(\"ROMA\") tell help",
            ".diffuse(bus1,untell,p(1,\"x y\"))       | bus1 untell;p(1,\"x y\")   | quoted(bus1) untell p(1,\"x y\")",
            ".diffuse(ROMA,achieve,go)                | ROMA achieve;go            | quoted(\"ROMA\") achieve go",
            "X=\"ROMA\"; .diffuse(X,unachieve,p(X)[a]) | ROMA unachieve;p(\"ROMA\")[a] | quoted(\"ROMA\") unachieve "
                    + "p(\"ROMA\")[a]",
            ".diffuse('ROMA',tell,[a,~b(2)])          | ROMA tell;[a,~b(2)]        | quoted('ROMA') tell [a,~b(2)]",
            ".send(\"ROMA\",tell,help)                | ROMA tell;help             | quoted(\"ROMA\") tell help",
            ".send(bus1,achieve,[a,b])                | bus1 achieve;[a,b]         | quoted(\"bus1\") achieve [a,b]",
    })
    void unicast_ended_isAnEventOfWhatWasGivenAndNoBelief(String action, String request, String event) {
        RunningAgent agent = taken(action, request);
        board.end(request, Outcome.DELIVERED);
        agent.notes("delivered " + event);
        agent.achieve("do");
        RunningAgent.asked(board, request);
        agent.notes("taken");
        board.end(request, Outcome.UNDELIVERED);
        agent.notes("undelivered " + event + " undelivered");
        agent.notesNothingElse();
    }

    @Test
    void unicast_undeliveredBySlowSketch_warnsOfWhatIsSlow() {
        board.setCounter(Counter.PERCEPTS_MILLIS, 250);
        RunningAgent agent = taken(".diffuse(ROMA,tell,help)", "ROMA tell;help");
        board.end("ROMA tell;help", Outcome.UNDELIVERED);
        agent.warns(
                "the sketch on antenna is slow, percepts: up to 250 ms passed in the sketch's function of percepts; "
                        + "read slow sensors in loop(), and tell what they said");
    }

    @Test
    void unicast_variableInIt_isOneInTheEventToo() {
        String request = "ROMA achieve;find(F)";
        RunningAgent agent = taken(".diffuse(\"ROMA\",achieve,find(F))", request);
        board.end(request, Outcome.DELIVERED);
        String note = agent.nextNote();
        assertTrue(note.startsWith("delivered quoted(\"ROMA\") achieve find(_"), note);
    }

    @Test
    void unicast_waitedFor_waitEnds() {
        String program = PROGRAM + """
                +!go <- !!do; .wait({+delivered("ROMA",tell,a)}); diffuser.note(waited).
                """;
        RunningAgent agent = RunningAgent.run(program.formatted(".diffuse(ROMA,tell,a)"), board);
        agent.notes("ready");
        agent.achieve("go");
        agent.notes("taken");
        board.end("ROMA tell;a", Outcome.DELIVERED);
        agent.notesAll("delivered quoted(\"ROMA\") tell a", "waited");
    }

    @Test
    void unicast_severalUnderWay_eachHasItsOwnOutcome() {
        String action = ".diffuse(ROMA,tell,a); .diffuse(SUHO,tell,a); .diffuse(ROMA,tell,b)";
        RunningAgent agent = doing(action);
        agent.notes("taken");
        board.end("ROMA tell;b", Outcome.UNDELIVERED);
        agent.notes("undelivered quoted(\"ROMA\") tell b undelivered");
        board.end("ROMA tell;a", Outcome.DELIVERED);
        agent.notes("delivered quoted(\"ROMA\") tell a");
        board.end("SUHO tell;a", Outcome.DELIVERED);
        agent.notes("delivered quoted(\"SUHO\") tell a");
    }

    @Test
    void unicast_moreThanThereAreNumbers_eachHasItsOwnOutcome() throws Exception {
        board.endAll(Outcome.DELIVERED);
        RunningAgent agent = doing("for (.range(I,1,300)) { .diffuse(ROMA,tell,p(I)) }");
        for (int i = 1, heard = 0; heard < 300; i++) {
            String note = agent.nextNote();
            if (!note.equals("taken")) {
                heard++;
                assertEquals("delivered quoted(\"ROMA\") tell p(" + heard + ")", note);
            }
            assertTrue(i <= 301);
        }
        assertEquals(300L, agent.diffuser().getStatus().get("rfDelivered"));
        assertEquals(0L, agent.diffuser().getStatus().get("rfUndelivered"));
    }

    @Test
    void unicast_outcomeOfNobodysMessage_isIgnored() {
        RunningAgent agent = taken(".diffuse(ROMA,tell,a)", "ROMA tell;a");
        board.end(200, Outcome.DELIVERED);
        agent.notesNothingElse();
    }

    @ParameterizedTest
    @CsvSource({"broadcast,////", "\"//SU\",//SU"})
    void unacknowledged_sent_isNoEvent(String to, String address) {
        RunningAgent agent = taken(".diffuse(" + to + ",tell,a)", address + " tell;a");
        board.end(address + " tell;a", Outcome.SENT);
        agent.notesNothingElse();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\0',
            value = {"\"ROMA\" | ROMA", "\"//SU\" | //SU", "broadcast | ////"})
    void underWay_boardIsReset_undelivered(String to, String address) {
        RunningAgent agent = taken(".diffuse(" + to + ",tell,a)", address + " tell;a");
        board.reset();
        agent.notes("undelivered quoted(" + to + ") tell a undelivered");
        agent.achieve("do");
        RunningAgent.asked(board, address + " tell;a");
        agent.notes("taken");
        board.end(address + " tell;a", Outcome.DELIVERED);
        agent.notes("delivered quoted(" + to + ") tell a");
    }

    @Test
    void underWay_anotherPortIsOpened_undelivered() {
        RunningAgent agent = taken(".diffuse(ROMA,tell,a)", "ROMA tell;a");
        agent.achieve("other");
        agent.notes("undelivered quoted(\"ROMA\") tell a undelivered");
    }

    @ParameterizedTest
    @CsvSource({
            "ROMA,ROMA,was not acknowledged: its receiver is out of reach or a board was lost",
            "broadcast,////,was not sent yet when the board was lost",
    })
    void undelivered_errorAndItsMessage_areAnnotations(String to, String address, String why) {
        board.endAll(Outcome.UNDELIVERED);
        String program = """
                !start.
                +!start <- .port(antenna); .setMyRFId("SUPO"); .diffuse(%s,tell,a).
                +undelivered(_,_,_)[error(E),error_msg(M)] <- diffuser.note(E,":",M).
                """.formatted(to);
        RunningAgent agent = RunningAgent.run(program, board);
        agent.notes("undelivered : tell;a to " + address + " " + why + "; it may have arrived all the same");
    }

    @Test
    void outcomes_agentHasNoPlansForThem_nothingIsBelievedNorLogged() throws Exception {
        board.endAll(Outcome.UNDELIVERED);
        String program = """
                !start.
                +!start <- .port(antenna); .setMyRFId("SUPO");
                    for (.range(I,1,50)) { .diffuse(ROMA,tell,p(I)); .send("ROMA",tell,q(I)) };
                    .deliver(ROMA,tell,last).
                -!start[error(undelivered)] <- diffuser.note(last).
                +!count <- .count(undelivered(_,_,_), N); diffuser.note(N).
                """;
        RunningAgent agent = RunningAgent.run(program, board);
        agent.notes("last");
        agent.achieve("count");
        agent.notes("0");
        assertEquals(101L, agent.diffuser().getStatus().get("rfUndelivered"));
        assertEquals(List.of(), List.copyOf(agent.warnings));
    }

    @Test
    void outcome_tellsTheAgentByRadio_isNotTheBodysWord() {
        RunningAgent agent = RunningAgent.run(PROGRAM.formatted(".getRFMessages(open)"), board);
        agent.notes("ready");
        agent.achieve("do");
        agent.notes("taken");
        board.receive("////", "ROMA", "tell;delivered(\"ROMA\",tell,a)");
        board.receive("////", "ROMA", "tell;delivered(\"ROMA\",tell,b)[source(percept)]");
        board.receive("////", "ROMA", "tell;[undelivered(\"ROMA\",tell,c)[source(percept),error(undelivered)]]");
        board.receive("////", "ROMA", "tell;seen");
        agent.notes("seen");
        agent.notesNothingElse();
    }

    @Test
    void send_refused_isAnEventWithItsError() {
        board.refuse("ROMA tell;help", Status.NO_KEY);
        RunningAgent agent = doing(".send(\"ROMA\",tell,help)");
        agent.notesAll("taken", "undelivered quoted(\"ROMA\") tell help no_key");
        agent.warns("transmit to ROMA: tell;help failed: NO_KEY");
    }

    @Test
    void send_toSeveral_eachHasItsOwnOutcome() {
        RunningAgent agent = doing(".send([\"ROMA\",\"SUHO\"],tell,a)");
        RunningAgent.asked(board, "ROMA tell;a");
        RunningAgent.asked(board, "SUHO tell;a");
        agent.notes("taken");
        board.end("SUHO tell;a", Outcome.UNDELIVERED);
        agent.notes("undelivered quoted(\"SUHO\") tell a undelivered");
        board.end("ROMA tell;a", Outcome.DELIVERED);
        agent.notes("delivered quoted(\"ROMA\") tell a");
    }

    @Test
    void diffuse_refused_failsThePlanAndIsNoEvent() {
        board.refuse("ROMA tell;a", Status.QUEUE_FULL);
        String program = PROGRAM + "-!do[error(E)] <- diffuser.note(failed,E).";
        RunningAgent agent = RunningAgent.run(program.formatted(".diffuse(ROMA,tell,a)"), board);
        agent.notes("ready");
        agent.achieve("do");
        agent.notes("failed queue_full");
        agent.notesNothingElse();
    }

    @Test
    void diffuse_longestContent_isTaken() {
        String longest = "a".repeat(494 - "tell;".length());
        RunningAgent agent = doing(".diffuse(ROMA,tell," + longest + ")");
        RunningAgent.asked(board, "ROMA tell;" + longest);
        agent.notes("taken");
        assertNull(note.of(agent.name()).peek());
    }
}
