package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.codehaus.groovy.control.CompilationFailedException;
import org.codehaus.groovy.control.CompilationUnit;
import org.codehaus.groovy.control.Phases;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The build files, and those of `javino new`, have nothing that Gradle 5 to 9 have removed, but on lines that end in
 * "before" and a version, which older ones alone run. No newer Gradle is run here, only the parser of Gradle 9.
 */
@Tag("verify")
class GradleUpgradeTest {

    private static final String LIST = "test/docs/src/test/resources/docs/gradle-removed.txt";
    private static final Pattern MARK = Pattern.compile("// before (\\d+\\.\\d+)$");

    /** Something that a version removed; an example, and what takes its place, empty if nothing does. */
    private record Removed(double version, Pattern pattern, String example, String instead, String place) {

        static Removed of(String line, String place) {
            String[] columns = line.split(" {2,}");
            assertEquals(4, columns.length, LIST + " has not four columns here: " + line);
            return new Removed(Double.parseDouble(columns[0]), Pattern.compile(columns[1], Pattern.MULTILINE),
                    columns[2].replace("\\n", "\n"), columns[3].equals("-") ? "" : columns[3].replace("\\n", "\n"),
                    place);
        }

        /** The lines, from 0 on, on which it ends that are not marked as those of an older version. */
        List<Integer> lines(String text) {
            List<String> lines = text.lines().toList();
            return pattern.matcher(withoutComments(text)).results()
                    .map(match -> (int) text.substring(0, match.end() - 1).chars().filter(c -> c == '\n').count())
                    .filter(line -> mark(lines.get(line)) > version).toList();
        }

        @Override
        public String toString() {
            return example + " (removed in " + version + ": " + place + ")";
        }
    }

    static Stream<Removed> removed() {
        List<Removed> all = new ArrayList<>();
        String place = null;
        for (String line : Repository.text(LIST).lines().toList()) {
            place = line.startsWith("#") ? line.substring(1).strip() : place;
            if (place != null && !line.startsWith("#") && !line.isBlank()) {
                all.add(Removed.of(line, place));
            }
        }
        return all.stream();
    }

    /** The version that a line's mark names; greater than all where it has none. */
    private static double mark(String line) {
        return MARK.matcher(line).results().mapToDouble(mark -> Double.parseDouble(mark.group(1))).findFirst()
                .orElse(Double.MAX_VALUE);
    }

    /** The text with blanks in the place of each comment, so that all else stays where it is. */
    private static String withoutComments(String text) {
        return Pattern.compile("(?ms)(?<=^|\\s)(/\\*\\*?\\s.*?\\*/|//[^\\n]*)").matcher(text)
                .replaceAll(comment -> comment.group().replaceAll("\\S", " "));
    }

    private static List<Path> buildFiles() {
        return Stream.of(".gradle", "gradle.properties").flatMap(ending -> Repository.files("", ending).stream())
                .filter(file -> Files.isRegularFile(file)).toList();
    }

    @Test
    void buildFiles_areThoseOfTheBuildAndOfNewProjects() {
        List<String> names = buildFiles().stream().map(file -> Repository.ROOT.relativize(file).toString()).toList();
        String templates = "javino-java/cli/src/main/resources/javino/cli/project/";
        assertTrue(names.containsAll(List.of("build.gradle", "settings.gradle", "gradle/style.gradle",
                "test/docs/build.gradle", templates + "common/javino.gradle", templates + "jacamo/build.gradle",
                templates + "jason/build.gradle", templates + "imported/build.gradle",
                templates + "common/settings.gradle")), names::toString);
    }

    @ParameterizedTest
    @MethodSource("removed")
    void removed_inBuildFiles_isNowhereButBehindAMark(Removed removed) {
        List<String> found = buildFiles().stream().flatMap(file -> removed.lines(Repository.text(file)).stream()
                .map(line -> Repository.ROOT.relativize(file) + ":" + (line + 1))).toList();
        assertEquals(List.of(), found, removed::toString);
    }

    @ParameterizedTest
    @MethodSource("removed")
    void removed_example_isFoundUnlessItIsMarked(Removed removed) {
        assertFalse(removed.lines(removed.example()).isEmpty(), removed::toString);
        assertFalse(removed.lines("def a = 1\n" + removed.example() + "\ndef b = 2\n").isEmpty(), removed::toString);
        assertEquals(List.of(), removed.lines(removed.example() + "  // before 4.2"), removed::toString);
        assertFalse(removed.lines(removed.example() + "  // before 99.0").isEmpty(), removed::toString);
        assertEquals(List.of(), removed.lines("// " + removed.example().replace("\n", "\n// ")), removed::toString);
        assertFalse(removed.lines("// a\n/** b */\n" + removed.example()).isEmpty(), removed::toString);
        assertEquals(List.of(), removed.lines(removed.instead()), removed::toString);
    }

    @Test
    void marks_standOnlyWhereSomethingWasRemoved() {
        for (Path file : buildFiles()) {
            String text = Repository.text(file);
            String unmarked = text.replaceAll("(?m)" + MARK.pattern(), "");
            List<Integer> found = removed().flatMap(removed -> removed.lines(unmarked).stream()).toList();
            List<String> lines = text.lines().toList();
            for (int line = 0; line < lines.size(); line++) {
                assertTrue(mark(lines.get(line)) == Double.MAX_VALUE || found.contains(line),
                        file + " marks what is there in all versions: " + lines.get(line));
            }
        }
    }

    /** upgrading_major_version_9, groovy-4; upgrading_version_6, Changes to Groovy and Groovy DSL. */
    @Test
    void buildFiles_parserOfGradle9_acceptsThem() {
        for (Path file : Repository.files("", ".gradle")) {
            parse(Repository.text(file), file.toString());
        }
        assertThrows(CompilationFailedException.class, () -> parse("task a {\n    doLast { println 1 \n}\n", "a"));
    }

    private static void parse(String text, String name) {
        CompilationUnit unit = new CompilationUnit();
        unit.addSource(name, text);
        unit.compile(Phases.CONVERSION);
    }

    /** upgrading_major_version_9, test_task_fails_when_no_tests_are_discovered. */
    @Test
    void test_ofAModuleWithLongTestsOnly_isOff() {
        TreeSet<String> empty = new TreeSet<>();
        for (Path build : Repository.files("", "build.gradle")) {
            List<String> tests = Files.isDirectory(build.resolveSibling("src/test/java"))
                    ? Repository.files(Repository.ROOT.relativize(build.resolveSibling("src/test/java")).toString(),
                            "Test.java").stream().map(Repository::text).toList()
                    : List.of();
            if (!tests.isEmpty() && tests.stream().allMatch(GradleUpgradeTest::isLong)
                    && !Repository.text(build).contains("test.enabled = false")) {
                empty.add(Repository.ROOT.relativize(build).toString());
            }
        }
        assertEquals(new TreeSet<>(), empty, "their task `test` finds no test, which Gradle 9 refuses");
    }

    /** Whether a class of tests has none but those that `verify` runs. */
    private static boolean isLong(String source) {
        String tag = "@Tag\\(\"verify\"\\)\\s";
        return Pattern.compile("(?m)^" + tag).matcher(source).find()
                || count(" +" + tag, source) >= count(" +@(Parameterized|Repeated)?Test(Factory|Template)?\\b", source);
    }

    private static long count(String pattern, String text) {
        return Pattern.compile("(?m)^" + pattern).matcher(text).results().count();
    }

    @Test
    void isLong_testWithoutATag_isFalse() {
        String tagged = "class A {\n    @Tag(\"verify\")\n    @Test\n    void a() {}\n";
        assertTrue(isLong(tagged));
        assertTrue(isLong("@Tag(\"verify\")\nclass A {\n    @Test\n    void a() {}\n"));
        assertFalse(isLong(tagged + "    @ParameterizedTest\n    void b() {}\n"));
    }

    /** upgrading_major_version_9, project_directories_must_exist_and_be_writeable. */
    @Test
    void settings_eachProject_hasAFolder() {
        List<String> projects = Pattern.compile("(?m)^include '(.*)'$").matcher(Repository.text("settings.gradle"))
                .results().map(include -> include.group(1)).toList();
        assertFalse(projects.isEmpty());
        for (String project : projects) {
            assertTrue(Files.isDirectory(Repository.ROOT.resolve(project.replace(':', '/'))), project);
        }
    }
}
