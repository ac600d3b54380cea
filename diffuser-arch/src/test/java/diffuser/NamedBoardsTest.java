package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;

import javino.fake.FakeBoard;
import javino.protocol.Bytes;
import javino.protocol.Capability;
import javino.protocol.Status;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Boards beside the main one: the forms of docs/reference.md. */
class NamedBoardsTest {

    private static final String PROGRAM = """
            !start.
            +!start <- .port(body); .port(crane, arm); %s; !note.
            +!note <- .findall(L,light(L),Body); .findall(L,arm(light(L)),Arm); .findall(H,arm(heat(H)),Heat);
                .count(port(_,on),Ports); diffuser.note(Body,Arm,Heat,Ports).
            -!start[error(E),error_msg(M)] <- diffuser.note(E,":",M).
            """;

    private final FakeBoard body = new FakeBoard("body").perceive("light(1)").setActions("stop");
    private final FakeBoard arm = new FakeBoard("crane").perceive("light(2)", "heat(3)").setActions("close")
            .setCapabilities(Capability.SAYS_TAKEN);

    private RunningAgent run(String steps) {
        return RunningAgent.run(PROGRAM.formatted(steps), body, arm);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '#', quoteCharacter = '\0', value = {
            ".percepts(open)                                       # [1] [2] [3] 2",
            ".percepts(open); .percepts(arm, block)                # [1] [] [] 2",
            ".percepts(arm, open)                                  # [] [2] [3] 2",
            ".percepts(open); .filter(only, light(_))              # [] [] [3] 2",
            ".percepts(open); .filter(arm, only, light(_))         # [1] [] [3] 2",
            ".percepts(open); .filter(arm, only, light(X), X > 2)  # [1] [2] [3] 2",
            ".percepts(open); .filter(only, light(_)); .filter(arm, remove)    # [] [2] [3] 2",
            ".filter(arm, except, heat(_)); .percepts(open); .filter(arm, remove, only) # [1] [] [3] 2",
            ".percepts(open); .filter(arm, only, heat(_)); .filter(remove)     # [1] [2] [3] 2",
            ".limit(arm, 60000); .percepts(open)                   # [1] [2] [3] 2",
            ".percepts(open); .port(none, arm)                     # [1] [] [] 1",
            ".percepts(open); .port(none, arm); .port(crane, arm)  # [1] [2] [3] 2",
            ".port(none, arm); .port(none, leg); .percepts(open); .port(crane, arm)     # [1] [2] [3] 2",
    })
    void form_ofOneOrAllBoards_isForThem(String steps, String expected) {
        run(steps).notes(expected);
    }

    @Test
    void form_ofOneBoard_leavesTheOtherNamedOneAsItIs() {
        RunningAgent agent = RunningAgent.run(PROGRAM.formatted(
                ".port(lift, leg); .percepts(open); .percepts(arm, block); ?leg(light(L)); diffuser.note(L)"), body,
                arm, new FakeBoard("lift").perceive("light(4)"));
        agent.notes("4");
        agent.notes("[1] [] [] 3");
    }

    @Test
    void percept_ofANamedBoard_keepsItsAnnotationsOutside() {
        arm.perceive("battery(80)[interoception]", "~door(open)", "pressed");
        run(".percepts(open); ?arm(battery(X))[A]; ?arm(~door(open))[source(percept)]; ?arm(pressed);"
                + "diffuser.note(X,A)").notes("80 interoception");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '#', quoteCharacter = '\0', value = {
            ".act(arm(close))          # act close",
            "arm(close)                # act close",
            "arm(close(1,half))[fast]  # act close(1,half)",
            ".act(\"arm(close( 1 ))\") # act close( 1 )",
            ".act(arm(arm(close)))     # act arm(close)",
    })
    void action_ofANamedBoard_isAskedOfIt(String action, String request) {
        run(action);
        RunningAgent.asked(arm, request);
        assertEquals(0, body.requests.size());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '#', quoteCharacter = '\0', value = {
            ".act(arm(close(X))) # wrong_arguments # the action arm(close(X)) has a variable without a value",
            ".percepts(leg,open) # no_port # agent ",
            ".limit(leg,3)       # no_port # agent ",
            ".filter(leg,only,light(_))  # no_port # agent ",
            ".filter(arm)        # wrong_arguments # except, only or remove was expected, not 'arm'",
            ".filter(arm,arm,light(_))   # wrong_arguments # except, only or remove was expected, not 'arm'",
            ".filter(arm(1),only,light(_))   # wrong_arguments # except, only or remove was expected, not 'arm(1)'",
            ".filter(arm,except) # wrong_arguments # a percept, and perhaps a comparison, was expected",
            ".percepts(arm,on)   # wrong_arguments # open, block or close was expected, not 'on'",
            ".port(crane,true)   # wrong_arguments # a board's name such as arm was expected, not 'true'",
            ".port(crane,false)  # wrong_arguments # a board's name such as arm was expected, not 'false'",
            ".port(crane,port)   # wrong_arguments # a board's name such as arm was expected, not 'port'",
            ".port(crane,openness)       # wrong_arguments # a board's name such as arm was expected, not 'openness'",
            ".port(crane,peer)   # wrong_arguments # a board's name such as arm was expected, not 'peer'",
            ".port(crane,except) # wrong_arguments # a board's name such as arm was expected, not 'except'",
            ".port(crane,\"arm\")        # wrong_arguments # a board's name such as arm was expected, not '\"arm\"'",
            ".port(crane,'arm')  # wrong_arguments # a board's name such as arm was expected, not ''arm''",
            ".port(crane,arm(1)) # wrong_arguments # a board's name such as arm was expected, not 'arm(1)'",
            ".port(crane,a__b)   # wrong_arguments # a board's name such as arm was expected, not 'a__b'",
            ".port(crane,3)      # wrong_arguments # a board's name such as arm was expected, not '3'",
            ".port(crane,Arm)    # wrong_arguments # a board's name such as arm was expected, not 'Arm'",
    })
    void form_wrong_failsAndSaysWhatWasExpected(String step, String error, String fragment) {
        String note = run(step).nextNote();
        assertTrue(note.startsWith(error + " :") && note.contains(fragment), note);
    }

    @Test
    void action_ofTheMainBoardByTheNameOfABoard_goesToThatBoardAndAWarningTellsIt() {
        body.setActions("arm", "stop");
        RunningAgent agent = run("arm(close)");
        RunningAgent.asked(arm, "act close");
        agent.warns("the sketch on body has an action arm, too; arm(close) goes to the board arm");
    }

    @Test
    void action_plainWithAnEnvironment_goesToTheNamedBoardEvenIfItsSketchHasNone() throws Exception {
        arm.refuse("act fly", Status.UNKNOWN_ACTION);
        RunningAgent agent = RunningAgent.run("""
                !start.
                +!start <- .port(body); .port(crane, paint); paint(close); paint(X); ~paint(red); s::paint(red);
                    paint(red)[art(easel)]; stop; paint(fly).
                -!start[error(E),error_msg(M)] <- diffuser.note(E,":",M).
                """, RunningAgent.environment(), List.of(ScriptedDiffuser.class.getName()), body, arm);
        for (String behind : List.of("paint(X)", "~paint(red)", "s::paint(red)", "paint(red)[art(easel)]")) {
            agent.notes("environment " + behind);
        }
        agent.notes("action_failed : act fly failed: UNKNOWN_ACTION, the sketch has no action of this name");
        RunningAgent.asked(arm, "act close");
        RunningAgent.asked(body, "act stop");
    }

    @Test
    void radio_ofANamedBoard_isClosedAndGetsNoAddressNorTellsKeys() {
        FakeBoard another = new FakeBoard("crane");
        another.keys.set("SUPO", Bytes.of(1, 2, 3));
        RunningAgent agent = RunningAgent.run("""
                !start.
                +!start <- .port(crane, arm); .setMyRFId("ROMA"); .getRFMessages(open); .silence(1000); .port(body);
                    .act(arm(close)); .port(none, arm); .port(crane, leg); .act(leg(close)); diffuser.note(ready).
                +peer(S,_) <- diffuser.note(S).
                """, body, another);
        agent.notes("ready");
        agent.warns("the radio of the board arm stays closed: an agent has that of its main board only; for a second"
                + " one use another agent");
        assertEquals(Set.of("radio 0", "act close"), Set.copyOf(another.requests));
    }

    @Test
    void port_thatTheAgentHasUnderAnotherName_isOffAndTheLogSaysUnderWhich() {
        RunningAgent agent = run(".port(crane)");
        agent.warns(
                "the board is off: crane: agent " + agent.name() + " (board arm) of this MAS has it; give each board");
        agent.notes("[] [] [] 1");
    }

    @Test
    void argo_secondArgumentOfItsPort_meansNothing() {
        RunningAgent agent = RunningAgent.run("""
                !start.
                +!start <- .argo.port(body, arm); argo.port(body, arm); .argo.percepts(open); ?light(X);
                    .port(crane, arm); .argo.percepts(arm, block); argo.filter(arm, remove); argo.limit(arm, 0);
                    .argo.act(arm(close)); diffuser.note(X).
                """, null, List.of(ScriptedArgo.class.getName()), body, arm);
        agent.notes("1");
        RunningAgent.asked(arm, "act close");
    }
}
