package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.Gson;
import com.google.gson.JsonObject;
import harness.AgentProcess;
import harness.Platform;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import trace.EmulatorControl;
import trace.TraceEvent;
import trace.TraceReader;

/**
 * Projects that {@code javino new} has written, built and run as its user does who has a release, and no clone. Tests
 * share three, each of which compiles the library once.
 */
@Timeout(value = 10, unit = TimeUnit.MINUTES)
@Tag("verify")
class NewProjectTest {

    private static final long PATIENCE_SECONDS = 240;
    private static final String JAVA_HOME = System.getProperty("java.home");
    private static final String QUICK_START = "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC";

    @TempDir
    private static Path unpacked;
    @TempDir
    private static Path projects;
    private static Path home;
    private static Path onMega;
    private static Path onUno;
    private static Path ofJaCaMo;

    @BeforeAll
    static void install() throws Exception {
        home = Release.unpack(unpacked);
        onMega = projects.resolve("my-robot");
        onUno = projects.resolve("my-uno");
        assertEquals(0, newProject(onMega).waitFor());
        assertEquals(0, newProject(onUno, "--boards", "2").waitFor());
        // The project's library goes before the other of its name; the published library does not go before ours, which
        // has the Javino.h too if JavinoBDI.h is included first.
        Path sketchbook = projects.resolve("Arduino/libraries");
        write(onUno.resolve("libraries/Lamp/Lamp.h"), "#define LAMP 13");
        write(sketchbook.resolve("Lamp/Lamp.h"), "#error not that of the project");
        write(sketchbook.resolve("Dark/Dark.h"), "#define DARK 300");
        write(sketchbook.resolve("Javino/Javino.h"), "#error not ours");
    }

    @AfterAll
    static void endDaemon() throws Exception {
        assertEquals(0, byDaemon("--stop").directory(projects.toFile()).inheritIO().start().waitFor());
    }

    @Test
    void run_lightsTheLampWhileItIsDarkAndLeavesNothing() throws Exception {
        Path trace = onMega.resolve("build/trace.jsonl");

        try (AgentProcess gradle = AgentProcess.start(
                gradle("run", "-Plive", "-Pheadless").directory(onMega.toFile()))) {
            gradle.await(" s lamp off", 2);
            gradle.await("[robot] my lamp is off", 2);
            assertTrue(gradle.lines().stream().anyMatch(line -> line.startsWith("http://127.0.0.1:")));
            // The page's record has the agent's words beside the board's trace.
            assertTrue(TraceReader.all(trace).stream().anyMatch(event -> event.is("said", "robot")
                    && event.text("agent").equals("robot") && event.text("text").equals("my lamp is on")));
            List<TraceEvent> lamp = lamp(trace);
            assertEquals(List.of(1, 0, 1, 0), lamp.stream().map(event -> event.number("level")).toList());
            double greeted = lamp.get(0).seconds();
            assertBetween(greeted + 4, lamp.get(2).seconds(), greeted + 9);    // board.json: night
            assertTrue(lamp.get(3).seconds() > greeted + 9, () -> String.join("\n", gradle.lines()));
            for (String said : List.of("[robot] my board at ports/robot is on", "[robot] it is dark: ",
                    "[robot] it is bright again: ", "[robot] my lamp is on")) {
                assertTrue(gradle.lines().stream().anyMatch(line -> line.contains(said)),
                        () -> said + " is missing:\n" + String.join("\n", gradle.lines()));
            }
        }
        awaitGone(onMega.resolve("ports/robot"));
        assertTrue(why(onMega, "lamp(on)").contains("robot's board tells light("), why(onMega, "lamp(on)"));
    }

    /** What the terminal answers by the log of the run that ends now. */
    private static String why(Path project, String what) throws Exception {
        awaitThere(project.resolve("build/run.jsonl"), () -> "no log of the run");
        ProcessBuilder why = new ProcessBuilder(home.resolve("bin/javino").toString(), "why", "build/run.jsonl", what)
                .directory(project.toFile()).redirectErrorStream(true);
        why.environment().put("JAVA_HOME", JAVA_HOME);
        return new String(why.start().getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }

    /** Of a board behind a port one knows what its agent knows. */
    @Test
    void agent_withARealBoard_isWatchedAndAnswers() throws Exception {
        assertTrue(gradleSays(onUno, "sketch").startsWith("0\n"));
        try (AgentProcess board = board(onUno)) {
            awaitThere(onUno.resolve("ports/robot"), () -> String.join("\n", board.lines()));
            try (AgentProcess gradle = AgentProcess.start(gradle("agent", "-Plive", "-Pheadless")
                    .directory(onUno.toFile()))) {
                gradle.await("[robot] my lamp is off", 2);
            }
        }
        List<TraceEvent> shown = TraceReader.all(onUno.resolve("build/trace.jsonl"));
        for (String event : List.of("board", "percepts", "acted", "said")) {
            assertTrue(shown.stream().anyMatch(each -> each.is(event, "robot")), event);
        }
        String answer = why(onUno, "lampOn");
        assertTrue(
                answer.contains("robot asks its board for lampOn") && answer.contains("first cause: !start is a goal")
                        || answer.contains("first cause: the board at ports/robot told it"),
                answer);
    }

    /** As ChonIDE writes projects, with a sketch for the published library; the port is a link in the project. */
    @Test
    void import_ofAProjectOfChonIde_runsItUnchanged() throws Exception {
        Path file = projects.resolve("light.chon");
        Path project = projects.resolve("light");
        JsonObject keeper = new JsonObject();
        keeper.addProperty("name", "keeper");
        keeper.addProperty("archClass", "jason.Argo");
        keeper.addProperty("sourceCode", "serialPort(ttyUSB0). !start.\n"
                + "+!start : serialPort(P) <- .argo.port(P); .argo.limit(500); .argo.percepts(open).\n"
                + "+light(off) <- .argo.act(lightOn); .send(friend, tell, lit). +light(on) <- .argo.act(lightOff).\n");
        JsonObject friend = new JsonObject();
        friend.addProperty("name", "friend");
        friend.addProperty("archClass", "Jason");
        friend.addProperty("sourceCode", "+lit <- .print(\"there is light\").\n");
        JsonObject sketch = new JsonObject();
        sketch.addProperty("name", "light");
        sketch.addProperty("sourceCode", "#include <Javino.h>\nJavino javino;\n"
                + "void lightOn() { digitalWrite(13, HIGH); }\nvoid lightOff() { digitalWrite(13, LOW); }\n"
                + "void see() { javino.addPercept(digitalRead(13) ? \"light(on)\" : \"light(off)\"); }\n"
                + "void setup() { pinMode(13, OUTPUT); javino.act[\"lightOn\"] = lightOn;\n"
                + "  javino.act[\"lightOff\"] = lightOff; javino.perceive(see); javino.start(9600); }\n"
                + "void loop() { javino.run(); }\n");
        JsonObject chon = new JsonObject();
        chon.add("agents", new Gson().toJsonTree(List.of(keeper, friend)));
        chon.add("firmwares", new Gson().toJsonTree(List.of(sketch)));
        Files.writeString(file, chon.toString());
        assertEquals(0, javino(List.of("import", file.toString(), project.toString())).waitFor());

        try (AgentProcess gradle = AgentProcess.start(gradle("run").directory(project.toFile()))) {
            gradle.await("[friend] there is light");
        }
        awaitGone(project.resolve("ttyUSB0"));
    }

    @Test
    void run_agentCannotStart_endsWithOneLineAndLeavesNothing(@TempDir Path folder) throws Exception {
        Path program = onMega.resolve("src/agt/robot.asl");
        String good = Files.readString(program);
        Files.writeString(program, good.replace("!start.\n", "!start\n"));

        Path said = folder.resolve("said");
        int status = gradle("run").directory(onMega.toFile()).redirectErrorStream(true).redirectOutput(said.toFile())
                .start().waitFor();
        Files.writeString(program, good);

        List<String> lines = Files.readAllLines(said);
        assertEquals(1, status, () -> String.join("\n", lines));
        // Gradle writes the task's name before what the task writes first.
        assertEquals(1, lines.stream().filter(line -> line.endsWith("src/agt/robot.asl:5: + is not expected here; is a"
                + " full stop, a semicolon or a bracket missing before it?")).count(), () -> String.join("\n", lines));
        awaitGone(onMega.resolve("ports/robot"));
    }

    @Test
    void sketch_forAnUno_takesLibrariesOfProjectAndSketchbookAndTellsItsSize(@TempDir Path folder) throws Exception {
        Path sketch = onUno.resolve("sketch/Robot/Robot.ino");
        String asNew = Files.readString(sketch);
        Files.writeString(sketch, "#include <JavinoBDI.h>\n#include <Javino.h>\n#include <Lamp.h>\n#include <Dark.h>\n"
                + "static_assert(LAMP + DARK == 313, \"\");\n" + asNew);

        Path said = folder.resolve("said");
        int status = byDaemon("sketch", "-Duser.home=" + projects).directory(onUno.toFile()).redirectErrorStream(true)
                .redirectOutput(said.toFile()).start().waitFor();
        Files.writeString(sketch, asNew);

        String text = Files.readString(said);
        assertEquals(0, status, text);
        assertFalse(text.contains("Multiple libraries were found for \"Javino"), text);
        assertTrue(text.contains("Maximum is 32256 bytes.") && text.contains("Maximum is 2048 bytes."), text);
        assertTrue(Files.size(onUno.resolve("build/sketch/Robot.ino.hex")) > 0);
    }

    @Test
    void sketch_tooLargeForAnUno_isAnsweredByTheLibrarysPage(@TempDir Path folder) throws Exception {
        Path sketch = onUno.resolve("sketch/Robot/Robot.ino");
        String asNew = Files.readString(sketch);
        Files.writeString(sketch, asNew
                .replaceFirst("(?m)^JavinoBoard", "const char TABLE[32000] PROGMEM = {};\n$0")
                .replaceFirst("void setup\\(\\) \\{", "$0 Serial.write(pgm_read_byte(TABLE + millis()));"));

        Path said = folder.resolve("said");
        int status = byDaemon("sketch", "-Duser.home=" + projects).directory(onUno.toFile()).redirectErrorStream(true)
                .redirectOutput(said.toFile()).start().waitFor();
        Files.writeString(sketch, asNew);

        String text = Files.readString(said);
        assertTrue(status != 0, text);
        List<String> answers = text.lines().filter(line -> line.startsWith("The sketch is too large")).toList();
        assertEquals(1, answers.size(), text);
        String section = Files.readString(SketchBuild.ROOT.resolve("javino-firmware/README.md"))
                .split("\n### What takes flash\n")[1].split("\n#")[0];
        List<String> figures =
                Pattern.compile("\\b\\d{3,}\\b").matcher(section).results().map(MatchResult::group).toList();
        assertFalse(figures.isEmpty(), section);
        figures.forEach(figure -> assertTrue(answers.get(0).contains(" " + figure), text));
        assertTrue(answers.get(0).contains("JavinoUnicastBoard in place of JavinoRadioBoard takes "), text);
        assertTrue(answers.get(0).endsWith(" Or take a Mega."), text);
    }

    /** As its user calls it; what Gradle says, behind its exit status. */
    private static String gradleSays(Path project, String... arguments) throws Exception {
        Path said = project.resolveSibling("said");
        int status = byDaemon(arguments).directory(project.toFile()).redirectErrorStream(true)
                .redirectOutput(said.toFile()).start().waitFor();
        return status + "\n" + Files.readString(said);
    }

    @Test
    void test_playsTheFeatureAndNamesWhatIsWrong() throws Exception {
        Path project = onMega;
        String passed = gradleSays(project, "test");
        assertTrue(passed.startsWith("0\n") && passed.contains("scenarios: 3 passed"), passed);
        assertTrue(Files.readString(project.resolve("build/test-results/features/TEST-features.xml"))
                .contains("it gets dark"));
        assertTrue(Files.size(project.resolve("build/reports/features.html")) > 0);
        awaitGone(project.resolve("ports/robot"));

        Path agent = project.resolve("src/agt/robot.asl");
        String program = Files.readString(agent);
        Files.writeString(agent, program.replace(".print(\"it is dark: \", L); .act(lampOn)", ".act(lampOm)"));
        String failed = gradleSays(project, "test", "-Pfeature=src/test/features/robot.feature:9", "-Pseed=3");
        assertTrue(failed.startsWith("1\n") && failed.contains("scenarios: 1 failed"), failed);
        assertTrue(failed.contains("robot has not performed lampOm: unknown_action"), failed);
        assertTrue(failed.contains("gradle test -Pfeature=src/test/features/robot.feature:6 -Pseed=3"), failed);

        Files.writeString(agent, program.replace("!start.\n", "!start\n"));
        String wrong = gradleSays(project, "test");
        assertTrue(wrong.startsWith("1\n") && wrong.contains("the scenario cannot start: ")
                && wrong.contains("src/agt/robot.asl:5: + is not expected here"), wrong);
        Files.writeString(agent, program);

        assertTrue(gradleSays(project, "bundle").startsWith("0\n"));
        try (Stream<Path> jars = Files.list(project.resolve("build/bundle/lib"))) {
            assertEquals(List.of(), jars.map(jar -> jar.getFileName().toString())
                    .filter(jar -> jar.matches("(features|lockstep|trace|cucumber).*")).toList());
        }
    }

    @Test
    void test_ofTwoBoards_playsTheFeature() throws Exception {
        String said = gradleSays(onUno, "test");
        assertTrue(said.startsWith("0\n") && said.contains("scenarios: 4 passed"), said);
    }

    /**
     * A board behind a port, of which Gradle knows nothing else; the test is the person who moves its sensor and pulls
     * its cable. It runs by the clock: no window here may be too short for a busy machine.
     */
    @Test
    void test_onARealBoard_asksThePersonAndListsWhatItCannotCheck(@TempDir Path desk) throws Exception {
        Path feature = onMega.resolve("src/test/features/robot.feature");
        String asNew = Files.readString(feature);
        assertTrue(gradleSays(onMega, "sketch").startsWith("0\n"));
        Files.writeString(feature, asNew.replaceAll("within 1 s (?!it performs|robot's)", "within 60 s ")
                .replace("Then the agent robot believes", "Then within 60 s the agent robot believes"));
        Files.writeString(desk.resolve("board.json"), Files.readString(onMega.resolve("board.json"))
                .replaceAll("\"light\": .*\\]\\],", "\"light\": [[0, 700]],")
                .replace("build/sketch", onMega.resolve("build/sketch").toString()));
        Path port = desk.resolve("ports/robot");
        EmulatorControl board = EmulatorControl.at(desk.resolve("control"));
        Path said = desk.resolve("said");

        try (AgentProcess emulator = AgentProcess.start(new ProcessBuilder(
                home.resolve("bin/javino-emulator").toString(), "board.json", "--control", "control", "--trace", "-")
                .directory(desk.toFile()))) {
            awaitThere(port, () -> String.join("\n", emulator.lines()));
            Process test = byDaemon("test", "-Pport=" + port).directory(onMega.toFile()).redirectErrorStream(true)
                    .redirectOutput(said.toFile()).start();
            try (PrintWriter person = new PrintWriter(test.outputWriter(), true)) {
                List<Map<String, ?>> dark =
                        List.of(Map.of("do", "sensor", "board", "robot", "pin", "A0", "value", 150));
                emulator.await("\"name\":\"lamp\",\"level\":0}");        // the greeting is over
                does(test, said, "falls to 150", board, dark);
                emulator.await("\"name\":\"lamp\",\"level\":1}", 2);     // what the person sees before Enter counts
                person.println();
                does(test, said, "falls to 100", board, List.of());
                person.println();
                does(test, said, "is unplugged for 2 s", board, List.of(Map.of("do", "unplug", "board", "robot"),
                        Map.of("do", "plug", "board", "robot")));
                person.println();
                assertEquals(0, test.waitFor(), () -> text(said));
            } finally {
                test.descendants().forEach(ProcessHandle::destroy);
                test.destroy();
            }
            assertTrue(text(said).contains("""
                    scenarios: 3 passed
                    not checked on the real board:
                      robot.feature:7  Given within 1 s robot's lamp is off
                      robot.feature:9  Then within 500 ms robot's lamp is on
                    """), () -> text(said));

            ProcessBuilder doctor = new ProcessBuilder(home.resolve("bin/javino").toString(), "doctor", "--report",
                    "--listen", "0", "--port", port.toString()).directory(onMega.toFile());
            doctor.environment().put("JAVA_HOME", JAVA_HOME);
            String report = new String(doctor.start().getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertTrue(Pattern.compile("(?m)^features +3 passed; steps not checked: 2$").matcher(report).find(),
                    report);
        } finally {
            Files.writeString(feature, asNew);
        }
    }

    /** When it is asked for a step, the person does something at the board. */
    private static void does(Process test, Path said, String step, EmulatorControl board, List<Map<String, ?>> acts)
            throws Exception {
        while (!text(said).contains(step + "\n  make that so at the board")) {
            assertTrue(test.isAlive() && !text(said).contains("\nfailed: "), () -> text(said));
            Thread.sleep(50);
        }
        for (Map<String, ?> act : acts) {
            board.perform(act);
        }
    }

    private static String text(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void awaitThere(Path file, Supplier<String> otherwise) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (!Files.exists(file)) {
            assertTrue(System.nanoTime() < end, otherwise);
            Thread.sleep(50);
        }
    }

    /** What students do wrong: the file, what stands there, what they write, and what they are told of it. */
    @Tag("soak")
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
            "sketch/Robot/Robot.ino|LED_BUILTIN, |12, |robot's pin 12 goes off",
            "sketch/Robot/Robot.ino|`LED_BUILTIN, HIGH`|`LED_BUILTIN, LOW`|it is off all the time",
            "sketch/Robot/Robot.ino|board.run();|board.run(); delay(3000);|does its loop() wait, as by delay()?",
            "sketch/Robot/Robot.ino|percepts.literal(|for (int i = 0; i < 60; i++) "
                    + "percepts.add(F(\"aVeryLongNameOfAPercept\"), i); percepts.literal(|perceptsLeftOut",
            "src/agt/robot.asl|`, L); .act(lampOn)`|`, L); .act(lampOm)`|has not performed lampOm: unknown_action",
            "src/agt/robot.asl|+light(L) : L < 300|+brightness(L) : L < 300|+brightness/1 (robot.asl:12)",
            "sketch/Robot/Robot.ino|`analogRead(A0), 4)`|analogRead(A0))|seen 6 times within",
            "src/agt/robot.asl|` & not dark`|` `|not within 1 s it performs lampOn",
            "src/agt/robot.asl|.percepts(open);|.print(a);|its plans need .percepts(open)",
    })
    void test_ofAFault_failsAndNamesItsPlace(String file, String right, String wrong, String told) throws Exception {
        Path changed = onMega.resolve(file);
        String good = Files.readString(changed);
        assertTrue(good.contains(right), good);
        Files.writeString(changed, good.replace(right, wrong));
        String said = gradleSays(onMega, "test");
        Files.writeString(changed, good);
        assertTrue(said.startsWith("1\n") && said.contains(told), said);
    }

    private static void write(Path file, String line) throws IOException {
        Files.createDirectories(file.getParent());
        Files.writeString(file, line + "\n");
    }

    /** A property hides what has its name in a build file. */
    @ParameterizedTest
    @ValueSource(strings = {"--jason", "--jacamo"})
    void run_withThePropertiesOfPages_isTaken(String kind, @TempDir Path folder) throws Exception {
        Path project = folder.resolve("my-robot");
        assertEquals(0, newProject(project, kind).waitFor());
        assertEquals(0,
                byDaemon("--dry-run", "--offline", "tasks", "sketch", "-Pagent=robot", "-Plive=", "-Precord",
                        "-Pjacamo=repository",
                        "-Pfeature=a.feature:3", "-Pseed=2", "-Pport=/dev/ttyACM0")
                        .directory(project.toFile()).inheritIO().start().waitFor());
    }

    @Test
    void bundle_takenElsewhere_runsByJavaAlone(@TempDir Path folder) throws Exception {
        assertEquals(0, byDaemon("bundle").directory(onMega.toFile()).inheritIO().start().waitFor());
        Path bundle = Files.move(onMega.resolve("build/bundle"), folder.resolve("robot"));
        assertTrue(Files.size(bundle.resolve("Robot.ino.hex")) > 0);
        Files.createSymbolicLink(bundle.resolve("ports"), onMega.resolve("ports"));

        try (AgentProcess board = board(onMega); AgentProcess agent = agents(bundle, Platform.USUAL, "robot.mas2j")) {
            board.await("\"name\":\"lamp\",\"level\":1}");
            agent.await("[robot] my lamp is off");
        }
    }

    /** The project is made by the first test that JaCaMo is there for. */
    private static Path projectOfJaCaMo() throws Exception {
        if (ofJaCaMo == null) {
            ofJaCaMo = projects.resolve("my-house");
            assertEquals(0, newProject(ofJaCaMo, "--jacamo").waitFor());
        }
        return ofJaCaMo;
    }

    /** In real time, so that no window here may be too short for a busy machine. */
    @Test
    void test_ofJaCaMo_playsTheFeatureAndSaysWhatWasSeen() throws Exception {
        JaCaMo.platform("jacamo");
        Path project = projectOfJaCaMo();
        Path feature = project.resolve("src/test/features/robot.feature");
        Files.writeString(feature, Files.readString(feature).replaceAll("within \\d+ s", "within 60 s")
                .replace("Then the agent robot believes", "Then within 60 s the agent robot believes")
                + "\n  Scenario: no other entry\n    When the agent robot gets the belief told\n"
                + "    Then within 4 s the agent teller believes entry(9, Text)\n");

        String said = gradleSays(project, "-Pjacamo=" + System.getProperty("javino.jacamoRepository"), "test");
        assertTrue(said.startsWith("1\n") && said.contains("scenarios: 2 passed, 1 failed"), said);
        assertTrue(said.contains("passed: dusk and dawn") && said.contains("teller does not come to believe entry(9"),
                said);
        List<Double> times = Pattern.compile("(?m)(?:^  at|since) ([\\d.]+) s:").matcher(said).results()
                .map(found -> Double.valueOf(found.group(1))).toList();
        assertTrue(times.size() == 2 && times.get(0) >= times.get(1) + 12, said);   // three times as long
        assertTrue(Pattern.compile("(?m)^  robot believes: .*\\btold\\b").matcher(said).find(), said);
        awaitGone(project.resolve("ports/robot"));
    }

    @Test
    void run_ofJaCaMo_isWatchedAndAnswers() throws Exception {
        JaCaMo.platform("jacamo");
        Path project = projectOfJaCaMo();
        try (AgentProcess gradle = AgentProcess.start(gradle("-Pjacamo=" + System.getProperty(
                "javino.jacamoRepository"), "run", "-Plive", "-Pheadless").directory(project.toFile()))) {
            gradle.await("[teller] the night has 2 entries");
        }
        awaitGone(project.resolve("ports/robot"));
        List<TraceEvent> shown = TraceReader.all(project.resolve("build/trace.jsonl"));
        for (String agent : List.of("robot", "teller")) {
            assertTrue(shown.stream().anyMatch(each -> each.is("beliefs") && each.text("agent").equals(agent)), agent);
        }
        String answer = why(project, "lamp(on)");
        assertTrue(answer.contains("robot's board tells light("), answer);
    }

    @Test
    void bundle_ofJaCaMo_runsItsOrganisationUnderBothVersions() throws Exception {
        Platform jacamo = JaCaMo.platform("jacamo");
        Platform newer = JaCaMo.platform("newerJacamo");
        Path project = projectOfJaCaMo();
        Files.writeString(project.resolve(".jcm-deps.gradle"), "");
        runByJaCaMo(project, "buildJCMDeps");
        runByJaCaMo(project, "bundle");
        assertNightIsTold(project, jacamo);

        Path build = project.resolve("build.gradle");
        String asNew = Files.readString(build);
        Files.writeString(build, asNew.replaceAll("(org.jacamo:jacamo:)[0-9.]+",
                "$1" + System.getProperty("javino.newerJacamoVersion")));
        runByJaCaMo(project, "bundle");
        Files.writeString(build, asNew);
        assertNightIsTold(project, newer);
    }

    private static void runByJaCaMo(Path project, String task) throws Exception {
        ProcessBuilder gradle = gradle("-Pjacamo=" + System.getProperty("javino.jacamoRepository"), task);
        assertEquals(0, gradle.directory(project.toFile()).inheritIO().start().waitFor());
    }

    private static void assertNightIsTold(Path project, Platform jacamo) throws Exception {
        Path bundle = project.resolve("build/bundle");
        Files.createSymbolicLink(bundle.resolve("ports"), project.resolve("ports"));
        try (AgentProcess board = board(project); AgentProcess agents = agents(bundle, jacamo, "robot.jcm")) {
            board.await("\"name\":\"lamp\",\"level\":1}");
            agents.await("[teller] the night has 2 entries");
        }
    }

    private static AgentProcess board(Path project) throws IOException {
        return AgentProcess.start(new ProcessBuilder(home.resolve("bin/javino-emulator").toString(), "board.json",
                "--trace", "-").directory(project.toFile()));
    }

    /** Starts agents by Java alone. */
    private static AgentProcess agents(Path bundle, Platform platform, String mas) throws IOException {
        return AgentProcess.start(new ProcessBuilder(platform.java().resolve("bin/java").toString(), "-cp", "lib/*",
                platform.launcher(), mas, "--log-conf", "logging.properties", "--no-net").directory(bundle.toFile()));
    }

    private static void assertBetween(double least, double value, double most) {
        assertTrue(least <= value && value <= most, () -> value + " is not between " + least + " and " + most);
    }

    private static Process newProject(Path folder, String... options) throws IOException {
        return javino(Stream.concat(Stream.of("new", folder.toString()), Stream.of(options)).toList());
    }

    private static Process javino(List<String> words) throws IOException {
        ProcessBuilder javino = new ProcessBuilder(home.resolve("bin/javino").toString());
        javino.command().addAll(words);
        javino.redirectOutput(ProcessBuilder.Redirect.DISCARD).redirectError(ProcessBuilder.Redirect.INHERIT);
        javino.environment().put("JAVA_HOME", JAVA_HOME);
        return javino.start();
    }

    /** The same by a daemon, as users do by default: it starts once for all tests. */
    private static ProcessBuilder byDaemon(String... arguments) {
        ProcessBuilder gradle = gradle(arguments);
        gradle.command().remove("--no-daemon");
        gradle.command().addAll(List.of("--daemon", "-Dorg.gradle.daemon.registry.base=" + projects.resolve("daemon"),
                "-Dorg.gradle.jvmargs=" + QUICK_START));
        return gradle;
    }

    /** The Gradle that runs this test, in a process that ends with it. */
    static ProcessBuilder gradle(String... arguments) {
        ProcessBuilder gradle =
                new ProcessBuilder(System.getProperty("javino.gradle"), "--no-daemon", "--console", "plain",
                        "--gradle-user-home", System.getProperty("javino.gradleUserHome"));
        gradle.command().addAll(List.of(arguments));
        gradle.environment().put("JAVA_HOME", JAVA_HOME);
        gradle.environment().put("GRADLE_OPTS", QUICK_START);
        return gradle;
    }

    private static List<TraceEvent> lamp(Path trace) throws IOException {
        return TraceReader.all(trace).stream().filter(event -> event.is("pin", "robot")).toList();
    }

    /** The emulator removes its port at its end. */
    private static void awaitGone(Path port) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (Files.exists(port, LinkOption.NOFOLLOW_LINKS)) {
            assertTrue(System.nanoTime() < end, "the emulated board runs on");
            Thread.sleep(50);
        }
    }
}
