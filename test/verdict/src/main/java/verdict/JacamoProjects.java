package verdict;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Runs JaCaMo's own projects with its agents as they are, and with our architecture added to each: what is said without
 * it is to be said with it. Their threads race, so that only lines that all runs without it share are asked for.
 */
public final class JacamoProjects {

    private static final int SECONDS = 25;
    private static final int QUIET_SECONDS = 4;
    private static final int AT_ONCE = 3;
    private static final int RUNS = 3;
    private static final String SKIPPED = "skipped: ";
    private static final Pattern ELSEWHERE = Pattern.compile("(?m)^\\s*(node\\s|host:|platform:\\s*.*(jade|JCMRest))");
    private static final Pattern DISPLAY = Pattern.compile("HeadlessException");
    /** Frames of stacks, what Java warns of, and where JaCaMo's own servers are. */
    private static final Pattern OTHER = Pattern.compile("^\\tat |^WARNING: |running (on|at) ");
    private static final Pattern ERROR = Pattern.compile("(?i)exception|error|no fail event|FAILED");

    private final Path root;
    private final Path java;
    private final String jacamo;
    private final String ours;

    private JacamoProjects(Path root, Path java, String jacamo, String ours) {
        this.root = root;
        this.java = java;
        this.jacamo = jacamo;
        this.ours = ours;
    }

    /** @param arguments JaCaMo's sources and their version, a Java's home, class paths of JaCaMo and of ours. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        Path root = Path.of(arguments[0]).toRealPath();
        JacamoProjects suite = new JacamoProjects(root, Path.of(arguments[2], "bin"), arguments[3], arguments[4]);
        List<Path> projects = files(root, ".jcm");
        ExecutorService threads = Executors.newFixedThreadPool(AT_ONCE);
        try (Judge judge = new Judge("JaCaMo's own projects", arguments[1], "`Diffuser`")) {
            List<Future<String>> ends = new ArrayList<>();
            for (Path project : projects) {
                ends.add(threads.submit(() -> suite.judge(project)));
            }
            for (int i = 0; i < ends.size(); i++) {
                String end = ends.get(i).get();
                System.out.println(projects.get(i) + ": " + (end.isEmpty() ? "right" : end));
                if (end.startsWith(SKIPPED)) {
                    judge.skip(end.substring(SKIPPED.length()));
                } else {
                    judge.judge(root.relativize(projects.get(i)).toString(), end.isEmpty());
                }
            }
        } catch (ExecutionException e) {
            throw new IOException(e.getCause());
        } finally {
            threads.shutdownNow();
        }
    }

    /** What was wrong with one project, or nothing; or why it was not run. */
    private String judge(Path project) throws IOException, InterruptedException {
        if (ELSEWHERE.matcher(uncommented(project)).find()) {
            return SKIPPED + "they need other hosts or a server";
        }
        Path of = folder(project);
        Path built = build(of, Files.createTempDirectory("verdict").resolve("jacamo"));
        Path file = of.relativize(project);
        List<Set<String>> plain = new ArrayList<>();
        List<Set<String>> ours = new ArrayList<>();
        for (int i = 0; i < RUNS; i++) {
            List<String> without = run(built, file, "jacamo.infra.JaCaMoLauncher");
            if (without.stream().anyMatch(line -> DISPLAY.matcher(line).find())) {
                return SKIPPED + "they need a display (Debian's xvfb)";
            }
            List<String> with = run(built, file, "verdict.RunWithArchitecture", "diffuser.Diffuser");
            if (with.equals(without) && !with.isEmpty()) {
                return "";
            }
            plain.add(Set.copyOf(without));
            plain.add(Set.copyOf(run(built, file, "jacamo.infra.JaCaMoLauncher")));
            ours.add(Set.copyOf(with));
            if (common(plain).isEmpty()) {
                return SKIPPED + "runs without ours have no line in common";
            }
            if (wrong(plain, ours).isEmpty()) {
                return "";
            }
        }
        return String.join("\n", wrong(plain, ours));
    }

    /** What each run without ours says and none with it, and errors of each run with it and none without. */
    private static Set<String> wrong(List<Set<String>> plain, List<Set<String>> ours) {
        Set<String> missing = common(plain);
        ours.forEach(missing::removeAll);
        Set<String> errors = common(ours);
        plain.forEach(errors::removeAll);
        missing.addAll(errors.stream().filter(line -> ERROR.matcher(line).find()).collect(Collectors.toSet()));
        return missing;
    }

    private static Set<String> common(List<Set<String>> runs) {
        Set<String> common = new TreeSet<>(runs.get(0));
        runs.forEach(common::retainAll);
        return common;
    }

    private static String uncommented(Path project) throws IOException {
        return Files.readString(project).replaceAll("(?s)/\\*.*?\\*/", "").replaceAll("//.*", "");
    }

    /** The project's folder: it has the sources. */
    private Path folder(Path project) {
        Path folder = project.getParent();
        while (!Files.isDirectory(folder.resolve("src")) && !folder.equals(root)) {
            folder = folder.getParent();
        }
        return folder;
    }

    /** A copy of a project, with its classes. */
    private Path build(Path of, Path built) throws IOException, InterruptedException {
        copy(of, built, JacamoProjects::isPart);
        List<String> sources = files(built, ".java").stream().map(Path::toString)
                .filter(file -> !of.equals(root) || file.contains("/src/test/java/project/")).toList();
        if (!sources.isEmpty()) {
            List<String> compile = new ArrayList<>(List.of(java.resolve("javac").toString(), "-nowarn", "-proc:none",
                    "-encoding", "UTF-8", "-d", "classes", "-cp", classes(built)));
            compile.addAll(sources);
            Log.of(built, 10 * SECONDS, compile);
        }
        return built;
    }

    private String classes(Path folder) throws IOException {
        return Stream.concat(files(folder, ".jar").stream().map(Path::toString),
                Stream.of(jacamo, ours, folder.resolve("classes").toString())).collect(Collectors.joining(":"));
    }

    /** What a project says in a fresh copy, sorted, numbers left out. */
    private List<String> run(Path built, Path project, String... program) throws IOException, InterruptedException {
        Path copy = Files.createTempDirectory(built.getParent(), "run");
        copy(built, copy, file -> true);
        Path log = copy.resolve("verdict.properties");
        Files.writeString(log, "handlers = java.util.logging.ConsoleHandler\n.level = INFO\n"
                + "java.util.logging.ConsoleHandler.formatter = jason.runtime.MASConsoleLogFormatter\n");
        List<String> words = new ArrayList<>(display());
        words.addAll(List.of(java.resolve("java").toString(), "-cp", classes(copy)));
        words.addAll(Arrays.asList(program));
        words.addAll(List.of(project.toString(), "--log-conf", log.toString()));
        return Log.untilQuiet(copy, SECONDS, QUIET_SECONDS, words).stream()
                .filter(line -> !line.isBlank() && !OTHER.matcher(line).find())
                .map(line -> line.replace(copy.toString(), "").replaceAll("[-.0-9]*[0-9](E-?\\d+)?", "#")).sorted()
                .toList();
    }

    /** Neither JaCaMo's other projects nor what a build has left. */
    private static boolean isPart(Path file) {
        return file.getNameCount() == 1 || Set.of("src", "lib").contains(file.getName(0).toString());
    }

    private static void copy(Path from, Path into, Predicate<Path> part) throws IOException {
        for (Path file : files(from, "").stream().filter(Files::isRegularFile).map(from::relativize).filter(part)
                .toList()) {
            Path to = into.resolve(file);
            Files.createDirectories(to.getParent());
            Files.copy(from.resolve(file), to);
        }
    }

    private static List<String> display() {
        Path xvfb = Path.of("/usr/bin/xvfb-run");
        return Files.isExecutable(xvfb) ? List.of(xvfb.toString(), "-a") : List.of();
    }

    private static List<Path> files(Path folder, String end) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(file -> file.toString().endsWith(end)).sorted().toList();
        }
    }
}
