package verdict;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Imports projects of ChonIDE and runs each as its user would, its boards emulated: right is one whose agents say
 * something, and no error.
 */
public final class CourseProjects {

    private static final int SECONDS = 30;
    private static final int AT_ONCE = 4;
    private static final Pattern ERROR = Pattern.compile("(?i)exception|error|could not|no fail event|FAILED");
    private static final Pattern SAID = Pattern.compile("^\\[(?!board)\\w+\\] .+");

    private CourseProjects() {
    }

    /** @param arguments the projects' folder and version, the command {@code javino}, a Gradle, libraries' folder. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        List<Path> projects;
        try (Stream<Path> files = Files.walk(Path.of(arguments[0]).toRealPath())) {
            projects = files.filter(file -> file.toString().endsWith(".chon")).sorted().toList();
        }
        // Most of a run is waiting.
        ExecutorService threads = Executors.newFixedThreadPool(AT_ONCE);
        try (Judge judge = new Judge("Projects of ChonIDE's course", arguments[1], "`javino import`")) {
            List<Future<Optional<Boolean>>> ends = new ArrayList<>();
            for (Path project : projects) {
                ends.add(threads.submit(() -> judge(project, arguments)));
            }
            for (int i = 0; i < ends.size(); i++) {
                Optional<Boolean> right = ends.get(i).get();
                if (right.isPresent()) {
                    judge.judge(projects.get(i).getFileName().toString(), right.get());
                } else {
                    judge.skip("their Communicator or wallet needs a server on the Internet");
                }
            }
        } catch (ExecutionException e) {
            throw new IOException(e.getCause());
        } finally {
            threads.shutdownNow();
        }
    }

    /** Whether a project runs; nothing if some of its agents cannot run here. */
    private static Optional<Boolean> judge(Path project, String[] arguments) throws IOException, InterruptedException {
        Path into = Files.createTempDirectory("verdict").resolve("course");
        List<String> told = Log.of(into.getParent(), SECONDS,
                List.of(arguments[2], "import", project.toString(), into.toString()));
        if (told.stream().anyMatch(line -> line.contains("is left out") || line.contains(" uses ."))) {
            return Optional.empty();
        }
        copyLibraries(Path.of(arguments[4]), into.resolve("libraries"));
        List<String> log = Log.until(into, 10 * SECONDS, line -> SAID.matcher(line).matches(),
                List.of(arguments[3], "--console", "plain", "-q", "run"));
        boolean right = log.stream().anyMatch(line -> SAID.matcher(line).matches())
                && log.stream().noneMatch(line -> ERROR.matcher(line).find());
        if (!right) {
            System.out.println(project + ":\n" + String.join("\n", log));
        }
        return Optional.of(right);
    }

    private static void copyLibraries(Path from, Path into) throws IOException {
        if (!Files.isDirectory(from)) {
            return;
        }
        try (Stream<Path> files = Files.walk(from)) {
            for (Path file : (Iterable<Path>) files::iterator) {
                Files.createDirectories(into);
                Files.copy(file, into.resolve(from.relativize(file)), StandardCopyOption.REPLACE_EXISTING);
            }
        }
    }
}
