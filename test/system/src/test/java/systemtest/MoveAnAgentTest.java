package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import harness.AgentProcess;
import harness.Emulator;
import harness.Host;
import harness.TestKeys;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The page {@code docs/how-to/move-an-agent.md}, done as it says. */
@Tag("verify")
class MoveAnAgentTest {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));
    private static final Pattern FILE =
            Pattern.compile("`([\\w/]+\\.(?:mas2j|asl))`(?: is|:)\n\n```\n(.*?)```", Pattern.DOTALL);
    private static final Pattern PRINTED = Pattern.compile("^\\[\\w+] .+$", Pattern.MULTILINE);

    @TempDir
    private Path folder;

    @Test
    void page_doneWithEmulatedBoards_printsWhatItSays() throws Exception {
        String page = Files.readString(ROOT.resolve("docs/how-to/move-an-agent.md"));
        Files.createDirectory(folder.resolve("agents"));
        Matcher files = FILE.matcher(page);
        while (files.find()) {
            Files.writeString(folder.resolve(files.group(1)), files.group(2));
        }
        List<String> printed = PRINTED.matcher(page).results().map(line -> line.group()).toList();
        assertEquals(5, printed.size(), printed::toString);

        try (Emulator emulator =
                new Emulator.Scenario().board("bus", "Vehicle").board("police", "Station").start(folder)) {
            provide(emulator, "bus", "ROMA", "SUPO");
            provide(emulator, "police", "SUPO", "ROMA");
            try (AgentProcess harbour = AgentProcess.run("harbour", folder, line -> {});
                    AgentProcess yard = AgentProcess.run("yard", folder, line -> {})) {
                for (String line : printed.subList(0, 4)) {
                    harbour.await(line);
                }
                yard.await(printed.get(4));
            }
        }
    }

    private static void provide(Emulator emulator, String board, String id, String partner) throws Exception {
        try (Host host = Host.patient(emulator, board)) {
            host.as(id, Map.of(partner, TestKeys.PAIR));
        }
    }
}
