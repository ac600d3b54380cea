package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import java.nio.file.Path;
import java.util.List;
import javino.board.SessionCounter;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A sketch that never returns from an action, or from its percepts: opening its port anew resets the board. */
@InEmulatedTime
class HangingBoardTest {

    private static final List<String> WORKS = List.of("works");

    @ParameterizedTest
    @Tag("verify")
    @ValueSource(strings = {"hang", "hangInPercepts"})
    void board_hangs_isResetAndWorksAgain(String action, @TempDir Path folder) throws Exception {
        try (Emulator emulator = new Emulator.Scenario().board("board", "Hanging").start(folder);
                Host host = Host.atUsualTimes(Host.link(emulator.port("board")))) {
            host.board.percepts(true);
            host.percepts(WORKS::equals);
            host.board.act(action);
            host.awaitOnline(2);
            host.percepts(WORKS::equals);
            emulator.await("its second reset", 2,
                    event -> event.is("reset", "board") && event.text("why").equals("port opened"));
            assertEquals(1, host.board.counters().get(SessionCounter.SILENCES));
        }
    }
}
