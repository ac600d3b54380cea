package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

import javino.fake.FakeBoard;

/** Plain actions beside a board, of two intentions in two workspaces, each operation used for the first time. */
class WorkspacesTest {

    private static final int OPERATIONS = 40;
    private static final List<String> ARCHS =
            List.of(ScriptedDiffuser.class.getName(), WorkspaceArch.class.getName());

    private static final String PROGRAM = """
            !start.
            +!start <- .port(body); diffuser.note(ready).
            +!go <- !!blink; !!a; !!b.
            +!a <- join(a); %s diffuser.note(a).
            +!b <- join(b); %s diffuser.note(b).
            -!a[error_msg(M)] <- diffuser.note(failed,M).
            -!b[error_msg(M)] <- diffuser.note(failed,M).
            +!blink <- lampOn; lampOff; !!blink.
            -!blink <- !!blink.
            """.formatted(operations("a"), operations("b"));

    private static String operations(String workspace) {
        return IntStream.rangeClosed(1, OPERATIONS).mapToObj(number -> workspace + number + "(" + number + "); ")
                .collect(Collectors.joining());
    }

    private static RunningAgent run(FakeBoard board) {
        RunningAgent agent = RunningAgent.run(PROGRAM, null, ARCHS, board);
        agent.notes("ready");
        return agent;
    }

    @Test
    void act_boardIsOn_eachOperationIsInItsIntentionsWorkspace() {
        FakeBoard board = new FakeBoard("body").setActions("lampOn", "lampOff");
        RunningAgent agent = run(board);
        agent.achieve("go");
        agent.notesAll("a", "b");
        assertEquals(List.of(), board.requests.stream().filter(request -> !request.startsWith("act lamp")).toList());
    }

    @Test
    void act_boardGoesAndComes_eachOperationIsInItsIntentionsWorkspace() {
        for (int run = 0; run < 5; run++) {
            FakeBoard board = new FakeBoard("body").setActions("lampOn", "lampOff");
            RunningAgent agent = run(board);
            Thread cable = new Thread(() -> {
                while (!Thread.currentThread().isInterrupted()) {
                    board.port.unplug();
                    agent.cycles(3);
                    board.reset();
                    board.port.plug();
                    agent.cycles(3);
                }
            });
            cable.start();
            try {
                agent.achieve("go");
                agent.notesAll("a", "b");
            } finally {
                cable.interrupt();
                join(cable);
            }
            assertEquals(List.of(),
                    board.requests.stream().filter(request -> !request.startsWith("act lamp")).toList());
            agent.close();
        }
    }

    @Test
    void act_boardNeverCame_allGoesBehindWithOneWarning() {
        FakeBoard board = new FakeBoard("body").setActions("lampOn", "lampOff").unplug();
        RunningAgent agent = run(board);
        agent.warns("there is no such port");
        agent.achieve("go");
        agent.notesAll("a", "b");
        assertEquals(
                List.of("no board has answered on body yet: plain actions go to the environment until one has"),
                List.copyOf(agent.warnings));
    }

    private static void join(Thread thread) {
        try {
            thread.join();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}
