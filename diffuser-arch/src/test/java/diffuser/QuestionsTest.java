package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.List;

import diffuser.mind.Questions;

import javino.fake.FakeBoard;
import javino.protocol.Outcome;
import javino.protocol.Status;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** An agent's questions to other devices, and its use of their answers. */
class QuestionsTest {

    private static final String SPEED = "ROMA askOne;speed\\(\\w+\\)";

    private static final String PROGRAM = """
            !start.
            +!start <- .port(antenna); .setMyRFId("SUPO"); .getRFMessages(open); diffuser.note(ready).
            +!do <- %s; diffuser.note(done).
            -!do[error(E),error_msg(M)] <- diffuser.note(E,":",M).
            +speed(X)[source(S),cast(C,S)] <- diffuser.note(speed,X,S,C).
            -speed(X)[source(S)] <- diffuser.note(gone,X,S).
            +!other <- .port(missing).
            +!forget <- .drop_intention(do).
            +!probe <- diffuser.note(probed).
            +delivered(To,F,_)[source(percept)] <- diffuser.note(delivered,To,F).
            +undelivered(To,F,_)[source(percept),error(E)] <- diffuser.note(undelivered,To,F,E).
            """;

    private static RunningAgent ready(String action, FakeBoard board) {
        RunningAgent agent = RunningAgent.run(PROGRAM.formatted(action), board);
        agent.notes("ready");
        RunningAgent.asked(board, "id SUPO");
        RunningAgent.asked(board, "radio 1");
        return agent;
    }

    private static RunningAgent doing(String action, FakeBoard board) {
        RunningAgent agent = ready(action, board);
        agent.achieve("do");
        return agent;
    }

    private static FakeBoard board() {
        return new FakeBoard("antenna");
    }

    private static long refused(RunningAgent agent) throws Exception {
        return agent.diffuser().inbox().refused();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\0', value = {
            "askOne | speed(X)  | tell#%s;speed(80)              "
                    + "| speed(80)[cast(unicast,ROMA),peer(provisioned,ROMA),source(ROMA)]",
            "askOne | speed(X)  | tell#%s;80                     | 80",
            "askOne | speed(X)  | tell#%s;\"a\\\"b\"             | \"a\"b\"",
            "askOne | speed(X)  | untell#%s;speed(X)             | false",
            "askOne | speed(X)  | tell#%s;speed(8)[cast(unicast,'SUHO')] "
                    + "| speed(8)[cast(unicast,ROMA),peer(provisioned,ROMA),source(ROMA)]",
            "askAll | speed(X)  | tell#%s;[]                     | []",
            "askAll | speed(X)  | tell#%s;[speed(1),speed(2)[a]] "
                    + "| [speed(1)[cast(unicast,ROMA),peer(provisioned,ROMA),source(ROMA)],"
                    + "speed(2)[a,cast(unicast,ROMA),peer(provisioned,ROMA),source(ROMA)]]",
            "askHow | { +!go }  | tellHow#%s;[]                  | []",
            "askHow | { +!go }  | tellHow#%s;[{ @g +!go <- run }] | [{ @g[source(ROMA)] +!go <- run }]",
            "askHow | \"+!go\"  | tellHow#%s;[]                  | []",
    })
    void send_answerComes_intentionGoesOnWithIt(String performative, String question, String answer, String bound) {
        FakeBoard board = board();
        String action =
                ".send(\"ROMA\",%s,%s,A); .term2string(A,T); diffuser.note(T)".formatted(performative, question);
        RunningAgent agent = doing(action, board);
        String id = Conversing.asked(board, "ROMA " + performative + ";.*");
        board.receive("SUPO", "ROMA", answer.formatted(id));
        agent.notes(bound);
        agent.notes("done");
    }

    @Test
    void send_answerMatchesPattern_itsVariablesAreBound() {
        FakeBoard board = board();
        RunningAgent agent = doing(".send(\"ROMA\",askOne,speed(X),speed(V),9000); diffuser.note(V)", board);
        board.receive("SUPO", "ROMA", "tell#%s;speed(80)".formatted(Conversing.asked(board, SPEED)));
        agent.notes("80");
        agent.notes("done");
    }

    @ParameterizedTest
    @CsvSource({"9000,tell#%s;distance(7),7", "9000,untell#%s;distance(_),unknown", "20,,timeout"})
    void send_planForEachEnd_oneIsChosen(int timeout, String answer, String end) {
        FakeBoard board = board();
        String program = PROGRAM.formatted("!ask(D); diffuser.note(D)") + """
                +!ask(D) <- .send("ROMA", askOne, distance(_), A, %d); !got(A, D).
                +!got(timeout, timeout).
                +!got(false, unknown).
                +!got(distance(D), D).
                """.formatted(timeout);
        RunningAgent agent = RunningAgent.run(program, board);
        agent.notes("ready");
        RunningAgent.asked(board, "id SUPO");
        RunningAgent.asked(board, "radio 1");
        agent.achieve("do");
        String id = Conversing.asked(board, "ROMA askOne;distance\\(_\\w*\\)");
        if (answer != null) {
            board.receive("SUPO", "ROMA", answer.formatted(id));
        }
        agent.notes(end);
    }

    @Test
    void send_severalWait_eachGetsItsOwnAnswer() {
        FakeBoard board = board();
        String action = "!ask(1) |&| !ask(2)";
        RunningAgent agent = RunningAgent.run(PROGRAM.formatted(action)
                + "+!ask(N) <- .send(\"ROMA\",askOne,p(N,X),p(_,V)); diffuser.note(N,V).", board);
        agent.notes("ready");
        RunningAgent.asked(board, "id SUPO");
        RunningAgent.asked(board, "radio 1");
        agent.achieve("do");
        String first = Conversing.asked(board, "ROMA askOne;p\\(.*");
        String second = Conversing.asked(board, "ROMA askOne;p\\(.*");
        assertNotEquals(first, second);
        board.receive("SUPO", "ROMA", "tell#%s;p(0,b)".formatted(second));
        agent.notes("2 b");
        board.receive("SUPO", "ROMA", "tell#%s;p(0,a)".formatted(first));
        agent.notes("1 a");
        agent.notes("done");
    }

    @Test
    void send_listOfReceivers_answersAreCollected() {
        FakeBoard board = board();
        RunningAgent agent =
                doing(".send([\"ROMA\",\"SUHO\"],askOne,free,A); .length(A,N); diffuser.note(N)", board);
        String roma = Conversing.asked(board, "ROMA askOne;free");
        String suho = Conversing.asked(board, "SUHO askOne;free");
        board.receive("SUPO", "SUHO", "tell#%s;free".formatted(suho));
        agent.notesNothingElse();
        board.receive("SUPO", "ROMA", "untell#%s;free".formatted(roma));
        agent.notes("2");
        agent.notes("done");
    }

    @Test
    void send_answerFromElsewhereTwiceOrInAnotherForm_isRefusedAndCounted() throws Exception {
        FakeBoard board = board();
        RunningAgent agent = doing(".send(\"ROMA\",askOne,speed(X),speed(V)); diffuser.note(V)", board);
        String id = Conversing.asked(board, SPEED);
        board.receive("SUPO", "SUHO", "tell#%s;speed(1)".formatted(id));
        agent.warns("dropped tell from SUHO: it answers no question that is open");
        board.receive("//SU", "ROMA", "tell#%s;speed(2)".formatted(id));
        agent.warns("dropped tell from ROMA: an answer must come to the asker alone");
        board.receive("////", "ROMA", "tell#%s;speed(3)".formatted(id));
        board.receive("SUPO", "ROMA", "tell#%s;speed(4)".formatted(id.equals("AAA") ? "AAB" : "AAA"));
        agent.warns("dropped tell from ROMA: it answers no question that is open");
        agent.notesNothingElse();
        board.receive("SUPO", "ROMA", "tell#%s;speed(5)".formatted(id));
        agent.notes("5");
        agent.notes("done");
        board.receive("SUPO", "ROMA", "tell#%s;speed(6)".formatted(id));
        board.receive("SUPO", "ROMA", "tell;speed(7)");
        agent.notes("speed 7 ROMA unicast");
        assertEquals(5, refused(agent));
    }

    @Test
    void send_answerIsNoAgentSpeak_isDroppedAndTheQuestionStaysOpen() throws Exception {
        FakeBoard board = board();
        RunningAgent agent = doing(".send(\"ROMA\",askOne,speed(X),speed(V)); diffuser.note(V)", board);
        String id = Conversing.asked(board, SPEED);
        board.receive("SUPO", "ROMA", "tell#%s;speed(".formatted(id));
        board.receive("SUPO", "ROMA", "tell#%s;.stopMAS".formatted(id));
        agent.warns("\".stopMAS\": an internal action cannot be sent");
        board.receive("SUPO", "ROMA", "tell#%s;speed(5)".formatted(id));
        agent.notes("5");
        assertEquals(2L, agent.diffuser().inbox().malformed());
    }

    @Test
    void send_noAnswerInTime_isTimeoutAndALateOneIsRefused() throws Exception {
        FakeBoard board = board();
        RunningAgent agent = doing(".send(\"ROMA\",askOne,speed(X),A,20); diffuser.note(A)", board);
        String id = Conversing.asked(board, SPEED);
        agent.notes("timeout");
        agent.notes("done");
        board.receive("SUPO", "ROMA", "tell#%s;speed(1)".formatted(id));
        agent.warns("it answers no question that is open");
        agent.notesNothingElse();
        assertEquals(1, refused(agent));
    }

    @Test
    void send_undelivered_failsAtOnceAndALateAnswerIsRefused() throws Exception {
        FakeBoard board = board().endAll(Outcome.UNDELIVERED);
        RunningAgent agent = doing(".send(\"ROMA\",askOne,free,A)", board);
        String id = Conversing.asked(board, "ROMA askOne;free");
        agent.notes(
                "undelivered : askOne#" + id + ";free to ROMA was not acknowledged: its receiver is out of reach"
                        + " or a board was lost; it may have arrived all the same");
        board.receive("SUPO", "ROMA", "tell#%s;free".formatted(id));
        agent.warns("it answers no question that is open");
        agent.notesNothingElse();
        assertEquals(0, agent.body().getTS().getC().getPendingIntentions().size());
    }

    @Test
    void send_undeliveredWithTimeout_answerMayStillCome() {
        FakeBoard board = board();
        RunningAgent agent = doing(".send(\"ROMA\",askOne,free,A,9000); diffuser.note(A)", board);
        String id = Conversing.asked(board, "ROMA askOne;free");
        board.end("ROMA askOne#" + id + ";free", Outcome.UNDELIVERED);
        agent.notesNothingElse();
        board.receive("SUPO", "ROMA", "untell#%s;free".formatted(id));
        agent.notes("false");
    }

    @Test
    void send_answerOvertakesUndelivered_goesOnOnce() {
        FakeBoard board = board();
        RunningAgent agent = doing(".send(\"ROMA\",askOne,free,A)", board);
        String id = Conversing.asked(board, "ROMA askOne;free");
        board.receive("SUPO", "ROMA", "untell#%s;free".formatted(id));
        agent.notes("done");
        board.end("ROMA askOne#" + id + ";free", Outcome.UNDELIVERED);
        agent.notesNothingElse();
    }

    @Test
    void send_anotherPortIsOpenedMeanwhile_undelivered() {
        FakeBoard board = board();
        RunningAgent agent = doing(".send(\"ROMA\",askOne,free,A)", board);
        Conversing.asked(board, "ROMA askOne;free");
        agent.notesNothingElse();
        agent.achieve("other");
        assertEquals("undelivered", agent.nextNote().split(" ")[0]);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", ",9000"})
    void send_boardIsAway_failsWithPortOff(String timeout) {
        FakeBoard board = board().unplug();
        String program = PROGRAM.formatted(".send(\"ROMA\",askOne,free,A" + timeout + ")");
        RunningAgent agent = RunningAgent.run(program, board);
        agent.notes("ready");
        agent.achieve("do");
        assertEquals("port_off", agent.nextNote().split(" ")[0]);
        assertEquals(0, agent.body().getTS().getC().getPendingIntentions().size());
    }

    @ParameterizedTest
    @CsvSource({"NO_KEY,no_key", "QUEUE_FULL,queue_full"})
    void send_boardRefuses_failsWithItsErrorEvenWithATimeout(Status status, String error) {
        FakeBoard board = board().refuse("ROMA ", status);
        RunningAgent agent = doing(".send(\"ROMA\",askOne,free,A,9000)", board);
        assertEquals(error, agent.nextNote().split(" ")[0]);
        agent.notesNothingElse();
    }

    @Test
    void send_oneOfManyRefused_failsAndNothingWaits() {
        FakeBoard board = board();
        RunningAgent agent = doing(".send([\"ROMA\",nobody],askOne,free,A)", board);
        String note = agent.nextNote();
        assertEquals(true, note.contains("Receiver 'nobody' does not exist"), note);
        assertEquals(0, agent.body().getTS().getC().getPendingIntentions().size());
    }

    @Test
    void send_otherCannotAnswer_failsAndSaysWhy() {
        FakeBoard board = board();
        RunningAgent agent = doing(".send(\"ROMA\",askAll,speed(_),A)", board);
        String id = Conversing.asked(board, "ROMA askAll;.*");
        board.receive("SUPO", "ROMA",
                "sorry#%s;\"a content has at most 494 bytes of UTF-8, not 600\"".formatted(id));
        String note = agent.nextNote();
        assertEquals(true, note.startsWith("no_answer : ROMA cannot answer askAll#" + id + ";speed(")
                && note.endsWith("): a content has at most 494 bytes of UTF-8, not 600"), note);
    }

    @Test
    void send_questionIsTooLong_failsWithBothLengthsAndNothingWaits() {
        FakeBoard board = board();
        RunningAgent agent = doing(".send(\"ROMA\",askOne,p(\"" + "x".repeat(600) + "\"),A)", board);
        agent.notes("too_long : a content has at most 494 bytes of UTF-8, not 616");
        assertEquals(0, agent.body().getTS().getC().getPendingIntentions().size());
    }

    @ParameterizedTest
    @ValueSource(strings = {"\"1 s\"", "soon", "[1]", "{ +!g <- x }", "T"})
    void send_timeoutThatIsNoNumber_failsAlone(String timeout) throws Exception {
        FakeBoard board = board();
        String action = ".send(\"ROMA\",askOne,speed(_),A," + timeout + ")";
        RunningAgent agent = RunningAgent.run(PROGRAM.formatted(action) + "+!hold <- .wait(held); diffuser.note(held).",
                board);
        agent.notes("ready");
        RunningAgent.asked(board, "id SUPO");
        RunningAgent.asked(board, "radio 1");
        agent.achieve("hold");
        agent.achieve("do");
        String note = agent.nextNote();
        assertEquals(true, note.startsWith("wrong_arguments : .send waits for milliseconds, a number, not "), note);
        assertEquals(0, agent.body().getTS().getC().getPendingIntentions().keySet().stream()
                .filter(id -> !id.contains("wait")).count());
        assertEquals(List.of(), List.copyOf(board.requests));
        agent.believe("held");
        agent.notes("held");
    }

    @Test
    void send_timeoutInAVariable_isTaken() {
        FakeBoard board = board();
        RunningAgent agent = doing("T = 20; .send(\"ROMA\",askOne,speed(_),A,T + 1); diffuser.note(A)", board);
        Conversing.asked(board, SPEED);
        agent.notes("timeout");
    }

    @Test
    void send_timeoutThatIsNoNumberToAnAgentHere_failsAlone() {
        RunningAgent other = RunningAgent.run("speed(80).", new FakeBoard("other"));
        FakeBoard board = board();
        RunningAgent agent = doing(".send(" + other.name() + ",askOne,speed(_),A,\"1 s\")", board);
        String note = agent.nextNote();
        assertEquals(true, note.startsWith("wrong_arguments : .send waits for milliseconds"), note);
        agent.notesNothingElse();
    }

    /** Jason fails the question after it has asked the first device, and goes on to wait for its answer. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"tell#%s;speed(80)", "untell#%s;speed(80)", "sorry#%s;\"no\"", "UNDELIVERED"})
    void send_listThatHoldsNoNameToo_failsAndNothingElse(String answer) throws Exception {
        FakeBoard board = board();
        RunningAgent agent = RunningAgent.run(PROGRAM.formatted(".send([\"ROMA\",3],askOne,speed(_),A)")
                .replace("diffuser.note(E,\":\",M).", "diffuser.note(failed); .wait(held); diffuser.note(held)."),
                board);
        agent.notes("ready");
        RunningAgent.asked(board, "id SUPO");
        RunningAgent.asked(board, "radio 1");
        agent.achieve("do");
        String id = Conversing.asked(board, SPEED);
        agent.notes("failed");
        if (answer.equals("UNDELIVERED")) {
            board.endLast(Outcome.UNDELIVERED);
        } else {
            board.receive("SUPO", "ROMA", answer.formatted(id));
            agent.warns("it answers no question that is open");
        }
        agent.notesNothingElse();
        agent.believe("held");
        agent.notes("held");
    }

    @ParameterizedTest
    @ValueSource(strings = {"//SU", "SU\\\\"})
    void send_groupAndAnswerAwaited_fails(String group) {
        FakeBoard board = board();
        RunningAgent agent = doing(".send(\"" + group + "\",askOne,free,A)", board);
        agent.notes(
                "wrong_arguments : an answer can be awaited from one device, not from //SU; without the argument"
                        + " for it, each answer comes as a belief");
        assertEquals(0, agent.body().getTS().getC().getPendingIntentions().size());
    }

    @ParameterizedTest
    @ValueSource(strings = {"askOne,free", "askAll,free", "askHow,{ +!go }", "tellHow,{ +!go <- run }", "untellHow,go"})
    void diffuse_toAllWhatNobodyTakesUnsealed_fails(String what) {
        FakeBoard board = board();
        RunningAgent agent = doing(".diffuse(broadcast," + what + ")", board);
        agent.notes("not_sealed : " + what.split(",")[0]
                + " goes to a device or a group, not to all: no agent accepts it"
                + " from a broadcast, which anyone can send in anyone's name");
    }

    @ParameterizedTest
    @ValueSource(strings = {".send(\"ROMA\",askOne,speed(X))", ".diffuse(\"ROMA\",askOne,speed(X))",
            ".deliver(\"ROMA\",askOne,speed(X))"})
    void ask_withoutWaiting_answerIsBelievedOnceOrTakenBack(String action) throws Exception {
        FakeBoard board = board();
        RunningAgent agent = doing(action + "; .wait(speed(_))", board);
        String id = Conversing.asked(board, SPEED);
        board.receive("SUPO", "SUHO", "tell#%s;speed(1)".formatted(id));
        agent.warns("it answers no question that is open");
        if (action.startsWith(".deliver")) {
            board.endLast(Outcome.DELIVERED);
        }
        board.receive("SUPO", "ROMA", "tell#%s;speed(80)".formatted(id));
        agent.notesAll("speed 80 ROMA unicast", "done");
        board.receive("SUPO", "ROMA", "tell#%s;speed(90)".formatted(id));
        agent.notesNothingElse();
        assertEquals(2, refused(agent));
        agent.achieve("do");
        board.receive("SUPO", "ROMA", "untell#%s;speed(80)".formatted(Conversing.asked(board, SPEED)));
        assertEquals(true, List.of("gone 80 ROMA", "done").contains(agent.nextNote()));
    }

    @Test
    void ask_group_eachMemberAnswersOnceAndIsNoMoreThanAGroupsWord() throws Exception {
        FakeBoard board = board();
        RunningAgent agent = doing(".diffuse(\"//SU\",askOne,speed(X))", board);
        String id = Conversing.asked(board, "//SU askOne;.*");
        agent.notes("done");
        board.receive("SUPO", "SUHO", "tell#%s;speed(1)".formatted(id));
        agent.notes("speed 1 SUHO multicast");
        board.receive("SUPO", "SUAM", "tell#%s;speed(2)".formatted(id));
        agent.notes("speed 2 SUAM multicast");
        board.receive("SUPO", "SUHO", "tell#%s;speed(3)".formatted(id));
        board.receive("SUPO", "ROMA", "tell#%s;speed(4)".formatted(id));
        agent.warns("dropped tell from SUHO");
        agent.warns("dropped tell from ROMA");
        agent.notesNothingElse();
        assertEquals(2, refused(agent));
    }

    @Test
    void ask_manyWithoutWaiting_onlyTheLastAreRemembered() throws Exception {
        FakeBoard board = board();
        String action = "for (.range(I,1,%d)) { .diffuse(\"ROMA\",askOne,p(I)) }"
                .formatted(Questions.MOST_UNAWAITED + 1);
        RunningAgent agent = doing(action, board);
        String first = Conversing.asked(board, "ROMA askOne;p\\(1\\)");
        String second = Conversing.asked(board, "ROMA askOne;p\\(2\\)");
        agent.notes("done");
        board.receive("SUPO", "ROMA", "tell#%s;speed(1)".formatted(first));
        board.receive("SUPO", "ROMA", "tell#%s;speed(2)".formatted(second));
        agent.notes("speed 2 ROMA unicast");
        assertEquals(1, refused(agent));
    }

    @Test
    void ask_withoutWaitingAndOtherCannotAnswer_warns() {
        FakeBoard board = board();
        RunningAgent agent = doing(".send(\"ROMA\",askAll,speed(1))", board);
        board.receive("SUPO", "ROMA", "sorry#%s;\"bad_content\"".formatted(
                Conversing.asked(board, "ROMA askAll;.*")));
        agent.warns(";speed(1): bad_content");
    }

    @Test
    void send_intentionIsDroppedMeanwhile_answerIsRefused() throws Exception {
        FakeBoard board = board();
        RunningAgent agent = doing(".send(\"ROMA\",askOne,free,A)", board);
        String id = Conversing.asked(board, "ROMA askOne;free");
        agent.achieve("forget");
        agent.notesNothingElse();
        board.receive("SUPO", "ROMA", "tell#%s;free".formatted(id));
        agent.warns("it answers no question that is open");
        agent.notesNothingElse();
        assertEquals(1, refused(agent));
    }

    @Test
    void send_inAnAtomicPlan_failureAndAnswerGoOn() {
        FakeBoard board = board().endAll(Outcome.UNDELIVERED);
        String program = PROGRAM.formatted("true") + """
                @a[atomic] +!atomic <- .send("ROMA",askOne,free,A); diffuser.note(A).
                -!atomic[error(E)] <- diffuser.note(E).
                """;
        RunningAgent agent = RunningAgent.run(program, board);
        agent.notes("ready");
        agent.achieve("atomic");
        agent.notes("undelivered");
        agent.notesNothingElse();
    }
}
