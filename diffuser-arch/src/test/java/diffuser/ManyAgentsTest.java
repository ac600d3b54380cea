package diffuser;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

import javino.fake.FakeBoard;

/** As many agents in one MAS as nobody has, each with a board of its own. */
class ManyAgentsTest {

    private static final int AGENTS = 200;
    private static final String PROGRAM = """
        !start.
        +!start <- .port("%s"); .percepts(open).
        +light(L) <- .act(lamp(L)); diffuser.note(done).
        """;

    @Test
    void agents_eachWithABoard_workAndLeaveTheirPorts() {
        List<FakeBoard> boards = new ArrayList<>();
        List<RunningAgent> agents = new ArrayList<>();
        for (int i = 0; i < AGENTS; i++) {
            FakeBoard board = new FakeBoard("many" + i).perceive("light(" + i + ")");
            boards.add(board);
            agents.add(RunningAgent.run(PROGRAM.formatted(board.port.name()), board));
        }
        for (int i = 0; i < AGENTS; i++) {
            agents.get(i).notes("done");
            RunningAgent.asked(boards.get(i), "act lamp(" + i + ")");
        }
        agents.forEach(RunningAgent::close);
        boards.forEach(board -> board.port.awaitClosing());
    }
}
