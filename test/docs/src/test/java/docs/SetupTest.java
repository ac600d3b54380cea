package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The output of {@code setup.sh}, on a Debian that is played. */
class SetupTest {

    /** Nothing is installed, all packages are known, and none can be had. */
    private static final Map<String, String> COMMANDS = Map.of(
            "dpkg-query", "exit 1",
            "sudo", "exec \"$@\"",
            "apt-cache", "exit 0",
            "apt-get", "[ $1 = update ] || { for i in $(seq 30); do echo line $i; done; echo no room >&2; exit 100; }");

    @Test
    void setup_aptFails_showsItsLastTwentyLines(@TempDir Path folder) throws Exception {
        for (Map.Entry<String, String> command : COMMANDS.entrySet()) {
            Path file = Files.writeString(folder.resolve(command.getKey()), "#!/bin/sh\n" + command.getValue() + "\n");
            file.toFile().setExecutable(true);
        }
        ProcessBuilder setup = new ProcessBuilder("./setup.sh").directory(Repository.ROOT.toFile())
                .redirectErrorStream(true);
        setup.environment().merge("PATH", folder.toString(), (path, first) -> first + ":" + path);
        Process process = setup.start();
        List<String> lines = output(process).lines().filter(line -> !line.startsWith("setup: installing")).toList();
        List<String> shown = IntStream.rangeClosed(12, 30).mapToObj(i -> "line " + i).toList();
        assertEquals(shown, lines.subList(0, 19));
        assertEquals(List.of("no room", "setup: apt-get install has failed; its last lines are above"),
                lines.subList(19, lines.size()));
        assertEquals(1, process.waitFor());
    }

    private static String output(Process process) throws IOException {
        return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }
}
