package systemtest;

import static harness.Host.get;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Host;
import harness.SketchBoard;
import harness.TestKeys;
import java.util.List;
import java.util.Map;
import javino.protocol.BoardInfo;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** A board with a radio and keys on an ARM whose EEPROM is a page of flash. */
@Tag("verify")
class ArmRadioTest {

    @Test
    void idKeysAndEpoch_outliveAReset() throws Exception {
        try (SketchBoard board = ArmBoard.start("LoopbackStation", List.of()); Host host = board.host()) {
            int epoch = get(host.board.greeted()).bootEpoch();
            host.as("ROMA", Map.of("SUPO", TestKeys.PAIR));
            host.awaitOnline(1);
            board.reset();
            host.awaitOnline(1);
            BoardInfo info = host.board.info().orElseThrow();
            assertEquals("ROMA", info.rfId().orElseThrow().toString());
            assertTrue(info.bootEpoch() > epoch);
            assertEquals(1, get(host.board.keys()).size());
        }
    }

    @Test
    void broadcast_isReceived() throws Exception {
        try (SketchBoard board = ArmBoard.start("LoopbackStation", List.of());
                Host host = board.host().as("ROMA", Map.of())) {
            assertEquals("tell;hello", host.message().content().toString());
        }
    }
}
