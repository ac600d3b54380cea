package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

import jason.asSemantics.Agent;

import diffuser.board.Device;

import javino.fake.FakeBoard;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PortTest {

    private static final String PROGRAM = """
            !start.
            +!start  <- .port(left); diffuser.note(ready).
            +!right  <- .port("right"); diffuser.note(changed).
            +!missing <- .port(missing); diffuser.note(changed).
            +!do     <- .act(stop); diffuser.note(done).
            -!do[error(E)] <- diffuser.note(E).
            +count(N) <- diffuser.note(count,N).
            +port(P,S) <- diffuser.note(P,S).
            -port(P,S) <- diffuser.note(no,P,S).
            """;

    @Test
    void port_unpluggedAndPluggedAgain_beliefFollowsAndAgentGoesOn() {
        FakeBoard board = new FakeBoard("left");
        RunningAgent agent = RunningAgent.run(PROGRAM, board);
        agent.notesAll("left on", "ready");
        board.port.unplug();
        agent.notesAll("no left on", "left off");
        board.port.plug();
        agent.notesAll("no left off", "left on");
        agent.achieve("do");
        agent.notes("done");
    }

    @Test
    void port_boardFallsSilent_beliefFollowsAndCyclesGoOn() {
        FakeBoard board = new FakeBoard("left");
        RunningAgent agent = RunningAgent.run(PROGRAM, board);
        agent.notesAll("left on", "ready");
        board.swallow("act stop");
        agent.achieve("do");
        RunningAgent.asked(board, "act stop");
        for (int i = 0; i < 20; i++) {
            agent.believe("count(" + i + ")");
        }
        for (int i = 0; i < 20; i++) {
            agent.notes("count " + i);
        }
        agent.notesAll("outcome_unknown", "no left on", "left off");
    }

    @Test
    void port_another_replacesTheFirst() {
        FakeBoard left = new FakeBoard("left").perceive("count(1)");
        FakeBoard right = new FakeBoard("right").perceive("count(2)");
        RunningAgent agent = RunningAgent.run(PROGRAM, left, right);
        agent.notesAll("left on", "ready");
        agent.achieve("right");
        agent.notesAll("no left on", "right on", "changed");
        agent.achieve("do");
        RunningAgent.asked(right, "act stop");
        agent.notes("done");
        assertEquals(0, left.requests.size());
    }

    @Test
    void port_replacedBeforeItIsDecided_itsIntentionGoesOn() {
        FakeBoard left = new FakeBoard("left");
        left.line.setSilent(true);
        String program = """
                !start. !other.
                +!start <- .port(left); diffuser.note(replaced).
                +!other <- .port(missing); diffuser.note(decided).
                """;
        RunningAgent agent = RunningAgent.run(program, left);
        agent.notesAll("replaced", "decided");
    }

    @Test
    void port_formerSessionHangs_agentGoesOnAndTheNextSessionWaits() {
        FakeBoard left = new FakeBoard("left");
        RunningAgent agent = RunningAgent.run(PROGRAM, left, new FakeBoard("right"));
        agent.notesAll("left on", "ready");
        left.port.blockClosing(true);
        agent.achieve("right");
        left.port.awaitClosing();
        agent.believe("count(1)");
        agent.notesAll("no left on", "count 1");
        left.port.blockClosing(false);
        agent.notesAll("right on", "changed");
    }

    @Test
    void port_sameAgain_isOpenedWhenItIsFree() {
        FakeBoard left = new FakeBoard("left");
        String program = """
                !start.
                +!start <- .port(left); .port(left); .port(left); .act(stop); diffuser.note(done).
                +port(P,off) <- diffuser.note(P,off).
                """;
        RunningAgent agent = RunningAgent.run(program, left);
        agent.notes("done");
        assertEquals(1, left.port.mostOpen());
    }

    @Test
    void port_another_isBelievedWhenThePlanGoesOn() {
        String program = """
                !swap(30).
                +!swap(0) <- diffuser.note(done).
                +!swap(N) <- .port(right); ?port("right",on); .port(left); ?port("left",on); !swap(N-1).
                -!swap(N) <- diffuser.note(failed,N).
                """;
        RunningAgent agent = RunningAgent.run(program, new FakeBoard("left").perceive("count(1)"),
                new FakeBoard("right").perceive("count(2)"));
        agent.notes("done");
    }

    @Test
    void port_agentWasStopped_opensNone() throws Exception {
        RunningAgent agent = RunningAgent.run(PROGRAM, new FakeBoard("left"));
        agent.notesAll("left on", "ready");
        Diffuser diffuser = agent.diffuser();
        agent.close();
        Device last = diffuser.device().orElseThrow();
        diffuser.openPort("right", "").join();
        assertSame(last, diffuser.device().orElseThrow());
    }

    @Test
    void port_missing_beliefIsOffAndNoFailure() {
        RunningAgent agent = RunningAgent.run(PROGRAM, new FakeBoard("left"));
        agent.notesAll("left on", "ready");
        agent.achieve("missing");
        agent.notesAll("no left on", "missing off", "changed");
        agent.warns("the board is off: missing: there is no such port");
    }

    @Test
    void port_variableBoundToName_itsValueCounts() {
        String program = "!start. +!start <- P = left; .port(P). +port(P,S) <- diffuser.note(P,S).";
        RunningAgent agent = RunningAgent.run(program, new FakeBoard("left"));
        agent.notes("left on");
    }

    @Test
    void stop_agentStops_sessionEnds() throws Exception {
        FakeBoard board = new FakeBoard("left");
        RunningAgent agent = RunningAgent.run(PROGRAM, board);
        agent.notesAll("left on", "ready");
        agent.close();
        ScriptedDiffuser.join(ScriptedDiffuser.session("left"));
    }

    @Test
    void port_heldByAnotherAgent_saysByWhich() {
        FakeBoard left = new FakeBoard("left");
        RunningAgent one = RunningAgent.run(PROGRAM, left);
        one.notesAll("left on", "ready");
        RunningAgent other = RunningAgent.run(PROGRAM);
        other.warns(
                "the board is off: left: agent " + one.name() + " of this MAS has it; give each board a port of"
                        + " its own, or have it left there first");
        other.notesAll("left off", "ready");
        assertEquals(1, left.port.mostOpen());
        one.close();
        other.notesAll("no left off", "left on");
        assertEquals(1, left.port.mostOpen());
    }

    @Test
    void port_killedAndCreatedAnew_isNeverOff() {
        FakeBoard left = new FakeBoard("left");
        RunningAgent one = RunningAgent.run(PROGRAM, left);
        one.notesAll("left on", "ready");
        left.port.blockClosing(true);
        Thread end = new Thread(one::close);
        end.start();
        RunningAgent next = RunningAgent.run(PROGRAM);
        left.port.awaitClosing();
        left.port.blockClosing(false);
        next.notesAll("left on", "ready");
        assertEquals(1, left.port.mostOpen());
    }

    @Test
    void port_bothNamesOfOnePort_areOnePort(@TempDir Path folder) throws Exception {
        Path port = Files.createFile(folder.resolve("port"));
        Path link = Files.createSymbolicLink(folder.resolve("port-by-id"), port);
        FakeBoard board = new FakeBoard(port.toString());
        String program = "!start. +!start <- .port(\"%s\"). +port(_,S) <- diffuser.note(S).";
        RunningAgent one = RunningAgent.run(program.formatted(port), board);
        one.notes("on");
        RunningAgent other = RunningAgent.run(program.formatted(link), new FakeBoard(link.toString()));
        other.warns("agent " + one.name() + " of this MAS has it");
        other.notes("off");
    }

    @Test
    void twoAgents_eachWithItsBoard_doNotMix() {
        String program = "!start. +!start <- .port(%1$s); .percepts(open); .act(%1$s); diffuser.note(done)."
                + "+p(X) <- diffuser.note(p,X).";
        FakeBoard left = new FakeBoard("left").perceive("p(1)");
        FakeBoard right = new FakeBoard("right").perceive("p(2)");
        RunningAgent one = RunningAgent.run(program.formatted("left"), left);
        RunningAgent two = RunningAgent.run(program.formatted("right"), right);
        one.notesAll("done", "p 1");
        two.notesAll("done", "p 2");
        RunningAgent.asked(left, "act left");
        RunningAgent.asked(right, "act right");
    }

    /** As JaCaMo's demo of snapshots does. */
    @Test
    void agent_readFromAStream_goesOnWithoutItsBoard() throws Exception {
        RunningAgent agent = RunningAgent.run("!start. +!start <- .port(ttyACM0); diffuser.note(ready).",
                new FakeBoard("ttyACM0"));
        agent.notes("ready");
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        new ObjectOutputStream(bytes).writeObject(agent.body().getTS().getAg());
        Agent read = (Agent) new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray())).readObject();
        Diffuser diffuser = Diffuser.of(read.getTS());
        diffuser.perceive();
        assertEquals(Optional.empty(), diffuser.port());
        diffuser.stop();
    }
}
