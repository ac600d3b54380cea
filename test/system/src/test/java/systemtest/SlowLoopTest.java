package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.SessionCounter;
import javino.link.SerialLink;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A sketch with a {@code delay(2000)} in {@code loop()}: its agent is told so, and gets its percepts nevertheless. */
@Tag("verify")
class SlowLoopTest {

    @Test
    void board_waitsInLoop_isWarnedOfAndNotLost(@TempDir Path folder) throws Exception {
        BlockingQueue<String> told = new LinkedBlockingQueue<>();
        BoardListener listener = new BoardListener() {
            @Override
            public void warning(String what) {
                told.add(what);
            }

            @Override
            public void percepts(List<String> literals) {
                told.addAll(literals);
            }
        };
        try (Emulator emulator = new Emulator.Scenario().board("board", "SlowLoop").start(folder);
                Board board = Board.open(SerialLink.opener(emulator.port("board")),
                        BoardConfig.create(Host::patience), listener)) {
            board.percepts(true);
            String warning = told.poll(2, TimeUnit.MINUTES);
            assertTrue(warning != null && warning.matches("the sketch's loop took [\\d.]+ s, and delays .*"), warning);
            assertEquals("celsius(21)", told.poll(2, TimeUnit.MINUTES));
            assertEquals(0, board.counters().get(SessionCounter.SILENCES));
        }
    }
}
