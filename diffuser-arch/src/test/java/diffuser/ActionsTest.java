package diffuser;

import java.util.List;

import javino.protocol.Status;

import org.junit.jupiter.api.Test;

class ActionsTest {

    private static String program(String action) {
        return """
                !start.
                +!start <- .port(body); !do.
                +!do <- %s; diffuser.note(done).
                -!do[error(port_off)] <- diffuser.note(port_off).
                -!do[error(unknown_action),error_msg(M)] <- diffuser.note(unknown_action,M).
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
        try (RunningAgent agent = RunningAgent.run(program(".act(speed(80,\"km/h\")[source(self)])"), board)) {
            RunningAgent.asked(board, "A speed(80,\"km/h\")");
            agent.notes("done");
        }
    }

    @Test
    void act_asString_sentAsItIs() {
        FakeBoard board = new FakeBoard("body");
        try (RunningAgent agent = RunningAgent.run(program(".act(\"speed( 80 )\")"), board)) {
            RunningAgent.asked(board, "A speed( 80 )");
            agent.notes("done");
        }
    }

    @Test
    void act_boardRefuses_failsWithItsError() {
        FakeBoard board = new FakeBoard("body").refusing("A fly", Status.UNKNOWN_ACTION)
                .refusing("A jump", Status.ACTION_FAILED);
        try (RunningAgent agent = RunningAgent.run(program(".act(fly)"), board)) {
            agent.notes("unknown_action act fly failed: UNKNOWN_ACTION, the sketch has no action of this name");
        }
        try (RunningAgent agent = RunningAgent.run(program(".act(jump)"), board)) {
            agent.notes("action_failed act jump failed: ACTION_FAILED, the sketch refused the action or its arguments");
        }
    }

    @Test
    void act_boardIsAway_failsWithPortOff() {
        try (RunningAgent agent = RunningAgent.run(program(".act(stop)"), new FakeBoard("body").unplugged())) {
            agent.notes("port_off");
        }
    }

    @Test
    void act_boardGoesMeanwhile_outcomeUnknown() {
        FakeBoard board = new FakeBoard("body");
        String program = "!start. +!start <- .port(body); diffuser.note(ready). +!do <- .act(stop); diffuser.note(done)."
                + "-!do[error(E)] <- diffuser.note(E).";
        try (RunningAgent agent = RunningAgent.run(program, board)) {
            agent.notes("ready");
            board.swallow("A stop");
            agent.achieve("do");
            RunningAgent.asked(board, "A stop");
            board.unplug();
            agent.notes("outcome_unknown");
        }
    }

    @Test
    void act_plainAction_goesToTheBoard() {
        FakeBoard board = new FakeBoard("body").refusing("A jump", Status.ACTION_FAILED);
        try (RunningAgent agent = RunningAgent.run(program("stop; jump"), board)) {
            RunningAgent.asked(board, "A stop");
            RunningAgent.asked(board, "A jump");
            agent.notes("action_failed act jump failed: ACTION_FAILED, the sketch refused the action or its arguments");
        }
    }

    @Test
    void act_plainActionNobodyKnows_failsWithUnknownAction() {
        FakeBoard board = new FakeBoard("body").refusing("A fly", Status.UNKNOWN_ACTION);
        try (RunningAgent agent = RunningAgent.run(program("fly"), board)) {
            agent.notes("unknown_action act fly failed: UNKNOWN_ACTION, the sketch has no action of this name");
        }
    }

    @Test
    void act_plainActionWhileBoardIsAwayAndNothingElse_failsWithPortOff() {
        try (RunningAgent agent = RunningAgent.run(program("stop"), new FakeBoard("body").unplugged())) {
            agent.notes("port_off");
        }
    }

    @Test
    void act_plainActionOfTheEnvironment_askedOfTheBoardOnlyOnce() throws Exception {
        FakeBoard board = new FakeBoard("body").refusing("A paint(red)", Status.UNKNOWN_ACTION);
        try (RunningAgent agent = withEnvironment(program("paint(red); paint(blue); stop"), board)) {
            agent.notes("environment paint(red)");
            agent.notes("environment paint(blue)");
            agent.notes("done");
            RunningAgent.asked(board, "A paint(red)");
            RunningAgent.asked(board, "A stop");
        }
    }

    @Test
    void act_plainActionWithAVariable_goesToTheEnvironment() throws Exception {
        FakeBoard board = new FakeBoard("body");
        try (RunningAgent agent = withEnvironment(program("paint(Colour); stop"), board)) {
            agent.notes("environment paint(Colour)");
            agent.notes("done");
            RunningAgent.asked(board, "A stop");
        }
    }

    @Test
    void act_plainActionLongerThanABoardReads_goesToTheEnvironment() throws Exception {
        String picture = "x".repeat(600);
        try (RunningAgent agent = withEnvironment(program("paint(\"" + picture + "\")"), new FakeBoard("body"))) {
            agent.notes("environment paint(\"" + picture + "\")");
            agent.notes("done");
        }
    }

    @Test
    void act_plainActionThatTheBoardCannotRead_goesToTheEnvironmentAndTheNextOneToTheBoard() throws Exception {
        FakeBoard board = new FakeBoard("body").refusing("A paint(a(b(c)))", Status.BAD_ARGUMENT);
        try (RunningAgent agent = withEnvironment(program("paint(a(b(c))); paint(red)"), board)) {
            agent.notes("environment paint(a(b(c)))");
            agent.notes("done");
            RunningAgent.asked(board, "A paint(a(b(c)))");
            RunningAgent.asked(board, "A paint(red)");
        }
    }

    @Test
    void act_plainActionWhileBoardIsAway_goesToTheEnvironment() throws Exception {
        try (RunningAgent agent = withEnvironment(program("paint(red)"), new FakeBoard("body").unplugged())) {
            agent.notes("environment paint(red)");
            agent.notes("done");
            agent.warns("the board on body is off: paint goes to the environment");
        }
    }

    @Test
    void act_noPort_goesToTheEnvironment() throws Exception {
        try (RunningAgent agent = withEnvironment("!do. +!do <- paint(red); diffuser.note(done).",
                new FakeBoard("body"))) {
            agent.notes("environment paint(red)");
            agent.notes("done");
        }
    }

    @Test
    void act_atomicPlan_resumes() {
        FakeBoard board = new FakeBoard("body");
        String program = "!start. @x[atomic] +!start <- .port(body); .act(stop); stop; diffuser.note(done).";
        try (RunningAgent agent = RunningAgent.run(program, board)) {
            agent.notes("done");
        }
    }

    @Test
    void act_intentionDroppedMeanwhile_nothingElseHappens() {
        FakeBoard board = new FakeBoard("body");
        String program = "!start. +!start <- .port(body); diffuser.note(ready). +!do <- .act(stop); diffuser.note(done)."
                + "+!drop <- .drop_intention(do); diffuser.note(dropped).";
        try (RunningAgent agent = RunningAgent.run(program, board)) {
            agent.notes("ready");
            board.swallow("A stop");
            agent.achieve("do");
            RunningAgent.asked(board, "A stop");
            agent.achieve("drop");
            agent.notes("dropped");
            board.unplug();
            agent.warns("the board is off");
            agent.cycles(3);
            agent.achieve("drop");
            agent.notes("dropped");
        }
    }
}
