package capture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Traces of runs, which stay in the repository. */
class TracesTest {

    private static final Path TRACES =
            Path.of(System.getProperty("javino.root"), "optional/capture/src/test/resources/traces");

    private static TraceCheck.Found check(String name) throws Exception {
        return TraceCheck.check(TRACES.resolve(name + ".jsonl"), Files.readString(TRACES.resolve(name + ".keys")));
    }

    @Test
    void highway_allPacketsAreThereAndLinked() throws Exception {
        assertEquals(new TraceCheck.Found(70, 0, 40, 0, 25), check("highway"));
    }

    @Test
    void fragments_fromADamagedAir_arePutTogether() throws Exception {
        TraceCheck.Found found = check("fragments");
        assertTrue(found.damaged() == 10 && found.fragments() >= 6, found::toString);
    }

    @Test
    void partnersThatAreAnsweredInTurn_areTold() throws Exception {
        check("partners");
    }

    @Test
    @Tag("verify")
    void relays_copiesHaveTheirHops() throws Exception {
        check("relays");
    }

    @Test
    void moves_arePutTogether() throws Exception {
        check("hosts/walker");
    }
}
