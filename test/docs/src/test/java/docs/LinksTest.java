package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Relative links in the repository's Markdown files lead to files that are there, and to headings that they have. */
class LinksTest {

    private static final Pattern LINK = Pattern.compile("\\]\\(([^)\\s]+)\\)");
    private static final Pattern CODE = Pattern.compile("(?ms)^```.*?^```|`[^`\n]*`");

    @Test
    void relativeLinks_leadSomewhere() {
        List<Path> pages = Repository.files(".", ".md");
        assertFalse(pages.isEmpty());
        assertEquals(List.of(), pages.stream().flatMap(LinksTest::brokenLinks).toList());
    }

    private static Stream<String> brokenLinks(Path page) {
        // A link's text may be code, and is not needed; what code holds is no link.
        String text = CODE.matcher(Repository.text(page)).replaceAll("");
        return LINK.matcher(text).results().map(link -> link.group(1)).filter(link -> !link.contains("://"))
                .filter(link -> !leadsSomewhere(page, link))
                .map(link -> Repository.ROOT.relativize(page.normalize()) + " links " + link);
    }

    private static boolean leadsSomewhere(Path page, String link) {
        String[] parts = link.split("#", 2);
        Path target = parts[0].isEmpty() ? page : page.resolveSibling(parts[0]).normalize();
        return Files.exists(target) && (parts.length == 1 || headings(target).contains(parts[1]));
    }

    /** The headings' anchors, as GitHub makes them. */
    private static List<String> headings(Path page) {
        return Repository.text(page).lines().filter(line -> line.startsWith("#"))
                .map(line -> line.replaceFirst("^#+ ", "").toLowerCase(Locale.ROOT)
                        .replaceAll("[^\\p{L}\\p{N}_ -]", "").replace(' ', '-'))
                .toList();
    }
}
