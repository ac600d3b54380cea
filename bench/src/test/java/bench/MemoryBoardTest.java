package bench;

import java.time.Duration;
import java.util.stream.Stream;
import javino.protocol.BoardVectors;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

@Timeout(60)
class MemoryBoardTest {

    static Stream<MemoryBoard> boards() {
        return Stream.of(MemoryBoard.answeringAfter(Duration.ZERO), MemoryBoard.answeringAfter(Duration.ofMillis(1)),
                MemoryBoard.changing());
    }

    @ParameterizedTest
    @MethodSource("boards")
    void requests_ofTheVectors_areAnsweredInTheirForm(MemoryBoard board) throws Exception {
        BoardVectors.assertAnswered(board);
    }
}
