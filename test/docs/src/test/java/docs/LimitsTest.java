package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;

import org.junit.jupiter.api.Test;

/**
 * The size of each module, and of all pages, stays within a table. A change that needs more raises its row, and its
 * commit says why.
 */
class LimitsTest {

    private static final String TABLE = "test/docs/src/test/resources/docs/limits.txt";
    private static final Pattern CODE = Pattern.compile(".*\\.(java|cpp|c|h|ino|S|def|js|lua|py)");
    private static final Pattern TEST =
            Pattern.compile("(.*/)?(test|tests|bench)/.*|.*src/(test|vectors|simulation|fake).*");

    /** Lines of production, lines of tests, files, and the lines of the longest of them. */
    private record Size(int production, int tests, int files, int longest) {

        static final Size NONE = new Size(0, 0, 0, 0);

        Size with(String file, int lines) {
            boolean test = TEST.matcher(file).matches();
            return new Size(production + (test ? 0 : lines), tests + (test ? lines : 0), files + 1,
                    Math.max(longest, lines));
        }

        boolean fits(Size limit) {
            return production <= limit.production && tests <= limit.tests && files <= limit.files
                    && longest <= limit.longest;
        }

        @Override
        public String toString() {
            return "%8d %8d %8d %8d".formatted(production, tests, files, longest);
        }
    }

    /** The columns of each row that has so many. */
    private static List<String[]> rows(int columns) {
        return Repository.text(TABLE).lines().filter(line -> !line.startsWith("#")).map(row -> row.split(" {2,}"))
                .filter(row -> row.length == columns).toList();
    }

    private static Map<String, Size> limits() {
        Map<String, Size> limits = new TreeMap<>(Comparator.reverseOrder());
        rows(5).forEach(row -> limits.put(row[0], new Size(Integer.parseInt(row[1]), Integer.parseInt(row[2]),
                Integer.parseInt(row[3]), Integer.parseInt(row[4]))));
        return limits;
    }

    private static String name(Path file) {
        return Repository.ROOT.relativize(file).toString().replace('\\', '/');
    }

    @Test
    void code_ofEachModule_staysWithinItsRow() {
        Map<String, Size> limits = limits();
        Map<String, Size> found = new TreeMap<>();
        for (Path file : Repository.files(".", "")) {
            String name = name(file.normalize());
            if (CODE.matcher(name).matches()) {
                // Names in falling order: the row of a folder within another one comes before that.
                String module = limits.keySet().stream().filter(each -> name.startsWith(each + "/")).findFirst()
                        .orElse(".");
                found.merge(module, Size.NONE.with(name, lines(file)), (one, other) -> new Size(
                        one.production + other.production, one.tests + other.tests, one.files + other.files,
                        Math.max(one.longest, other.longest)));
            }
        }
        List<String> wrong = new ArrayList<>();
        found.forEach((module, size) -> {
            if (!size.fits(limits.getOrDefault(module, Size.NONE))) {
                wrong.add("%-28s".formatted(module) + size);
            }
        });
        assertEquals(limits.keySet(), found.keySet(), "each row is that of a module");
        assertEquals("", String.join("\n", wrong), "make it smaller, or raise these rows of " + TABLE);
    }

    private static int lines(Path file) {
        return (int) Repository.text(file).chars().filter(each -> each == '\n').count();
    }

    /** The words of a page that somebody has written, not a task. */
    private static int words(Path page) {
        String written = Repository.text(page).replaceAll("(?s)<!-- \\w+: made by .*?<!-- end -->", "");
        return written.strip().split("\\s+").length;
    }

    @Test
    void pages_stayWithinTheirWords() {
        List<String[]> limits = rows(2);
        assertFalse(limits.isEmpty());
        for (String[] limit : limits) {
            long words = Repository.files(".", ".md").stream().filter(file -> name(file.normalize()).matches(limit[0]))
                    .mapToLong(LimitsTest::words).sum();
            assertTrue(words <= Integer.parseInt(limit[1]), limit[0] + " has " + words + " words");
        }
    }
}
