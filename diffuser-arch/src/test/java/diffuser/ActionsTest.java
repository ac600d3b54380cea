package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;

import javino.fake.FakeBoard;
import javino.protocol.Status;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ActionsTest {

    private static String program(String action) {
        return """
                !start.
                +!start <- .port(body); !do.
                +!do <- %s; diffuser.note(done).
                -!do[error(port_off),error_msg(M)] <- diffuser.note(port_off,M).
                -!do[error(unknown_action),error_msg(M)] <- diffuser.note(unknown_action,M).
                -!do[error(no_internal_action),error_msg(M)] <- diffuser.note(no_internal_action,M).
                -!do[error(action_failed),error_msg(M)] <- diffuser.note(action_failed,M).
                -!do[error(outcome_unknown)] <- diffuser.note(outcome_unknown).
                """.formatted(action);
    }

    private static RunningAgent withEnvironment(String program, FakeBoard board) throws Exception {
        return RunningAgent.run(program, RunningAgent.environment(), List.of(ScriptedDiffuser.class.getName()), board);
    }

    @Test
    void act_boardKnowsIt_performedAndIntentionGoesOn() {
        FakeBoard board = new FakeBoard("body");
        RunningAgent agent = RunningAgent.run(program(".act(speed(80,\"km/h\")[source(self)])"), board);
        RunningAgent.asked(board, "act speed(80,\"km/h\")");
        agent.notes("done");
    }

    @Test
    void act_asString_sentAsItIs() {
        FakeBoard board = new FakeBoard("body");
        RunningAgent agent = RunningAgent.run(program(".act(\"speed( 80 )\")"), board);
        RunningAgent.asked(board, "act speed( 80 )");
        agent.notes("done");
    }

    @Test
    void act_boardRefuses_failsWithItsError() {
        FakeBoard board = new FakeBoard("body").refuse("act fly", Status.UNKNOWN_ACTION)
                .refuse("act jump", Status.ACTION_FAILED);
        RunningAgent agent = RunningAgent.run(program(".act(fly)"), board);
        agent.notes("unknown_action act fly failed: UNKNOWN_ACTION, the sketch has no action of this name");
        agent.close();
        RunningAgent.run(program(".act(jump)"), board)
                .notes("action_failed act jump failed: ACTION_FAILED, the sketch refused the action or its arguments");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\0',
            value = {"locked | locked", "too_far(3, [\"m\"]) | too_far(3,[\"m\"])",
                    "-470.5 | -470.5", "Stuck | \"Stuck\"", "door is locked | \"door is locked\"", "p(X) | \"p(X)\"",
                    "x[source(self)] | x", "kqml_received(a,b,c,d) | \"kqml_received(a,b,c,d)\"", "a\u202eb | \"a b\""})
    void act_refusedWithAReason_plansGetItAsATermOrAString(String printed, String reason) {
        FakeBoard board = new FakeBoard("body").setActions("open").refuseAction("open", printed);
        for (String action : List.of(".act(open)", "open")) {
            RunningAgent agent = RunningAgent.run("""
                    !start.
                    +!start <- .port(body); !do.
                    +!do <- %s.
                    -!do[error(action_failed),reason(R),error_msg(M)] : .term2string(R,T)
                        <- diffuser.note(T); diffuser.note(M).
                    """.formatted(action), board);
            agent.notes(reason);
            agent.notes("act open failed: ACTION_FAILED, the sketch refused the action or its arguments; it says: "
                    + printed);
            agent.close();
        }
    }

    @Test
    void act_refusedWithoutAReason_plansWithOneAreNotForIt() {
        FakeBoard board = new FakeBoard("body").refuse("act open", Status.ACTION_FAILED);
        RunningAgent.run("""
                !start.
                +!start <- .port(body); !do.
                +!do <- .act(open).
                -!do[reason(R)] <- diffuser.note(R).
                -!do <- diffuser.note(none).
                """, board).notes("none");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '~', value = {
            ".act(distance,D); diffuser.note(D) ~ -470", ".act(distance,-470) ~ done",
            ".act(\"distance\",-469-1) ~ done",
            ".act(distance,_) ~ done", ".act(distance) ~ done", ".act(distance,D); .act(distance,D) ~ done",
            ".act(distance,5) ~ no_match the action returned -470, not 5",
            ".act(measure(3),D); diffuser.note(D) ~ 8388607",
            ".act(measure(3),D); .act(distance,D) ~ no_match the action returned -470, not 8388607",
            ".act(lampOn,D) ~ no_value act lampOn was performed, and returned no number of 24 bits; to return one, its "
                    + "function in the sketch calls number() of a JavinoResult",
            ".act(distance,d) ~ wrong_arguments Wrong argument for internal action 'act': a variable or a number was "
                    + "expected, not 'd'."})
    void act_numberIsAskedFor_isBoundOrMustMatch(String steps, String noted) {
        FakeBoard board = new FakeBoard("body").returns("distance", -470).returns("measure(3)", 8388607);
        RunningAgent.run("""
                !start.
                +!start <- .port(body); !do.
                +!do <- %s; diffuser.note(done).
                -!do[error(E),error_msg(M)] <- diffuser.note(E,M).
                """.formatted(steps), board).notes(noted);
    }

    @Test
    void act_boardGoesWhileANumberIsAwaited_outcomeUnknown() {
        FakeBoard board = new FakeBoard("body").returns("distance", 5);
        board.swallow("act distance");
        RunningAgent agent = RunningAgent.run(program(".act(distance,D)"), board);
        RunningAgent.asked(board, "act distance");
        board.port.unplug();
        agent.notes("outcome_unknown");
    }

    @ParameterizedTest
    @ValueSource(strings = {"actt(lampOn)", "akt(lampOn)"})
    void internalAction_nameMisspelt_namesTheNearest(String call) {
        RunningAgent.run(program("." + call), new FakeBoard("body"))
                .notes("no_internal_action there is no internal action ." + call.replace("(lampOn)", "")
                        + "; did you mean .act?");
    }

    @Test
    void internalAction_nameLikeNone_namesNone() {
        RunningAgent.run(program(".switch_the_lamp(on)"), new FakeBoard("body"))
                .notes("no_internal_action there is no internal action .switch_the_lamp");
    }

    @Test
    void act_boardIsAway_failsWithPortOff() {
        RunningAgent agent = RunningAgent.run(program(".act(stop)"), new FakeBoard("body").unplug());
        agent.notes("port_off act stop was not performed: body: there is no such port");
    }

    @Test
    void act_boardGoesMeanwhile_outcomeUnknown() {
        FakeBoard board = new FakeBoard("body");
        String program =
                "!start. +!start <- .port(body); diffuser.note(ready). +!do <- .act(stop); diffuser.note(done)."
                        + "-!do[error(E)] <- diffuser.note(E).";
        RunningAgent agent = RunningAgent.run(program, board);
        agent.notes("ready");
        board.swallow("act stop");
        agent.achieve("do");
        RunningAgent.asked(board, "act stop");
        board.port.unplug();
        agent.notes("outcome_unknown");
    }

    @Test
    void act_plainAction_goesToTheBoard() {
        FakeBoard board = new FakeBoard("body").refuse("act jump", Status.ACTION_FAILED);
        RunningAgent agent = RunningAgent.run(program("stop; jump"), board);
        RunningAgent.asked(board, "act stop");
        RunningAgent.asked(board, "act jump");
        agent.notes("action_failed act jump failed: ACTION_FAILED, the sketch refused the action or its arguments");
    }

    @Test
    void act_plainActionNobodyKnows_failsWithUnknownAction() {
        FakeBoard board = new FakeBoard("body").refuse("act fly", Status.UNKNOWN_ACTION);
        RunningAgent agent = RunningAgent.run(program("fly"), board);
        agent.notes("unknown_action act fly failed: UNKNOWN_ACTION, the sketch has no action of this name");
    }

    @Test
    void act_plainActionWhileBoardIsAwayAndNothingElse_failsWithPortOff() {
        RunningAgent agent = RunningAgent.run(program("stop"), new FakeBoard("body").unplug());
        agent.notes("port_off act stop was not performed: body: there is no such port");
    }

    @Test
    void act_plainActionOfTheEnvironment_isNeverAskedOfTheBoard() throws Exception {
        FakeBoard board = new FakeBoard("body").setActions("stop");
        RunningAgent agent = withEnvironment(program("paint(red); paint(blue); stop; stop(now)"), board);
        agent.notes("environment paint(red)");
        agent.notes("environment paint(blue)");
        agent.notes("done");
        RunningAgent.asked(board, "act stop");
        RunningAgent.asked(board, "act stop(now)");
    }

    @Test
    void act_plainActionsBeforeItIsKnownWhetherABoardIsThere_wait() throws Exception {
        FakeBoard former = new FakeBoard("former");
        FakeBoard board = new FakeBoard("body").setActions("stop");
        RunningAgent agent = RunningAgent.run("""
                !start.
                +!start <- .port(former); diffuser.note(ready).
                +!change <- .port(body).
                +!halt <- stop; diffuser.note(halted).
                +!draw <- paint(red); diffuser.note(drawn).
                """, RunningAgent.environment(), List.of(ScriptedDiffuser.class.getName()), former, board);
        agent.notes("ready");
        former.port.blockClosing(true);
        agent.achieve("change");
        former.port.awaitClosing();
        agent.achieve("halt");
        agent.achieve("draw");
        agent.cycles(5);
        former.port.blockClosing(false);
        RunningAgent.asked(board, "act stop");
        agent.notesAll("halted", "environment paint(red)", "drawn");
    }

    @Test
    void act_plainActionWhereNoBoardIs_goesToTheEnvironmentAndTheLogNamesThePort() throws Exception {
        RunningAgent agent = RunningAgent.run(program("paint(red)"), RunningAgent.environment(),
                List.of(ScriptedDiffuser.class.getName()));
        agent.notesAll("environment paint(red)", "done");
        agent.warns("no board has answered on body yet");
    }

    @Test
    void act_plainActionWhereNoBoardIsAndTheEnvironmentFails_failureNamesThePort() throws Exception {
        RunningAgent agent = RunningAgent.run(program("stop"), RunningAgent.environment(),
                List.of(ScriptedDiffuser.class.getName()));
        agent.notes("action_failed no board has answered on body yet");
    }

    @Test
    void act_plainActionWithAVariable_goesToTheEnvironment() throws Exception {
        FakeBoard board = new FakeBoard("body").setActions("paint", "stop");
        RunningAgent agent = withEnvironment(program("paint(Colour); stop"), board);
        agent.notes("environment paint(Colour)");
        agent.notes("done");
        RunningAgent.asked(board, "act stop");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"artifact_id(7)", "aid(7)", "artifact_name(\"easel\")", "art(easel)", "wid(7)", "wsp(studio)",
                    "source(self),wsp(studio)"})
    void act_plainActionThatNamesAnArtifact_goesToTheEnvironmentWhateverTheBoardHas(String annotations)
            throws Exception {
        FakeBoard board = new FakeBoard("body").setActions("paint");
        RunningAgent agent = withEnvironment(program("paint(red)[" + annotations + "]; paint(blue)"), board);
        agent.notes("environment paint(red)[" + annotations + "]");
        agent.notes("done");
        RunningAgent.asked(board, "act paint(blue)");
    }

    @Test
    void act_plainActionWithAnotherAnnotation_goesToTheBoard() throws Exception {
        FakeBoard board = new FakeBoard("body").setActions("paint");
        RunningAgent agent = withEnvironment(program("paint(red)[fast,colour(red)]"), board);
        RunningAgent.asked(board, "act paint(red)");
        agent.notes("done");
    }

    @Test
    void act_plainActionOfAnArtifactAndNothingBehind_fails() {
        FakeBoard board = new FakeBoard("body").setActions("paint");
        RunningAgent agent = RunningAgent.run(program("paint(red)[art(easel)]"), board);
        agent.notes("action_failed no environment configured!");
        assertEquals(0, board.requests.size());
    }

    @ParameterizedTest
    @ValueSource(strings = {"~paint(red)", "studio::paint(red)"})
    void act_plainActionOfANameThatNoSketchCanHave_goesToTheEnvironment(String action) throws Exception {
        FakeBoard board = new FakeBoard("body").setActions("paint");
        RunningAgent agent = withEnvironment(program(action), board);
        agent.notes("environment " + action);
        agent.notes("done");
        assertEquals(0, board.requests.size());
    }

    @Test
    void act_plainActionLongerThanABoardReads_failsWhereItIsTheBoards() throws Exception {
        String picture = "x".repeat(600);
        String program = program("paint(\"" + picture + "\")");
        RunningAgent agent = withEnvironment(program, new FakeBoard("body").setActions("paint"));
        agent.notes("action_failed an action has 1…510 bytes of UTF-8, not 609");
        agent.close();
        RunningAgent other = withEnvironment(program, new FakeBoard("body"));
        other.notes("environment paint(\"" + picture + "\")");
        other.notes("done");
    }

    @Test
    void act_plainActionThatTheBoardCannotRead_failsWithItsError() throws Exception {
        FakeBoard board = new FakeBoard("body").setActions("paint").refuse("act paint(a(b(c)))", Status.BAD_ARGUMENT);
        RunningAgent agent = withEnvironment(program("paint(a(b(c)))"), board);
        agent.notes("action_failed act paint(a(b(c))) failed: BAD_ARGUMENT, " + Status.BAD_ARGUMENT.explanation());
    }

    @Test
    void act_noBoardHasAnsweredYet_goesToTheEnvironmentWithOneWarning() throws Exception {
        RunningAgent agent = withEnvironment(program("paint(red); paint; paint(blue)"),
                new FakeBoard("body").setActions("paint").unplug());
        agent.notes("environment paint(red)");
        agent.notes("environment paint");
        agent.notes("environment paint(blue)");
        agent.notes("done");
        assertEquals(List.of("the board is off: body: there is no such port",
                "no board has answered on body yet: plain actions go to the environment until one has"),
                List.copyOf(agent.warnings));
    }

    private static final String OUTAGE = """
            !start.
            +!start <- .port(body); diffuser.note(ready); .wait(port(_,off)); diffuser.note(off);
                .wait(port(_,on)); diffuser.note(back).
            +!paint <- paint(red); diffuser.note(painted).
            +!do <- stop; diffuser.note(done).
            """;

    private static RunningAgent inAnOutage(FakeBoard board) throws Exception {
        return inAnOutage(board, "-!do[error(port_off)] <- diffuser.note(port_off).");
    }

    private static RunningAgent inAnOutage(FakeBoard board, String plan) throws Exception {
        RunningAgent agent = withEnvironment(OUTAGE + plan, board);
        agent.notes("ready");
        board.port.unplug();
        agent.warns("the board is off");
        agent.notes("off");
        return agent;
    }

    @Test
    void act_boardIsAway_actionOfTheEnvironmentGoesThereAndNobodyIsWarned() throws Exception {
        RunningAgent agent = inAnOutage(new FakeBoard("body").setActions("stop", "go"));
        for (int i = 0; i < 3; i++) {
            agent.achieve("paint");
            agent.notes("environment paint(red)");
            agent.notes("painted");
        }
        assertEquals(List.of(), agent.warnings.stream().filter(line -> line.contains("environment")).toList());
    }

    @Test
    void act_boardIsAway_itsOwnActionFailsWithPortOffWhateverIsBehind() throws Exception {
        RunningAgent agent = inAnOutage(new FakeBoard("body").setActions("stop"));
        agent.achieve("do");
        agent.notes("port_off");
    }

    @Test
    void act_boardComesBack_performsItsAction() throws Exception {
        FakeBoard board = new FakeBoard("body").setActions("stop");
        RunningAgent agent = inAnOutage(board, "-!do[error(port_off)] <- !do.");
        agent.achieve("do");
        board.port.plug();
        RunningAgent.asked(board, "act stop");
        agent.notesAll("back", "done");
    }

    @Test
    void act_boardComesBackWithAnotherSketch_itsNamesCount() throws Exception {
        FakeBoard board = new FakeBoard("body").setActions("stop");
        RunningAgent agent = inAnOutage(board);
        board.setActions("paint").reset();
        board.port.plug();
        agent.notes("back");
        agent.achieve("paint");
        RunningAgent.asked(board, "act paint(red)");
        agent.notes("painted");
    }

    @Test
    void act_noPort_goesToTheEnvironment() throws Exception {
        RunningAgent agent = withEnvironment("!do. +!do <- paint(red); diffuser.note(done).",
                new FakeBoard("body"));
        agent.notes("environment paint(red)");
        agent.notes("done");
    }

    @Test
    void act_atomicPlan_resumes() {
        FakeBoard board = new FakeBoard("body");
        String program = "!start. @x[atomic] +!start <- .port(body); .act(stop); stop; diffuser.note(done).";
        RunningAgent agent = RunningAgent.run(program, board);
        agent.notes("done");
    }

    @Test
    void act_intentionDroppedMeanwhile_nothingElseHappens() {
        FakeBoard board = new FakeBoard("body");
        String program =
                "!start. +!start <- .port(body); diffuser.note(ready). +!do <- .act(stop); diffuser.note(done)."
                        + "+!drop <- .drop_intention(do); diffuser.note(dropped).";
        RunningAgent agent = RunningAgent.run(program, board);
        agent.notes("ready");
        board.swallow("act stop");
        agent.achieve("do");
        RunningAgent.asked(board, "act stop");
        agent.achieve("drop");
        agent.notes("dropped");
        board.port.unplug();
        agent.warns("the board is off");
        agent.cycles(3);
        agent.achieve("drop");
        agent.notes("dropped");
    }
}
