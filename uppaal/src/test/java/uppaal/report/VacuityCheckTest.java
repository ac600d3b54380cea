package uppaal.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import uppaal.Sketch;
import uppaal.check.Query;
import uppaal.check.QueryFile;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;

class VacuityCheckTest {
    private static final Path MODELS = Path.of("models");

    @Test
    void of_paper_onlyTheSecondSaysNothing() {
        Network network = NetworkBuilder.build(Scene.PAPER.document(MODELS));
        List<VacuityCheck> found = VacuityCheck.of(network, QueryFile.read(MODELS.resolve("paper.q")));
        assertTrue(found.stream().allMatch(VacuityCheck::reached));
        assertEquals(List.of("P2"), found.stream().filter(VacuityCheck::needless).map(VacuityCheck::query).toList());
        assertEquals(7, found.size());
    }

    @Test
    void of_emptyImplication_isFound() {
        Network network = Sketch.of("").template("P", "a -> b; guard false").network();
        List<Query> query = List.of(new Query("V", true, "nothing.", "A[] P.b imply false", "here"));
        assertEquals(List.of(new VacuityCheck("V", false, false)), VacuityCheck.of(network, query));
    }
}
