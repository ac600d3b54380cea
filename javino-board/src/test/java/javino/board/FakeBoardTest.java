package javino.board;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import javino.link.Link;
import javino.protocol.BoardVectors;
import javino.protocol.Bytes;
import javino.protocol.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What the fakes answer, apart from the library that they test. */
@Timeout(60)
class FakeBoardTest {

    @Test
    void requests_ofTheVectors_areAnsweredInTheirForm() throws Exception {
        FakeBoard board = new FakeBoard();
        board.setActions("stop", "go");
        board.setPercepts("light(1)", "dark");
        board.receive("tell;help");
        board.receiveWithoutKey("SUPO", "CAFE");
        board.overhear(1, 0, Bytes.ofText("////ROMAAIx"));
        board.setEnds(Outcome.SENT);
        board.setSessionKey("CAFE", Bytes.of(7, 7, 7));
        BoardVectors.assertAnswered(new FakePort(board));
    }

    /** SPEC 8.1, whose example is what the host writes here. */
    @Test
    void getPercepts_ofABoardWithTheOlderProtocol_isAnsweredInItsForm() throws Exception {
        try (Link link = new FakeLegacyBoard().perceiving("light(1);dark;").open()) {
            link.setBaud(9600);
            link.write(Bytes.ofText("fffe0BgetPercepts").toArray());
            byte[] buffer = new byte[64];
            int count = link.read(buffer, Duration.ofMinutes(1));
            assertEquals("fffe0Elight(1);dark;", Bytes.copyOf(buffer).slice(0, count).text());
        }
    }
}
