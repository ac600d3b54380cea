package diffuser;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Jason's own unit tests, of an agent with a board. */
@Tag("newerJava")
class UnitTestsTest {

    private static final String MAS = """
            MAS tests {
                agents:
                    test_manager;
                    robot agentArchClass diffuser.Diffuser;
                aslSourcePath: "src/agt"; "$jasonJar/test/jason/inc";
            }
            """;
    private static final String TESTER = """
            { include("$jasonJar/test/jason/inc/tester_agent.asl") }

            @[test]
            +!it_is_dark <- .port(nowhere); .percepts(open); +dark; !assert_true(dark); .list_plans.
            """;

    @Test
    void tester_withItsArchitecture_hasAPortAndJasonsReportsKeepTheirLines(@TempDir Path folder) throws Exception {
        String said = StartFailuresTest.run(folder, 0, MAS, TESTER);
        assertTrue(said.contains("#1 tests executed, #1 PASSED and #0 failed.\n"), said);
        assertTrue(said.contains("\n// plans from file:src/agt/robot.asl\n\n@p__"), said);
        assertFalse(said.contains("\\u000a"), said);
    }
}
