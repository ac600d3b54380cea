package campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import keyagreement.CertifiedHost;
import mobility.RandomMoves;
import mobility.RandomMoves.Tally;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Agents move between hosts without stored keys, which agree on keys meanwhile, killed, reset and attacked. */
class CertifiedMovesTest {

    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 5, 6})
    void moves_killsResetsLossesAndAnAttacker_neverTwoAwakeAndOneInTheEnd(long seed) throws Exception {
        Tally tally = RandomMoves.run(seed, Files.createDirectory(folder.resolve("records")),
                CertifiedHost.maker(Files.createDirectory(folder.resolve("identities"))));

        assertEquals(List.of(), tally.wrong());
        assertEquals(List.of(), tally.both());
        assertEquals(0, tally.lostAgents() + tally.doubled() + tally.changed() + tally.unasked() + tally.unended(),
                tally::toString);
        assertTrue(tally.arrived() > 0);
    }
}
