package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** No {@code git add -A} takes in what the how-tos make: keyrings and EEPROMs hold secret keys. */
class IgnoredFilesTest {

    private static final Path PROJECT =
            Path.of("javino-java/cli/src/main/resources/javino/cli/project/common/gitignore");

    /** The files that are written: by a command, by a scenario's board, or by the reader, who is told the name. */
    private static final Pattern MADE =
            Pattern.compile("(?:--out|--renew|--trace) ([a-z][\\w/.]*)|\"eeprom\": \"([\\w/]+)"
                    + "|`(?:examples/highway/)?(agents/\\w+\\.asl|\\w+\\.mas2j|(?:fleet|follower)\\.\\w+)`");

    @TempDir
    private Path folder;

    private static Set<String> made() throws IOException {
        Set<String> made = new TreeSet<>(Set.of("keys.part"));
        try (Stream<Path> pages = Files.walk(Repository.ROOT.resolve("docs"))) {
            for (Path page : pages.filter(file -> file.toString().endsWith(".md")).toList()) {
                Matcher matcher = MADE.matcher(Files.readString(page));
                while (matcher.find()) {
                    String file = Stream.of(1, 2, 3).map(matcher::group).filter(name -> name != null).findFirst()
                            .orElseThrow();
                    if (!Files.exists(Repository.ROOT.resolve("examples/highway").resolve(file))) {
                        made.add(file);
                    }
                }
            }
        }
        return made;
    }

    private String git(String... arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("git", "-C", folder.toString()));
        command.addAll(List.of(arguments));
        Process git = new ProcessBuilder(command).redirectErrorStream(true).start();
        String printed = new String(git.getInputStream().readAllBytes());
        assertEquals(0, git.waitFor(), printed);
        return printed;
    }

    private void make(String place, String file) throws IOException {
        Path path = folder.resolve(place).resolve(file);
        Files.createDirectories(path.getParent());
        Files.writeString(path, "made");
    }

    /** The files that {@code git add -A} would take in, beside the lists of what is ignored. */
    private String unknown() throws IOException, InterruptedException {
        git("add", "*.gitignore");
        return git("status", "--porcelain", "--untracked-files=all").lines().filter(line -> line.startsWith("??"))
                .collect(Collectors.joining("\n"));
    }

    @Test
    void howTos_makeWhatIsKnown() throws IOException {
        assertTrue(made().containsAll(Set.of("keys", "eeprom/vehicle", "agents/mine.asl", "fleet.sh", "lamp.mas2j")),
                made()::toString);
    }

    @Test
    void clone_leavesOutWhatTheHowTosMake() throws Exception {
        git("init", "-q");
        for (String place : List.of("", "examples/highway")) {
            Path ignored = Path.of(place, ".gitignore");
            Files.createDirectories(folder.resolve(place));
            Files.copy(Repository.ROOT.resolve(ignored), folder.resolve(ignored));
        }
        for (String file : made()) {
            make("examples/highway", file);
        }
        make("", "keys");
        make("", "keys.part");
        make("", "eeprom/a.bin");
        make("examples/highway", "moves/bus/1");
        assertEquals("", unknown());
    }

    @ParameterizedTest
    @CsvSource({"keys", "keys.part", "eeprom/robot.bin", "build/eeprom.bin", "ports/robot", "moves/robot/1"})
    void newProject_leavesOutKeys(String file) throws Exception {
        git("init", "-q");
        Files.copy(Repository.ROOT.resolve(PROJECT), folder.resolve(".gitignore"));
        make("", file);
        make("", "robot.mas2j");
        assertEquals("?? robot.mas2j", unknown());
    }
}
