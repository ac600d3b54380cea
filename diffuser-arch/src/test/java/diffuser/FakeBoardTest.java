package diffuser;

import javino.protocol.BoardVectors;
import javino.protocol.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class FakeBoardTest {

    @Test
    void requests_ofTheVectors_areAnsweredInTheirForm() throws Exception {
        FakeBoard board = new FakeBoard("fake").knowing("stop", "go").perceiving("light(1)", "dark")
                .endingAll(Outcome.SENT);
        board.receive("////", "ROMA", "tell;help");
        BoardVectors.assertAnswered(board);
    }
}
