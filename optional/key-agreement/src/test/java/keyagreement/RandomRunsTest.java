package keyagreement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Handshakes with whatever goes wrong: nothing is accepted or set twice, and in the end all is in order again. */
class RandomRunsTest {

    @TempDir
    Path folder;

    private void run(int seeds) throws Exception {
        for (RandomRuns.Tally tally : RandomRuns.run(0, seeds, folder)) {
            String what = tally.toString();
            assertEquals(List.of(), tally.wrong(), what);
            assertEquals(0, tally.untrue(), what);
            assertEquals(0, tally.open(), what);
            assertEquals(0, tally.late(), what);
            assertTrue(tally.agreements() <= 2, what);
        }
    }

    @Test
    @Tag("verify")
    void meetings_killsResetsDamageAndCopies_allInOrderAgain() throws Exception {
        run(40);
    }

    @Test
    @Tag("soak")
    void meetings_manyMore_allInOrderAgain() throws Exception {
        run(1000);
    }
}
