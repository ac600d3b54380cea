package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import harness.AgentProcess;
import harness.Certificates;
import harness.Emulator;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import keyagreement.BoardKeyAgreement;

/** {@code docs/how-to/agree-on-keys.md}, done as it says. */
@Tag("verify")
class AgreeOnKeysTest {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));
    private static final Pattern FILE =
            Pattern.compile("`([\\w/]+\\.(?:mas2j|asl))`(?: is|:)\n\n```\n(.*?)```", Pattern.DOTALL);
    private static final Pattern PRINTED = Pattern.compile("^\\[(\\w+)] .*", Pattern.MULTILINE);

    @TempDir
    private Path folder;

    @Test
    void page_doneWithEmulatedBoards_printsWhatItSays() throws Exception {
        String page = Files.readString(ROOT.resolve("docs/how-to/agree-on-keys.md"));
        Files.createDirectory(folder.resolve("agents"));
        Matcher files = FILE.matcher(page);
        while (files.find()) {
            Files.writeString(folder.resolve(files.group(1)), files.group(2));
        }
        Path identities = folder.resolve("identities");
        Certificates authority = new Certificates(folder, "city");
        authority.enroll("ROMA", identities);
        authority.enroll("SUPO", identities);
        List<String> options = List.of("-D" + BoardKeyAgreement.FOLDER_PROPERTY + "=" + identities);
        List<String> printed = PRINTED.matcher(page).results().map(line -> line.group()).toList();
        assertEquals(3, printed.size(), printed::toString);

        Emulator emulator = new Emulator.Scenario().board("bus", "Vehicle").board("police", "Station").start(folder);
        try (AgentProcess listener = AgentProcess.run("listener", folder, options);
                AgentProcess caller = AgentProcess.run("caller", folder, options)) {
            for (String line : printed) {
                (line.startsWith("[caller]") ? caller : listener).await(line);
            }
        } finally {
            emulator.close();
        }
    }
}
