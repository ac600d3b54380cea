package capture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Traces of runs, which stay in the repository. */
class TracesTest {

    private static final String OWN = "optional/capture";
    /** A module whose traces with hosts are checked here, too. */
    private static final String REPLAY = "uppaal/replay";

    private static TraceCheck.Found check(String module, String name) throws Exception {
        Path traces = Path.of(System.getProperty("javino.root"), module, "src/test/resources/traces");
        return TraceCheck.check(traces.resolve(name + ".jsonl"), Files.readString(traces.resolve(name + ".keys")));
    }

    @Test
    void highway_allPacketsAreThereAndLinked() throws Exception {
        assertEquals(new TraceCheck.Found(70, 0, 40, 0, 25), check(OWN, "highway"));
    }

    @Test
    void fragments_fromADamagedAir_arePutTogether() throws Exception {
        TraceCheck.Found found = check(OWN, "fragments");
        assertTrue(found.damaged() == 10 && found.fragments() >= 6, found::toString);
    }

    @Test
    void partnersThatAreAnsweredInTurn_areTold() throws Exception {
        check(OWN, "partners");
    }

    @Test
    @Tag("verify")
    void relays_copiesHaveTheirHops() throws Exception {
        check(OWN, "relays");
    }

    @Test
    void moves_arePutTogether() throws Exception {
        check(REPLAY, "hosts/walker");
    }
}
