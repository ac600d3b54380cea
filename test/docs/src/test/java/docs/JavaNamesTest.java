package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What `gradle checkNames` calls names all that is wrong in a file, and nothing else. */
class JavaNamesTest {

    private static final Pattern NAMED = Pattern.compile("(?m)^.*Names\\.java:(\\d+): ");

    @Test
    void names_andBraces_areNamedByTheirLines(@TempDir Path folder) throws Exception {
        String text = Repository.text("test/docs/src/test/resources/docs/bad-names.txt");
        List<String> lines = text.lines().toList();
        Set<Integer> wrong = IntStream.rangeClosed(1, lines.size())
                .filter(number -> lines.get(number - 1).contains("// wrong")).boxed()
                .collect(Collectors.toCollection(TreeSet::new));
        Path file = Files.writeString(folder.resolve("BadNames.java"), text);

        Process check = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin/java").toString(),
                "-XX:TieredStopAtLevel=1", Repository.ROOT.resolve("gradle/JavaNames.java").toString(),
                file.toString()).redirectErrorStream(true).start();
        String said = new String(check.getInputStream().readAllBytes());

        assertEquals(1, check.waitFor(), said);
        assertEquals(wrong, NAMED.matcher(said).results().map((MatchResult line) -> Integer.valueOf(line.group(1)))
                .collect(Collectors.toCollection(TreeSet::new)), said);
    }
}
