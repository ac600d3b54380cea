package javino.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import javino.board.Board;
import javino.board.BoardConfig;
import javino.board.BoardListener;
import javino.board.RequestFailedException;
import javino.fake.FakeBoard;
import javino.protocol.Capability;
import org.junit.jupiter.api.Test;

/** The step that captures and gateways begin with. */
class OverhearingTest {

    @Test
    void begin_boardWithoutRadio_saysSo() throws Exception {
        FakeBoard fake = new FakeBoard().setCapabilities(Capability.SAYS_TAKEN);
        try (Board board = Board.open(fake.port, BoardConfig.create(), new BoardListener() {})) {
            Await.result(board, board.greeted());
            assertEquals("overhear failed: NO_RADIO, the board has no radio; for one, its sketch makes a "
                    + "JavinoRadioBoard",
                    assertThrows(RequestFailedException.class,
                            () -> Overhearing.begin(board, "fake")).getMessage());
        }
        assertEquals(List.of(), List.copyOf(fake.requests));
    }
}
