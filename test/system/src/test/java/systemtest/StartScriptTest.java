package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import harness.AgentProcess;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javino.keyring.DeviceNotes;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The script by which users call {@code javino}, with the Java that runs this and with the newest one here. */
@Tag("verify")
class StartScriptTest {

    private static final Path SCRIPT = Path.of(System.getProperty("javino.root"), "build/javino/bin/javino");

    static Stream<Path> javas() throws IOException {
        return Stream.concat(Stream.of(Path.of(System.getProperty("java.home"))), NewerJava.home().stream()).distinct();
    }

    @ParameterizedTest
    @MethodSource("javas")
    void javino_calledByALink_startsJavaOnceAndPrintsNothingOfItsOwn(Path java, @TempDir Path folder) throws Exception {
        Path home = Files.createDirectories(folder.resolve("a Java/bin")).getParent();
        Path starts = folder.resolve("starts");
        Path counting = home.resolve("bin/java");
        Files.writeString(counting,
                "#!/bin/sh\necho start >> '" + starts + "'\nexec '" + java.resolve("bin/java") + "' \"$@\"\n");
        counting.toFile().setExecutable(true);
        Path link = Files.createSymbolicLink(folder.resolve("javino"), SCRIPT);
        Path errors = folder.resolve("errors");

        ProcessBuilder command = new ProcessBuilder(link.toString(), "ports").redirectError(errors.toFile());
        command.environment().put("JAVA_HOME", home.toString());
        List<String> printed = end(command);

        assertEquals(List.of(), Files.readAllLines(errors));
        assertEquals(List.of("start"), Files.readAllLines(starts));
        assertEquals(end(new ProcessBuilder(java.resolve("bin/java").toString(), "-cp",
                System.getProperty("java.class.path"), "javino.cli.Main", "ports")), printed);
    }

    @Test
    void version_isThatOfTheBuild() throws Exception {
        String version = Files.readAllLines(Path.of(System.getProperty("javino.root"), "gradle.properties")).stream()
                .filter(line -> line.startsWith("version=")).findFirst().orElseThrow().substring("version=".length());
        assertEquals(List.of("javino " + version), end(new ProcessBuilder(SCRIPT.toString(), "--version")));
    }

    /** Agents that a test starts note nothing of emulated boards in their user's folder. */
    @Test
    void agentProcess_ofATest_hasNotTheUsersIdentities() throws Exception {
        try (AgentProcess process = AgentProcess.start(new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin/java").toString(), "-XshowSettings:properties",
                "-version"))) {
            process.await(DeviceNotes.FOLDER_PROPERTY + " = " + DeviceNotes.named().folder());
            process.awaitEnd();
        }
        assertNotEquals(DeviceNotes.defaultFolder(), DeviceNotes.named().folder());
    }

    private static List<String> end(ProcessBuilder command) throws Exception {
        Process process = command.start();
        List<String> lines = process.inputReader().lines().toList();
        assertEquals(0, process.waitFor(), () -> String.join("\n", lines));
        return lines;
    }
}
