package docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The commands by which pages call Gradle, taken by the real one: it makes a property of each {@code -P}, which hides
 * whatever has its name in any build file.
 */
class GradleCommandsTest {

    private static final Pattern COMMAND = Pattern.compile("(?:^|`|&& )gradle ([^`\\n]*)", Pattern.MULTILINE);
    private static final Pattern PROPERTY = Pattern.compile("(?<![\\w-])-P([a-zA-Z]+)(?:=([^\\s`|.,;…'\"]*))?");
    private static final Pattern TASK = Pattern.compile(":?[a-z][A-Za-z:-]*");
    /** Tasks of the projects that {@code javino new} writes, and of a sketch that the reader writes. */
    private static final Set<String> OF_READERS =
            Set.of("run", "sketch", "bundle", "buildJCMDeps", ":javino-firmware:firmwareFollower");

    /** All pages, and the build files, whose descriptions name further properties. */
    private static Stream<String> texts() {
        return Stream.of(".md", ".gradle").flatMap(ending -> Repository.files("", ending).stream())
                .map(Repository::text);
    }

    private static Map<String, String> properties() {
        Map<String, String> found = new TreeMap<>();
        texts().forEach(text -> PROPERTY.matcher(text).results()
                .forEach(each -> found.merge(each.group(1), each.group(2) == null ? "" : each.group(2),
                        (one, other) -> one.isEmpty() ? other : one)));
        return found;
    }

    /** The words of a command up to what is no task. */
    private static Set<String> tasks() {
        Set<String> found = new TreeSet<>();
        texts().flatMap(text -> COMMAND.matcher(text).results()).map(command -> command.group(1)).forEach(words -> {
            for (String word : words.split(" +")) {
                if (!TASK.matcher(word).matches()) {
                    break;
                }
                found.add(word);
            }
        });
        found.removeAll(OF_READERS);
        return found;
    }

    @Test
    void tasks_ofPagesWithAllTheirProperties_areTakenByTheRealGradle(@TempDir Path folder) throws Exception {
        Map<String, String> properties = properties();
        Set<String> tasks = tasks();
        assertTrue(properties.keySet().containsAll(Set.of("agent", "live", "radio", "seed")), properties::toString);
        assertTrue(tasks.containsAll(Set.of("agent", "highway", "install", ":uppaal:test")), tasks::toString);

        // A dry run waits for no other build of this folder.
        List<String> command = new ArrayList<>(List.of("env", "GRADLE_OPTS=-XX:TieredStopAtLevel=1 -XX:+UseSerialGC",
                System.getProperty("javino.gradle"), "--no-daemon", "--console=plain", "--dry-run",
                "--gradle-user-home", System.getProperty("javino.gradleUserHome"), "--project-cache-dir", "" + folder));
        properties.forEach((name, value) -> command.add("-P" + name + "=" + value));
        command.addAll(tasks);
        Process gradle =
                new ProcessBuilder(command).directory(Repository.ROOT.toFile()).redirectErrorStream(true).start();
        List<String> lines = gradle.inputReader().lines().toList();
        assertEquals(0, gradle.waitFor(), () -> String.join("\n", lines));
        for (String task : tasks) {
            assertTrue(
                    lines.stream().anyMatch(line -> line.matches(":(.*:)?" + Pattern.quote(task.replaceFirst("^:", ""))
                            + " SKIPPED") || task.equals("tasks")),
                    () -> task + " is missing:\n" + String.join("\n", lines));
        }
    }
}
