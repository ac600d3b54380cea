package campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The document that all campaigns share. */
class DocumentTest {

    private static final List<String> ORDER = List.of("one", "two", "three");

    @TempDir
    private Path folder;

    @Test
    void write_oneRun_replacesItsSectionAndKeepsTheOthers() throws IOException {
        Path file = folder.resolve("docs/reliability.md");
        write(file, "three", "third");
        write(file, "one", "first");
        String before = Files.readString(file);
        write(file, "one", "first again");

        assertEquals(before.replace("first", "first again"), Files.readString(file));
        assertTrue(before.indexOf("## one") < before.indexOf("## three"), before);
        assertTrue(before.contains("`gradle one`\n\nfirst"), before);
        assertTrue(!before.contains("two"), before);
    }

    private static void write(Path file, String name, String text) throws IOException {
        Report report = new Report(name, System.err);
        report.text(text);
        Document document = new Document(file, ORDER);
        document.put(name, "gradle " + name, report);
        document.write();
    }
}
