package uppaal.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import uppaal.check.Query;

class FaultsTest {
    private static final Suite SUITE = new Suite(Path.of("models"));
    private static final List<Kill> KILLS = Faults.ALL.stream().map(fault -> Kill.of(fault, SUITE)).toList();

    @Test
    void kills_everyFault_isNoticed() {
        assertEquals(List.of(),
                KILLS.stream().filter(kill -> !kill.caught()).map(kill -> kill.fault().name()).toList());
    }

    @ParameterizedTest
    @CsvSource({
            "wrong guard, '', 'S1 S2 S8', 'Q1 Q2 Q3 Q4'", "no acknowledgement, '', 'S3 S13', 'Q1 Q4'",
            "binary channels, '', 'S2 S3 S12 S13 S15', 'Q1 Q3 Q4'", "lost unicast, P5, 'S1 S4 S11', 'Q1 Q2'",
            "channel kept, '', S16, Q1",
            "plain unicast, '', S14, ''"})
    void kill_fault_isNoticedByTheseProperties(String fault, String paper, String stronger, String quiet) {
        Kill kill =
                KILLS.stream().filter(candidate -> candidate.fault().name().equals(fault)).findFirst().orElseThrow();
        assertEquals(List.of(paper, stronger, quiet), List.of(String.join(" ", kill.paper()),
                String.join(" ", kill.stronger()), String.join(" ", kill.quiet())));
    }

    @Test
    void kills_everyStrongerProperty_noticesSomething() {
        Set<String> useful =
                KILLS.stream().flatMap(kill -> kill.stronger().stream()).collect(Collectors.toCollection(TreeSet::new));
        assertEquals(SUITE.strongerQueries().stream().map(Query::name).collect(Collectors.toCollection(TreeSet::new)),
                useful);
    }

    @Test
    void readme_faults_areThoseThatAreFound() throws IOException {
        String readme = Files.readString(Path.of("README.md"));
        for (Kill kill : KILLS) {
            String row =
                    "| " + kill.fault().name() + ": " + kill.fault().sentence() + " | " + Report.names(kill.paper())
                            + " | " + Report.names(kill.stronger()) + " | " + Report.names(kill.quiet()) + " |";
            assertTrue(readme.contains(row), () -> "README.md needs the row " + row);
        }
    }

    @Test
    void in_faultThatNoLongerApplies_isSaid() {
        Fault fault = new Fault("none", "nothing", Fault.removed("Channel", "Released -> Nowhere"));
        assertTrue(assertThrows(IllegalArgumentException.class, () -> fault.in(SUITE.paper())).getMessage()
                .contains("changes nothing"));
    }
}
