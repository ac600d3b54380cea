package diffuser;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A MAS in a Java virtual machine of its own, with the log's settings of a project that {@code javino new} writes. */
@Tag("newerJava")
class StartFailuresTest {

    private static final Path SETTINGS = Path.of(System.getProperty("javino.root"),
            "javino-java/cli/src/main/resources/javino/cli/project/common/logging.properties");
    private static final String MAS = """
            MAS robot {
                agents: robot agentArchClass diffuser.Diffuser;
                aslSourcePath: "src/agt";
            }
            """;
    private static final String UNEXPECTED =
            " is not expected here; is a full stop, a semicolon or a bracket missing before it?";

    @TempDir
    private Path folder;

    private void assertEnds(String line, String mas, String program) throws Exception {
        assertEquals(line + "\n", run(1, mas, program));
    }

    private String run(int status, String mas, String program) throws IOException, InterruptedException {
        return run(folder, status, mas, program);
    }

    /** The output of a MAS in this folder until its end. */
    static String run(Path folder, int status, String mas, String program) throws IOException, InterruptedException {
        Files.writeString(folder.resolve("robot.mas2j"), mas);
        Files.createDirectories(folder.resolve("src/agt"));
        Files.writeString(folder.resolve("src/agt/robot.asl"), program);
        Files.writeString(folder.resolve("src/agt/other.asl"), "");
        Process process = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin/java").toString(), "-cp",
                System.getProperty("java.class.path"), "jason.infra.local.RunLocalMAS", "robot.mas2j", "--log-conf",
                SETTINGS.toString(), "--no-net").directory(folder.toFile()).redirectErrorStream(true).start();
        try {
            String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertEquals(status, process.waitFor(), said);
            return said;
        } finally {
            process.destroy();
        }
    }

    @Test
    void start_fullStopMissing_endsAndNamesTheLine() throws Exception {
        assertEnds("src/agt/robot.asl:5: +" + UNEXPECTED, MAS, "// A robot.\n\n!start\n\n+!start <- .print(hello).\n");
    }

    @Test
    void start_lastFullStopMissing_endsAndNamesTheLine() throws Exception {
        assertEnds("src/agt/robot.asl:2: the end of the file" + UNEXPECTED, MAS,
                "!start.\n+!start <- .print(hello)");
    }

    @Test
    void start_stringWithoutEnd_ends() throws Exception {
        assertEnds("no agent can start: jason.asSyntax.parser.TokenMgrError: Lexical error at line 3, column 0.  "
                + "Encountered: <EOF> after : \"\\\"hello).\\n\"", MAS, "!start.\n+!start <- .print(\"hello).\n");
    }

    @Test
    void start_noSuchAgent_endsAndNamesIt() throws Exception {
        assertEnds("agent robo cannot start: there is no file robo.asl; is the agent's name right in the .mas2j or"
                + " .jcm?", MAS.replace("agents: robot", "agents: robo"), "");
    }

    @Test
    void start_noSuchArchitecture_endsAndNamesIt() throws Exception {
        String said = run(1, MAS.replace("Diffuser", "Difuser"), "");
        // Jason itself writes a trace before.
        assertEquals("agent robot cannot start: there is no class diffuser.Difuser",
                said.lines().reduce("", (before, line) -> line));
    }

    @Test
    void start_wrongMas2j_endsAndNamesTheLine() throws Exception {
        assertEnds("robot.mas2j:3: :" + UNEXPECTED, MAS.replace("asl", "sl"), "");
    }

    @Test
    void createAgent_laterWithoutItsClass_endsNothing() throws Exception {
        String said = run(0, MAS, """
                !start.
                +!start <- .create_agent(other, "src/agt/other.asl", [agentArchClass("no.such.Class")]);
                   .wait(1); !over.
                -!start <- !over.
                +!over  <- .print("goes on"); .stopMAS.
                """);
        assertTrue(said.contains("[robot] goes on"), said);
    }
}
