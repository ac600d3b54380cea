package javino.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Properties;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The files of a new project; that it builds and runs is tested with an emulated board (test/system). */
class NewCommandTest extends CommandFixture {

    @TempDir
    private Path folder;

    private List<Path> files(Path project) throws IOException {
        try (Stream<Path> files = Files.walk(project)) {
            return files.filter(Files::isRegularFile).map(project::relativize).sorted().toList();
        }
    }

    private static String text(Path file) throws IOException {
        return Files.readString(file);
    }

    @Test
    void new_name_writesAProjectForJason() throws IOException {
        Path project = folder.resolve("my-robot");
        assertEquals(0, run("new", project.toString()), err.toString());
        assertEquals(List.of("project my-robot written; next: cd " + project + " && gradle run"), lines());
        assertEquals(Stream.of(".gitignore", "README.md", "board.json", "build.gradle", "gradle.properties",
                "javino.gradle", "logging.properties", "robot.mas2j", "settings.gradle", "sketch/Robot/Robot.ino",
                "src/agt/robot.asl", "src/test/features/robot.feature").map(Path::of).toList(), files(project));
        assertTrue(text(project.resolve("settings.gradle")).contains("'my-robot'"));
        assertTrue(text(project.resolve("README.md")).contains("`robot.mas2j`"));
    }

    @Test
    void new_jacamo_hasTheSameBoardInAProjectOfJaCaMo() throws IOException {
        Path jason = folder.resolve("one");
        Path jacamo = folder.resolve("two");
        assertEquals(0, run("new", "--jason", jason.toString()), err.toString());
        assertEquals(0, run("new", "--jacamo", jacamo.toString()), err.toString());
        for (String same : List.of("sketch/Robot/Robot.ino", "board.json", "javino.gradle")) {
            assertEquals(text(jason.resolve(same)), text(jacamo.resolve(same)));
        }
        String library = "org.javino:diffuser-arch:";
        String version = text(jason.resolve("build.gradle")).split(library)[1].split("'")[0];
        assertTrue(version.matches("\\d+\\.\\d+.*"), version);
        String mas = text(jacamo.resolve("robot.jcm"));
        assertTrue(mas.contains("ag-arch: diffuser.Diffuser\n"), mas);
        assertTrue(mas.contains("uses package: javino \"" + library + version + "\"\n"), mas);
        assertTrue(text(jacamo.resolve(".jcm-deps.gradle")).contains("implementation('" + library + version + "')"));
        assertTrue(text(jacamo.resolve("README.md")).contains("`robot.jcm`"));
        assertTrue(text(jacamo.resolve("src/test/features/robot.feature")).contains("the agent teller"));
        for (String file : List.of("src/agt/teller.asl", "src/env/house/Diary.java", "src/org/house.xml")) {
            assertTrue(Files.exists(jacamo.resolve(file)), file);
            assertTrue(text(jacamo.resolve("README.md")).contains("`" + file + "`"), file);
            assertFalse(text(jason.resolve("README.md")).contains(file), file);
        }
        for (String named : List.of("agent teller : teller.asl", "artifact diary : house.Diary()",
                "organisation house : house.xml")) {
            assertTrue(mas.contains(named), mas);
        }
        assertTrue(text(jacamo.resolve("build.gradle")).matches("(?s).*'org\\.jacamo:jacamo:\\d.*"));
    }

    @ParameterizedTest
    @CsvSource({"mega, arduino:avr:mega:cpu=atmega2560, mega, Mega, atmega2560",
            "uno, arduino:avr:uno, uno, Uno, atmega328p",
            "nano, arduino:avr:nano:cpu=atmega328, uno, Nano, atmega328p",
            "nano-old, arduino:avr:nano:cpu=atmega328old, uno, Nano with the old boot loader, atmega328p",
            "pro-mini, arduino:avr:pro:cpu=8MHzatmega328, promini, Pro Mini, atmega328p"})
    void new_board_isThatOfSketchEmulatorAndReadme(String board, String fqbn, String emulated, String title,
            String chip)
            throws IOException {
        Path project = folder.resolve("robot");
        assertEquals(0, run("new", "--board", board, project.toString()), err.toString());
        assertTrue(text(project.resolve("build.gradle")).contains("[Robot: '" + fqbn + "']"));
        assertTrue(text(project.resolve("board.json")).contains("\"model\": \"" + emulated + "\""));
        String readme = text(project.resolve("README.md"));
        assertTrue(readme.contains("## With a real " + title + "\n") && readme.contains("avrdude -p " + chip + " "),
                readme);
    }

    @ParameterizedTest
    @ValueSource(strings = {"--jason", "--jacamo"})
    void new_twoBoards_areASensorUnoAndAnArmMega(String kind) throws IOException {
        Path project = folder.resolve("robot");
        assertEquals(0, run("new", kind, "--boards", "2", project.toString()), err.toString());
        for (Path file : files(project)) {
            assertFalse(text(project.resolve(file)).matches("(?s).*@\\w+@.*"), file.toString());
        }
        String gradle = text(project.resolve("build.gradle"));
        assertTrue(gradle.contains("[Robot: 'arduino:avr:uno', Arm: 'arduino:avr:mega:cpu=atmega2560']"), gradle);
        assertTrue(text(project.resolve("src/agt/robot.asl")).contains("\n    .port(\"ports/arm\", arm);"));
        assertTrue(text(project.resolve("sketch/Arm/Arm.ino")).contains("F(\"close\")"));
        assertTrue(text(project.resolve("README.md")).contains("`sketch/Arm/Arm.ino`"));
    }

    @Test
    void new_threeBoards_isWrongUsage() {
        assertFails(2, "a new project has 1 or 2 boards, not 3", "new", "--boards", "3",
                folder.resolve("robot").toString());
    }

    @Test
    void new_unknownBoard_isWrongUsageAndNamesThoseThatThereAre() {
        assertFails(2, "the boards are mega, uno, nano, nano-old and pro-mini, not due", "new", "--board", "due",
                folder.resolve("robot").toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"--jason", "--jacamo"})
    void new_readme_hasTheLineForAgentsThatMove(String kind) throws IOException {
        Path project = folder.resolve("robot");
        assertEquals(0, run("new", kind, project.toString()), err.toString());
        String readme = text(project.resolve("README.md"));
        assertTrue(readme.matches("(?s).*`implementation 'org\\.javino:mobility:\\d+\\.\\d+.*?'`.*"), readme);
        assertTrue(text(project.resolve(".gitignore")).contains("\nmoves/\n"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"--jason", "--jacamo"})
    void new_files_haveNoPlaceholderLeft(String kind) throws IOException {
        Path project = folder.resolve("robot");
        assertEquals(0, run("new", kind, project.toString()), err.toString());
        for (Path file : files(project)) {
            assertFalse(text(project.resolve(file)).matches("(?s).*@\\w+@.*"), file.toString());
        }
    }

    @Test
    void new_properties_nameJavinosFolder() throws IOException {
        Path project = folder.resolve("robot");
        assertEquals(0, run("new", project.toString()), err.toString());
        Properties properties = new Properties();
        try (Reader lines = Files.newBufferedReader(project.resolve("gradle.properties"))) {
            properties.load(lines);
        }
        assertEquals(System.getProperty("javino.home"), properties.getProperty("javinoHome"));
    }

    @Test
    void new_folderOfJavinoWithOddLetters_isReadBackFromTheProperties() throws IOException {
        Path project = folder.resolve("robot");
        String usual = System.setProperty("javino.home", "/home/josé/a=b\\c #d");
        try {
            assertEquals(0, run("new", project.toString()), err.toString());
        } finally {
            System.setProperty("javino.home", usual);
        }
        Properties properties = new Properties();
        try (Reader lines = Files.newBufferedReader(project.resolve("gradle.properties"))) {
            properties.load(lines);
        }
        assertEquals("/home/josé/a=b\\c #d", properties.getProperty("javinoHome"));
    }

    @Test
    void new_notInstalled_saysWhichToCall() {
        String home = System.clearProperty("javino.home");
        try {
            assertFails(1, "call bin/javino in it", "new", folder.resolve("robot").toString());
        } finally {
            System.setProperty("javino.home", home);
        }
    }

    @Test
    void new_folderThere_leavesItAsItIs() throws IOException {
        Path project = Files.createDirectory(folder.resolve("robot"));
        Files.writeString(project.resolve("build.gradle"), "precious");
        assertFails(1, project + ": it is there already; move it away first", "new", project.toString());
        assertEquals(List.of(Path.of("build.gradle")), files(project));
        assertEquals("precious", text(project.resolve("build.gradle")));
    }

    @ParameterizedTest
    @ValueSource(strings = {"7robot", "my robot", "-", "r'b", "räuber", ".", "..", "/"})
    void new_badName_isWrongUsage(String name) throws IOException {
        assertFails(2, "a letter first, not", "new", "--", name);
        assertEquals(List.of(), files(folder));
    }

    @Test
    void new_badNameInAFolder_writesNothing() throws IOException {
        assertFails(2, "a letter first, not", "new", folder.resolve("deep/my robot").toString());
        assertFalse(Files.exists(folder.resolve("deep")));
    }

    @Test
    void new_bothKinds_isWrongUsage() {
        assertFails(2, "--jacamo", "new", "--jason", "--jacamo", folder.resolve("robot").toString());
    }

    @Test
    void new_noName_isWrongUsage() {
        assertFails(2, "FOLDER", "new");
    }
}
