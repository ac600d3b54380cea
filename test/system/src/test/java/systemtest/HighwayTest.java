package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import capture.TraceCheck;
import harness.AgentProcess;
import harness.HighwayFiles;
import harness.Platform;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/** The scenario as a user runs it: its launcher, which starts everything else. */
class HighwayTest {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));
    private static final String EMULATOR = ROOT.resolve("emulator/build/javino-emulator").toString();

    private static final Path JAVA = Path.of(System.getProperty("java.home"));
    private static final String CLASS_PATH = System.getProperty("java.class.path");

    private static final String ALL = "highway: (\\d+) of \\1 behaviours observed";

    private record Run(int status, List<String> lines, List<ProcessHandle> children, Path folder) {

        String last() {
            return lines.get(lines.size() - 1);
        }

        /** The line of the table, above that of the model. */
        String lastButOne() {
            return lines.get(lines.size() - 2);
        }

        boolean says(String words) {
            return lines.stream().anyMatch(line -> line.contains(words));
        }

        void assertAllObserved() {
            assertTrue(lastButOne().matches(ALL), this::toString);
            assertTrue(
                    last().matches(
                            "model: trace accepted \\(\\d+ events, [1-9]\\d* messages opened, [1-9]\\d* proofs"
                                    + "(, [1-9]\\d* states of hosts)?\\)"),
                    this::toString);
            assertEquals(0, status);
        }

        void assertNothingLeft() throws Exception {
            for (ProcessHandle child : children) {
                child.onExit().get(1, TimeUnit.MINUTES);
            }
            Path ports = folder.resolve("ports");
            try (Stream<Path> left = Files.exists(ports) ? Files.list(ports) : Stream.of()) {
                assertEquals(List.of(), left.toList());
            }
        }

        @Override
        public String toString() {
            return String.join("\n", lines);
        }
    }

    @TempDir
    private Path folder;

    @Test
    void cleanRadio_showsAllBehaviours() throws Exception {
        Run run = launch(EMULATOR);

        run.assertAllObserved();
        assertFalse(run.children.isEmpty());
        assertPictured(run);
        run.assertNothingLeft();
    }

    @Tag("verify")
    @Test
    void noisyRadio_isCapturedWhole() throws Exception {
        Run run = launch(EMULATOR, "--radioBitErrorRate=0.001", "--seed=3");

        Path build = run.folder.resolve("build");
        TraceCheck.Found found =
                TraceCheck.check(build.resolve("trace.jsonl"), Files.readString(build.resolve("keyring")));
        assertTrue(found.damaged() > 0 && found.opened() >= 40 && found.acknowledgements() >= 25, found::toString);
    }

    @Test
    @Tag("verify")
    void cellsThatGatewaysJoin_showAllBehaviours() throws Exception {
        Run run = launch(EMULATOR, "--cells=2");

        run.assertAllObserved();
        run.assertNothingLeft();
    }

    @Test
    @Tag("soak")
    void inspector_travelsToTheBusAndBackMeanwhile() throws Exception {
        assertInspected(launch(EMULATOR, "--inspector"));
    }

    private static void assertInspected(Run run) throws Exception {
        run.assertAllObserved();
        assertTrue(run.says("I am back from ROMA: obstacle at"), run::toString);
        assertTrue(run.last().contains(" states of hosts)"), run::toString);
        run.assertNothingLeft();
    }

    /**
     * The picture has the eight messages with an arrow to each receiver, and what the agents said, in well-formed SVG.
     */
    private static void assertPictured(Run run) throws Exception {
        Document svg = DocumentBuilderFactory.newInstance().newDocumentBuilder()
                .parse(run.folder.resolve("build/highway.svg").toFile());
        NodeList lines = svg.getElementsByTagName("line");
        long arrows = IntStream.range(0, lines.getLength())
                .filter(i -> ((Element) lines.item(i)).hasAttribute("marker-end")).count();
        assertEquals(4 + 3 + 6, arrows);
        assertTrue(svg.getDocumentElement().getTextContent().contains("“Help is coming, says SUPO”"));
    }

    @Tag("verify")
    @Test
    void newerJavaAndJason_showAllBehaviours_andAnInspectorTravels() throws Exception {
        Platform newer = NewerJava.withNewerJason();
        HighwayFiles.copy(folder);
        Run run = follow(launcher(newer.java(), newer.classPath(), EMULATOR, "--inspector").start());

        assertInspected(run);
        assertFalse(run.says("WARNING"), run::toString);
    }

    @Test
    @Tag("verify")
    void badRadio_endsCleanlyAndSaysWhatWasMissing() throws Exception {
        Run run = launch(EMULATOR, "--radioBitErrorRate=0.05", "--timeout=40");

        assertTrue(run.lastButOne().matches("highway: (\\d+) of (?!\\1 )\\d+ behaviours observed"), run::toString);
        assertTrue(run.last().matches("model: trace accepted \\(\\d+ events, \\d+ messages opened, \\d+ proofs\\)"),
                run::toString);
        assertEquals(1, run.status);
        assertTrue(run.says("does not print"), run::toString);
        run.assertNothingLeft();
    }

    @Test
    @Tag("verify")
    void traceThatTheModelRefuses_failsTheRun() throws Exception {
        Path spoiling = folder.resolve("emulator");
        Files.writeString(spoiling,
                "#!/bin/bash\nexec " + EMULATOR + " \"$@\" > >(exec sed -u 's/\"host-transmit\"/\"nothing\"/')\n");
        assertTrue(spoiling.toFile().setExecutable(true));
        Run run = launch(spoiling.toString());

        assertTrue(run.lastButOne().matches(ALL), run::toString);
        assertTrue(run.last().matches(
                "model: trace refused at event \\d+ \\(.*, bus, point\\): bus declares message \\d+ SENT; expected .*"),
                run::toString);
        assertEquals(1, run.status);
    }

    /** Boards are silent as on a machine that is busy with other things for some seconds. */
    @Test
    @Tag("verify")
    void boardsThatAreSilentAtTheStart_areSetUpLater() throws Exception {
        HighwayFiles.copy(folder);
        Run run = follow(start(EMULATOR), "five agents", "-STOP", "the board is off", "-CONT");

        assertTrue(run.says("is off"), run::toString);
        run.assertAllObserved();
    }

    @Test
    void missingEmulator_isSaidAndNothingIsLeft() throws Exception {
        Run run = launch("no-such-emulator");

        assertTrue(run.says("no-such-emulator"), run::toString);
        assertEquals(1, run.status);
        run.assertNothingLeft();
    }

    @Test
    void impossibleRange_isSaidInTheEmulatorsWords() throws Exception {
        Run run = launch(EMULATOR, "--radioRange=-5");

        assertTrue(run.says("radio.range"), run::toString);
        assertTrue(run.last().startsWith("highway: broken off: "), run::toString);
        assertEquals(1, run.status);
        run.assertNothingLeft();
    }

    @Test
    void optionThatIsNoNumber_isOneLine() throws Exception {
        Run run = launch(EMULATOR, "--radioRange=abc");

        assertEquals(1, run.lines.size(), run::toString);
        assertTrue(run.says("-PradioRange"), run::toString);
        assertEquals(2, run.status);
    }

    @Test
    void optionThatIsUnknown_saysWhichThereAre() throws Exception {
        Run run = launch(EMULATOR, "--speed=2");

        assertEquals(List.of(
                "highway: there is no option -Pspeed; there is -PradioBitErrorRate, -PradioRange, -Pradio, -Pseed, "
                        + "-Ptimeout, -Plive, -Pheadless, -Pcertificates, -Pcells"),
                run.lines);
        assertEquals(2, run.status);
    }

    @ParameterizedTest
    @CsvSource(nullValues = "none", delimiter = '|', value = {
            "none         | agent: -Pagent=NAME names the agent: one of ambulance, bus, hospital, police, support",
            "--agent=buss | agent: there is no buss.mas2j; -Pagent=NAME names the agent: one of ambulance, bus, "
                    + "hospital, police, support",
            "--nope=      | agent: there is no option -Pnope; there is -Pagent",
    })
    void agentThatIsNotNamed_saysWhichThereAre(String option, String line) throws Exception {
        HighwayFiles.copy(folder);
        List<String> command =
                new ArrayList<>(List.of(JAVA.resolve("bin/java").toString(), "-cp", CLASS_PATH, "highway.Agent"));
        command.addAll(option == null ? List.of() : List.of(option));
        Run run = follow(new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start());

        assertEquals(List.of(line), run.lines);
        assertEquals(2, run.status);
    }

    @Test
    @Tag("soak")
    void agentThatIsNotThere_calledByTheRealGradle_isNamed() throws Exception {
        Run run = follow(NewProjectTest.gradle("-q", "agent", "-Pagent=buss")
                .directory(Path.of(System.getProperty("javino.root")).toFile()).redirectErrorStream(true).start());

        assertTrue(run.says("agent: there is no buss.mas2j; -Pagent=NAME names the agent"), run::toString);
        assertEquals(1, run.status);
    }

    @JaCaMo.EachVersion
    void agentsStartedByHandUnderJaCaMo_busLearnsThatHelpIsComing(String version) throws Exception {
        Platform jacamo = JaCaMo.platform(version);
        HighwayFiles.copy(folder);
        Map<String, AgentProcess> agents = new HashMap<>();
        try (AgentProcess boards = AgentProcess.start(launcher(JAVA, CLASS_PATH, EMULATOR, "--boards-only"))) {
            boards.await("end with Ctrl-C");
            for (String name : List.of("police", "support", "hospital", "ambulance", "bus")) {
                agents.put(name, AgentProcess.run(jacamo, name, folder, line -> {}));
                agents.get(name).await("[" + name + "] Ready");
            }
            agents.get("ambulance").await("[ambulance] I am going!!!");
            agents.get("bus").await("[bus] Help is coming, says SUPO");
        } finally {
            agents.values().forEach(AgentProcess::close);
        }
    }

    @Test
    void launcherThatIsTerminated_endsEverything() throws Exception {
        HighwayFiles.copy(folder);
        Process launcher = start(EMULATOR, "--boards-only");
        List<ProcessHandle> children = new ArrayList<>();
        List<String> lines = new ArrayList<>();
        try (BufferedReader output = launcher.inputReader()) {
            for (String line = output.readLine(); line != null; line = output.readLine()) {
                lines.add(line);
                if (line.startsWith("the boards run")) {
                    children.addAll(launcher.descendants().toList());
                    launcher.toHandle().destroy();
                }
            }
        }
        launcher.waitFor();

        assertFalse(children.isEmpty(), () -> String.join("\n", lines));
        new Run(0, lines, children, folder).assertNothingLeft();
    }

    private Run launch(String emulator, String... options) throws Exception {
        HighwayFiles.copy(folder);
        return follow(start(emulator, options));
    }

    /**
     * The lines that it prints and the programs that it starts until its end.
     *
     * @param signals words, and what the emulator is sent when a line has them; for all such lines.
     */
    private Run follow(Process process, String... signals) throws Exception {
        List<String> lines = new ArrayList<>();
        Set<ProcessHandle> children = new LinkedHashSet<>();
        try (BufferedReader output = process.inputReader()) {
            for (String line = output.readLine(); line != null; line = output.readLine()) {
                lines.add(line);
                children.addAll(process.descendants().toList());
                for (int i = 0; i < signals.length; i += 2) {
                    if (line.contains(signals[i])) {
                        signal(process, signals[i + 1]);
                    }
                }
            }
        }
        return new Run(process.waitFor(), lines, List.copyOf(children), folder);
    }

    private static void signal(Process launcher, String signal) throws Exception {
        ProcessHandle emulator = launcher.descendants()
                .filter(child -> child.info().command().orElse("").equals(EMULATOR)).findFirst().orElseThrow();
        assertEquals(0, new ProcessBuilder("kill", signal, "" + emulator.pid()).start().waitFor());
    }

    private Process start(String emulator, String... options) throws IOException {
        return launcher(JAVA, CLASS_PATH, emulator, options).start();
    }

    /** The launcher starts all others with the Java and the class path that it has. */
    private ProcessBuilder launcher(Path javaHome, String classPath, String emulator, String... options) {
        List<String> command = Platform.smallJava(javaHome, "-cp", classPath, "highway.Highway", "--plain",
                "--emulator", emulator);
        command.addAll(List.of(options));
        if (!command.get(command.size() - 1).startsWith("--timeout")) {
            command.add("--timeout=300");
        }
        return new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true);
    }
}
