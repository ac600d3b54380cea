package campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;

import harness.WalkerLog;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The log tells whether an agent that moves was awake twice, or has changed. */
class WalkerLogTest {

    private static final int SIDE = 0;
    private static final int LIFE = 1;
    private static final int FIRST_DIGIT = 2;

    /** Each sign is a side, a life and a number. */
    @ParameterizedTest
    @CsvSource({
            "'a10 a11 a12', 0, 0, 0",
            "'a10 a11 b12 b13 a14', 0, 0, 010",
            "'a10 a11 b12 b13 b22 b23', 0, 0, 01",                // killed there: as it had come
            "'a10 a11 b12 b13 b24', 0, 0, 01",                    // killed on its way: it has stayed
            "'a10 a11 b12 b13 b12', 0, 1, 01",                    // back without a kill
            "'a10 a11 b12 b13 b25', 0, 1, 01",
            "'a10 a11 b12 a12 b13', 1, 0, 0101",
            "'a10 a11 b12 a11', 1, 0, 010",
            "'a10 a21 a11', 1, 0, 0",                             // a process that was killed
            "'a10 a12', 0, 1, 0",
            "'a15', 0, 1, 0",
    })
    void verdict_signsInOrder_tellsWhatIsWrong(String signs, int twice, int changed, String sides) {
        WalkerLog walk = new WalkerLog();
        int at = 0;
        for (String sign : signs.split(" ")) {
            walk.see(sign.charAt(SIDE) - 'a', sign.charAt(LIFE) - '0',
                    "[walker] tick " + sign.substring(FIRST_DIGIT) + " " + ++at);
        }
        WalkerLog.Verdict verdict = walk.verdict();

        assertEquals(List.of(twice, changed), List.of(verdict.twice().size(), verdict.changed().size()), signs);
        assertEquals(sides, String.join("", verdict.sides().stream().map(String::valueOf).toList()));
    }
}
