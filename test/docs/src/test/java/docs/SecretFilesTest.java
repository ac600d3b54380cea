package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * All that holds secrets is written by PrivateFile, in C by open_private: each other place that opens a file to write
 * stands in a list, with what it writes.
 */
class SecretFilesTest {

    private static final String LIST = "test/docs/src/test/resources/docs/writers.txt";
    private static final Pattern JAVA = Pattern.compile(
            "Files\\s*\\.(?:write\\w*|newBufferedWriter|newOutputStream|newByteChannel|copy|move|createFile"
                    + "|createTempFile)\\(|FileChannel\\s*\\.open\\(|new (?:FileOutputStream|FileWriter"
                    + "|RandomAccessFile|Print(?:Writer|Stream)\\([^)]*(?:File|Path|\"))");
    private static final Pattern C = Pattern.compile("(?<![\\w.>])(?:open|openat|creat|fopen|freopen|mkstemp)\\(");

    /** The programs that users run, and those that run them for tests. */
    private static Map<String, Long> found(Pattern opens, String ending, String... folders) {
        Map<String, Long> found = new TreeMap<>();
        for (Path file : Stream.of(folders).flatMap(each -> Repository.files(each, ending).stream()).toList()) {
            String name = Repository.ROOT.relativize(file).toString().replace('\\', '/');
            long count = opens.matcher(Repository.text(file)).results().count();
            if (count > 0 && !name.matches(".*/src/(test|fake|vectors|simulation)/.*")) {
                found.put(name, count);
            }
        }
        return found;
    }

    @Test
    void files_areOpenedToWriteByTheOneFunction_orListedWithWhatTheyHold() {
        Map<String, Long> listed = new TreeMap<>();
        for (String line : Repository.text(LIST).lines().toList()) {
            if (!line.startsWith("#")) {
                List<String> columns = List.of(line.split(" {2,}"));
                assertEquals(3, columns.size(), LIST + " has not three columns here: " + line);
                listed.put(columns.get(0), Long.valueOf(columns.get(1)));
            }
        }
        Map<String, Long> all = found(JAVA, ".java", "javino-java", "diffuser-arch",
                "optional", "examples",
                "emulator/trace", "test/harness", "test/lockstep");
        all.putAll(found(C, ".c", "emulator/src"));
        assertEquals(listed, all, "what holds secrets goes through PrivateFile or open_private; what holds "
                + "none gets a line in " + LIST);
    }

    @Test
    void patterns_findWhatOpensFiles() {
        for (String line : List.of("Files.writeString(a, b)", "Files.write(a, b)", "new FileOutputStream(name)",
                "Files.newOutputStream(a)", "FileChannel.open(a)", "new PrintStream(new File(a))")) {
            assertTrue(JAVA.matcher(line).find(), line);
        }
        for (String line : List.of("int d = open(path, O_WRONLY)", "fopen(path, \"w\")", "(creat(path, 0644))")) {
            assertTrue(C.matcher(line).find(), line);
        }
    }
}
