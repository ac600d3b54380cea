package diffuser;

import static diffuser.RunningAgent.asked;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.List;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import javino.fake.FakeBoard;

/** Agents as they are written for the public Argo architecture. */
class ArgoTest {

    /** Blinks, and gives up when the board goes; all ways of calling the actions are in use. */
    private static final String BLINKER = """
            /* Initial beliefs and rules */
            serialPort(ttyACM0).

            /* Initial goals */
            !connect.

            /* Plans */
            +!connect : serialPort(Port) <-
                %1$sport(Port);
                %1$slimit(10);
                %1$spercepts(open).

            +led(Status) : Status = on  <- %1$sact(ledOff); diffuser.note(led,on).
            +led(Status) : Status = off <- %1$sact(ledOn);  diffuser.note(led,off).

            +port(P,S) : serialPort(SP) & P = SP & S = on <- diffuser.note(P,connected).
            +port(Port,Status) : Status = timeout | Status = off <-
                %1$spercepts(close);
                diffuser.note(Port,Status).
            """;

    private static RunningAgent argo(String program, FakeBoard... boards) {
        return RunningAgent.run(program, null, List.of(ScriptedArgo.class.getName()), boards);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "Argo          | .argo.port(none); .argo.percepts(open)",
            "jason.Argo    | .argo.port(none); .argo.percepts(open)",
            "Difuser       | .difuser.port(none); .difuser.listen(open)",
            "jason.Difuser | .difuser.port(none); .difuser.listen(open)",
    })
    void architecture_eachNameOfThePublicOnes_isFound(String name, String actions) throws Exception {
        String program = "!start. +!start <- %s; diffuser.note(done).".formatted(actions);
        RunningAgent agent = RunningAgent.run(program, null, List.of(name));
        agent.notes("done");
        assertInstanceOf(jason.Argo.class, agent.diffuser());
    }

    @ParameterizedTest
    @ValueSource(strings = {".", ".argo.", "argo."})
    void agent_eachWayOfWriting_blinks(String prefix) {
        FakeBoard board = new FakeBoard("ttyACM0").perceive("led(off)");
        RunningAgent agent = argo(BLINKER.formatted(prefix), board);
        agent.notesAll("ttyACM0 connected", "led off");
        RunningAgent.asked(board, "act ledOn");
        board.perceive("led(on)");
        RunningAgent.asked(board, "act ledOff");
        agent.notes("led on");
        board.port.unplug();
        agent.notes("ttyACM0 off");
    }

    /** Javino 1.6.7 alone tells no port, Argo asks it to do so unless -Dstatus=false: programs for both go on. */
    @ParameterizedTest
    @ValueSource(strings = {
            "+port(ttyACM0,on) : light(X) <- diffuser.note(light,X).",
            "+light(X) : port(_,on) <- diffuser.note(light,X).",
            "+light(X) <- diffuser.note(light,X).",
    })
    void port_thatAProgramAsksForOrNot_comesWithTheFirstReading(String plan) {
        String start = "!start. +!start <- .argo.port(ttyACM0); .argo.percepts(open). ";
        argo(start + plan, new FakeBoard("ttyACM0").perceive("light(1)")).notes("light 1");
    }

    @Test
    void port_missingAndForgottenAndOpenedAnew_isOneEventEachTime() {
        RunningAgent agent = argo("""
                !connect.
                +!connect <- diffuser.note(connect); .argo.port(missing); .argo.percepts(open).
                +port(P,off) <- diffuser.note(off); .argo.percepts(close); .abolish(port(_,_)); .wait(300); !connect.
                """);
        for (int i = 0; i < 5; i++) {
            agent.notes("connect");
            agent.notes("off");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {".percepts(close)", ".percepts(block)", ".argo.percepts(close)"})
    void percepts_closedAndOpenedByTheirOwnPlan_areNoNewEvents(String close) {
        FakeBoard board = new FakeBoard("ttyACM0").perceive("light(1)");
        String program = """
                !start.
                +!start <- .port(ttyACM0); .percepts(open).
                +light(X) <- %s; diffuser.note(light,X); .percepts(open).
                -light(X) <- diffuser.note(no,light,X).
                +!probe <- diffuser.note(probed).
                """.formatted(close);
        RunningAgent agent = argo(program, board);
        agent.notes("light 1");
        agent.notesNothingElse();
        board.perceive("light(2)");
        agent.notesAll("light 2", "no light 1");
        agent.notesNothingElse();
    }

    @Test
    void percepts_changeWhileClosed_areBelievedWhenOpened() {
        FakeBoard board = new FakeBoard("ttyACM0").perceive("light(1)");
        String program = """
                !start.
                +!start <- .port(ttyACM0); .percepts(open).
                +!close <- .percepts(close); diffuser.note(closed).
                +!open  <- .percepts(open).
                +light(X) <- diffuser.note(light,X).
                -light(X) <- diffuser.note(no,light,X).
                +!probe <- diffuser.note(probed).
                """;
        RunningAgent agent = argo(program, board);
        agent.notes("light 1");
        agent.achieve("close");
        agent.notes("closed");
        board.perceive("light(2)");
        agent.notesNothingElse();
        agent.achieve("open");
        agent.notesAll("no light 1", "light 2");
    }

    @Test
    void percepts_closedBeforeTheyWereOpened_areNoBeliefs() {
        FakeBoard board = new FakeBoard("ttyACM0").perceive("light(1)");
        String program = "!start. +!start <- .percepts(close); .port(ttyACM0); diffuser.note(ready)."
                + "+light(X) <- diffuser.note(light,X). +!probe <- diffuser.note(probed).";
        RunningAgent agent = argo(program, board);
        agent.notes("ready");
        agent.notesNothingElse();
    }

    @Test
    void percepts_boardGoesWhileClosed_areForgotten() {
        FakeBoard board = new FakeBoard("ttyACM0").perceive("light(1)");
        String program = """
                !start.
                +!start <- .port(ttyACM0); .percepts(open).
                +!close <- .percepts(close); diffuser.note(closed).
                +light(X) <- diffuser.note(light,X).
                -light(X) <- diffuser.note(no,light,X).
                +port(_,off) <- diffuser.note(off).
                """;
        RunningAgent agent = argo(program, board);
        agent.notes("light 1");
        agent.achieve("close");
        agent.notes("closed");
        board.port.unplug();
        agent.notesAll("no light 1", "off");
    }

    /** Switches a lamp 20 times, and notes each time what it believes next. */
    private static String switching(String limit, String between) {
        return """
                !start.
                +!start <- .argo.port(ttyACM0); %s .argo.percepts(open);
                    for (.range(I,1,10)) { !switch(ledOn); !switch(ledOff) };
                    diffuser.note(done).
                +!switch(Action) <- .argo.act(Action); %s ?ledStatus(X); diffuser.note(Action,X).
                """.formatted(limit, between);
    }

    private static FakeBoard lamp() {
        return new FakeBoard("ttyACM0").perceive("ledStatus(off)")
                .perceiveAfter("act ledOn", "ledStatus(on)").perceiveAfter("act ledOff", "ledStatus(off)");
    }

    @ParameterizedTest
    @CsvSource({"'',''", ".argo.limit(20);,''", "'',.my_name(_);"})
    void act_beliefIsAskedNext_isFresh(String limit, String between) {
        RunningAgent agent = argo(switching(limit, between), lamp());
        for (int i = 0; i < 10; i++) {
            agent.notes("ledOn on");
            agent.notes("ledOff off");
        }
        agent.notes("done");
    }

    /** As the public Argo writes it; a sketch that names its actions gets what is in the string. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\'', value = {
            "'' | \"ARGO online!\" | \"ARGO online!\"",
            "'' | \"ledOn\" | \"ledOn\"",
            "'' | 42 | 42",
            "'' | [a,\"b\"] | [a,\"b\"]",
            "'' | speed(80) | speed(80)",
            "'' | say(\"hi\") | say(\"hi\")",
            "ledOn | \"ledOn\" | ledOn",
            "ledOn | ledOn | ledOn",
    })
    void act_termForABoardThatNamesNoActions_isSentAsItIsWritten(String named, String term, String sent) {
        FakeBoard board = new FakeBoard("ttyACM0");
        if (!named.isEmpty()) {
            board.setActions(named);
        }
        RunningAgent agent =
                argo("!start. +!start <- .port(ttyACM0); .argo.act(%s); diffuser.note(acted).".formatted(term), board);
        agent.notes("acted");
        asked(board, "act " + sent);
    }

    @Test
    void act_variableForABoardThatNamesNoActions_isRefused() {
        RunningAgent agent = argo("!start. +!start <- .port(ttyACM0); .act(X). -!start[error(E)] <- diffuser.note(E).",
                new FakeBoard("ttyACM0"));
        agent.notes("wrong_arguments");
    }

    @Test
    void act_atomicPlan_isFreshToo() {
        String program = "!start. @x[atomic] +!start <- .port(ttyACM0); .percepts(open); .act(ledOn); ?ledStatus(X);"
                + "diffuser.note(X); .act(ledOff); ?ledStatus(Y); diffuser.note(Y).";
        RunningAgent agent = argo(program, lamp());
        agent.notes("on");
        agent.notes("off");
    }

    @Test
    void act_nextReadingIsFarOff_goesOnWithoutIt() {
        String program = """
                !start.
                +!start <- .port(ttyACM0); .percepts(open); .limit(3600000); .act(ledOn); diffuser.note(acted);
                    .act(ledOn); ?ledStatus(X); diffuser.note(X).
                """;
        RunningAgent agent = argo(program, lamp());
        agent.notes("acted");
        agent.notes("off");
    }

    @Test
    void act_beliefIsAskedNextAndReadingsAreSecondsApart_waitsForOne() {
        String program = """
                !start.
                +!start <- .port(ttyACM0); .percepts(open); .limit(2000); .act(ledOn); ?ledStatus(X); diffuser.note(X).
                """;
        RunningAgent agent = argo(program, lamp());
        agent.notes("on");
    }

    @Test
    void act_perceptsClosedOrNeverOpened_waitsForNoReading() {
        String program = """
                !start.
                +!start <- .port(ttyACM0); .act(ledOn); diffuser.note(one); .percepts(open); .percepts(close);
                    .act(ledOff); ?ledStatus(X); diffuser.note(X); .port(none); diffuser.note(left).
                """;
        RunningAgent agent = argo(program, lamp());
        agent.notes("one");
        agent.notes("on");
        agent.notes("left");
    }

    @Test
    void act_agentHasSomethingElseToDo_doesItMeanwhile() {
        FakeBoard board = lamp();
        String program = """
                !start.
                +!start <- .port(ttyACM0); .percepts(open); diffuser.note(ready).
                +!act <- .act(ledOn); ?ledStatus(X); diffuser.note(X).
                +!probe <- diffuser.note(probed).
                """;
        RunningAgent agent = argo(program, board);
        agent.notes("ready");
        board.swallow("act ledOn");
        agent.achieve("act");
        RunningAgent.asked(board, "act ledOn");
        agent.achieve("probe");
        agent.notes("probed");
    }

    @ParameterizedTest
    @ValueSource(strings = {".port(ttyACM0); .percepts(open)", ".percepts(open); .port(ttyACM0)",
            ".limit(3600000); .port(ttyACM0); .percepts(open)"})
    void percepts_openedOnABoard_areBelievedInTheNextStep(String opening) {
        for (int i = 0; i < 10; i++) {
            FakeBoard board = new FakeBoard("ttyACM0").perceive("umidadeSolo(42)");
            String program = "!start. +!start <- " + opening + "; ?umidadeSolo(U); diffuser.note(U).";
            RunningAgent agent = argo(program, board);
            agent.notes("42");
            agent.close();
        }
    }

    @Test
    void percepts_openedWhileTheBoardIsAway_goesOn() {
        String program = "!start. +!start <- .port(ttyACM0); .percepts(open); ?port(P,S); diffuser.note(P,S).";
        RunningAgent agent = argo(program, new FakeBoard("ttyACM0").unplug());
        agent.notes("ttyACM0 off");
    }

    /** As the public Argo, which learns of its port from its board's readings. */
    @Test
    void port_isBelievedWithTheFirstReading() {
        FakeBoard board = new FakeBoard("ttyACM0").perceive("light(1)");
        String program = """
                !start.
                +!start <- .argo.port(ttyACM0); diffuser.note(opened).
                +!sense <- .argo.percepts(open).
                +port(P,on) : light(X) <- diffuser.note(P,X).
                +port(P,on) <- diffuser.note(P,dark).
                +!probe <- diffuser.note(probed).
                """;
        RunningAgent agent = argo(program, board);
        agent.notes("opened");
        agent.notesNothingElse();
        agent.achieve("sense");
        agent.notes("ttyACM0 1");
        board.port.unplug();
        board.port.plug();
        agent.notes("ttyACM0 1");
    }

    @Test
    void port_boardWithoutPercepts_isBelievedToo() {
        RunningAgent agent = argo("!start. +!start <- .argo.port(ttyACM0); .argo.percepts(open)."
                + "+port(P,on) <- diffuser.note(P).", new FakeBoard("ttyACM0"));
        agent.notes("ttyACM0");
    }

    @Test
    void port_pathAsString_isBelievedByItsLastPart() {
        String program = "!start. +!start <- .argo.port(\"/dev/ttyUSB0\",true); .argo.percepts(open)."
                + "+port(ttyUSB0,on) <- diffuser.note(on).";
        RunningAgent agent = argo(program, new FakeBoard("/dev/ttyUSB0"));
        agent.notes("on");
    }

    @Test
    void port_noAtom_isBelievedAsAString() {
        String program = "!start. +!start <- .port(COM3); .percepts(open). +port(\"COM3\",on) <- diffuser.note(on).";
        RunningAgent agent = argo(program, new FakeBoard("COM3"));
        agent.notes("on");
    }

    @Test
    void port_none_leavesThePort() {
        FakeBoard board = new FakeBoard("ttyACM0").perceive("light(1)");
        String program = """
                !start.
                +!start <- .port(ttyACM0); .percepts(open).
                +!leave <- .port(none).
                +light(X) <- diffuser.note(light,X).
                -light(X) <- diffuser.note(no,light,X).
                -port(P,on) <- diffuser.note(no,P).
                """;
        RunningAgent agent = argo(program, board);
        agent.notes("light 1");
        agent.achieve("leave");
        agent.notesAll("no light 1", "no ttyACM0");
        board.port.awaitClosing();
    }

    @Test
    void radio_works() {
        FakeBoard board = new FakeBoard("ttyACM0");
        String program = "!start. +!start <- .argo.port(ttyACM0); .setMyRFId(\"ROMA\"); .diffuse(broadcast,tell,help);"
                + "diffuser.note(done).";
        RunningAgent agent = argo(program, board);
        RunningAgent.asked(board, "id ROMA");
        RunningAgent.asked(board, "//// tell;help");
        agent.notes("done");
    }
}
