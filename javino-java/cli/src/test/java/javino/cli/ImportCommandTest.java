package javino.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The files of an imported project; that those of a course run is in docs/verdict.md. */
class ImportCommandTest extends CommandFixture {

    private static final String SKETCH = "#include <Javino.h>\n#include <EEPROM.h>\n#include <LiquidCrystal.h>\n";

    @TempDir
    private Path folder;

    private static JsonArray list(String third, Map<String, String[]> of) {
        JsonArray list = new JsonArray();
        of.forEach((name, parts) -> {
            JsonObject one = new JsonObject();
            one.addProperty("name", name);
            if (parts.length == 2) {
                one.addProperty("archClass", parts[1]);
            }
            one.addProperty(third, parts[0]);
            list.add(one);
        });
        return list;
    }

    /** Imports a project; agents have a program and an architecture, sketches a program. */
    private Path imported(Map<String, String[]> agents, Map<String, String[]> sketches, String... options)
            throws IOException {
        JsonObject project = new JsonObject();
        project.add("agents", list("sourceCode", agents));
        project.add("firmwares", list("sourceCode", sketches));
        Path file = Files.writeString(folder.resolve("p.chon"), project.toString());
        Path into = folder.resolve("course");
        String[] line = new String[3 + options.length];
        line[0] = "import";
        System.arraycopy(options, 0, line, 1, options.length);
        line[1 + options.length] = file.toString();
        line[2 + options.length] = into.toString();
        assertEquals(0, run(line), err.toString());
        return into;
    }

    private static String text(Path file) throws IOException {
        return Files.readString(file);
    }

    @Test
    void agentAndSketch_areWrittenAsTheyAreAtTheAgentsPort() throws IOException {
        String program = "// serialPort(ttyACM9).\n+!start <- .argo.port(ttyUSB3).";
        Path project = imported(Map.of("bob", new String[] {program, "jason.Argo"}),
                Map.of("light", new String[] {SKETCH}));
        assertEquals(program, text(project.resolve("src/agt/bob.asl")));
        assertEquals(SKETCH, text(project.resolve("sketch/light/light.ino")));
        assertTrue(text(project.resolve("course.mas2j")).contains("bob agentArchClass jason.Argo;"));
        assertTrue(text(project.resolve("build.gradle"))
                .contains("'light'.tokenize().collectEntries { [it, 'arduino:avr:uno'] }"));
        JsonObject board = JsonParser.parseString(text(project.resolve("board.json"))).getAsJsonObject()
                .getAsJsonArray("boards").get(0).getAsJsonObject();
        assertEquals("ttyUSB3", board.get("port").getAsString());
        assertEquals("uno", board.get("model").getAsString());
        assertEquals("build/sketch/light.ino.elf", board.get("firmware").getAsString());
        assertEquals(List.of("sketch light includes LiquidCrystal.h: put that library into libraries/, unless your "
                + "Arduino sketchbook has it", "project course written; next: cd " + project + " && gradle run"),
                lines());
    }

    @Test
    void agentWithoutABoard_hasAProjectWithoutOne() throws IOException {
        Path project = imported(Map.of("alice", new String[] {"!hello.", "Jason"}), Map.of());
        assertFalse(Files.exists(project.resolve("board.json")));
        assertTrue(text(project.resolve("course.mas2j")).contains(" alice;"));
        assertTrue(text(project.resolve("build.gradle")).contains("ext.boards = ''."));
    }

    @Test
    void argoWithoutASketch_getsOneWithItsActions() throws IOException {
        Path project = imported(
                Map.of("bob",
                        new String[] {"+!a : ledStatus(on) & far(D) & not ledStatus(off) & .my_name(me) <- .act(ledOn);"
                                + " .argo.act(stop); .print(a). /* .act(never) */", "Argo"}),
                Map.of(),
                "--board", "mega");
        String sketch = text(project.resolve("sketch/Robot/Robot.ino"));
        assertTrue(sketch.contains("F(\"ledOn\")") && sketch.contains("F(\"stop\")") && !sketch.contains("never"),
                sketch);
        assertTrue(text(project.resolve("board.json")).contains("\"mega\""));
        assertTrue(lines().get(0).contains("sketch/Robot/Robot.ino is one of ours, with ledOn, stop"),
                lines()::toString);
        assertTrue(lines().get(1).contains("names no port: write serialPort(ttyUSB0)."), lines()::toString);
    }

    @Test
    void internalActionsOfALibrary_areTold() throws IOException {
        imported(
                Map.of("bob",
                        new String[] {"!a. +!a <- .velluscinum.buildWallet(w); .argo.act(x); .print(a).", "Jason"}),
                Map.of());
        assertTrue(lines().get(0).startsWith("agent bob uses .velluscinum, which is not here: "), lines()::toString);
        assertEquals(2, lines().size());
    }

    @ParameterizedTest
    @CsvSource({"Communicator, needs a server on the Internet", "jason.Communicator, needs a server on the Internet",
            "my.Own, 'no architecture my.Own is here'"})
    void agentOfAnArchitectureThatIsNotHere_isLeftOutAndTold(String architecture, String told) throws IOException {
        Path project = imported(Map.of("kirk", new String[] {"!go.", architecture}), Map.of());
        assertTrue(lines().get(0).startsWith("agent kirk is left out: ") && lines().get(0).contains(told),
                lines()::toString);
        assertEquals("project course written; none of its agents runs here", lines().get(1));
        assertFalse(text(project.resolve("course.mas2j")).contains("kirk"));
        assertTrue(Files.exists(project.resolve("src/agt/kirk.asl")));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"''", "{", "[]", "{'agents':[]}", "{'agents':[],'firmwares':{}}",
            "{'agents':[{'name':'a','archClass':'Jason'}],'firmwares':[]}",
            "{'agents':[{'name':'../a','archClass':'Jason','sourceCode':''}],'firmwares':[]}",
            "{'agents':[{'name':'A','archClass':'Jason','sourceCode':''}],'firmwares':[]}",
            "{'agents':[],'firmwares':[{'name':'a/b','sourceCode':''}]}",
            "{'agents':[],'firmwares':[{'name':'a','sourceCode':''},{'name':'a','sourceCode':''}]}",
            "{'agents':[{'name':'a','archClass':7,'sourceCode':null}],'firmwares':[]}"})
    void fileOfAnythingElse_isRefusedAndNothingIsWritten(String json) throws IOException {
        Path file = Files.writeString(folder.resolve("p.chon"), json.replace('\'', '"'));
        Path into = folder.resolve("course");
        assertFails(1, file + ": no project of ChonIDE: ", "import", file.toString(), into.toString());
        assertFalse(Files.exists(into));
    }
}
