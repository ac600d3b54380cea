package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class ReopenPauseTest {

    private final ReopenPause pause = new ReopenPause(Duration.ofMillis(200));

    private long millisAfter(Duration served) {
        return pause.after(served).toMillis();
    }

    @Test
    void after_boardSoonSilentEachTime_growsToItsMost() {
        Duration soon = Duration.ofSeconds(10);
        assertEquals(200, millisAfter(soon));
        assertEquals(400, millisAfter(soon));
        assertEquals(800, millisAfter(soon));
        for (int i = 0; i < 10; i++) {
            millisAfter(soon);
        }
        assertEquals(60_000, millisAfter(soon));
    }

    @Test
    void after_boardWasThereForLong_isShortAgain() {
        millisAfter(Duration.ZERO);
        millisAfter(Duration.ZERO);
        assertEquals(200, millisAfter(ReopenPause.LONGEST));
        assertEquals(400, millisAfter(Duration.ZERO));
    }
}
