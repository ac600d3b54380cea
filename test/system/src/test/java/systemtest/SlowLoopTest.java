package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import java.nio.file.Path;
import java.util.List;
import javino.board.SessionCounter;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A sketch with a {@code delay(2000)} in {@code loop()}: its agent is told so, and gets its percepts nevertheless. */
@InEmulatedTime
class SlowLoopTest {

    @Test
    @Tag("verify")
    void board_waitsInLoop_isWarnedOfAndNotLost(@TempDir Path folder) throws Exception {
        try (Emulator emulator = new Emulator.Scenario().board("board", "SlowLoop").start(folder);
                Host host = Host.of(emulator, "board")) {
            host.board.percepts(true);
            String warning = host.warning();
            assertTrue(warning.matches("the sketch's loop took [\\d.]+ s, and delays .*"), warning);
            host.percepts(List.of("celsius(21)")::equals);
            assertEquals(0, host.board.counters().get(SessionCounter.SILENCES));
        }
    }
}
