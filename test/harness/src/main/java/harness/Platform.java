package harness;

import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The Java and the program that run a multi-agent system.
 *
 * @param java      the home of a Java.
 * @param classPath that Java's class path.
 * @param launcher  its main class.
 * @param suffix    the ending of the programs that this takes.
 */
public record Platform(Path java, String classPath, String launcher, String suffix) {

    /** The Java, the Jason and the libraries of the program that asks. */
    public static final Platform USUAL = new Platform(Path.of(System.getProperty("java.home")),
            System.getProperty("java.class.path"), "jason.infra.local.RunLocalMAS", ".mas2j");

    /** Another Java, and other libraries in the place of this Jason. */
    public Platform with(Path otherJava, String libraries) {
        String others = Stream.of(classPath.split(File.pathSeparator))
                .filter(library -> !Path.of(library).getFileName().toString().startsWith("jason-interpreter"))
                .collect(Collectors.joining(File.pathSeparator));
        return new Platform(otherJava, libraries + File.pathSeparator + others, launcher, suffix);
    }

    /** Another launcher, for programs of another kind. */
    public Platform launchedBy(String otherLauncher, String otherSuffix) {
        return new Platform(java, classPath, otherLauncher, otherSuffix);
    }

    /** The command that starts that program. */
    List<String> command(String name, Path logging) {
        return smallJava(java, "-cp", classPath, launcher, name + suffix, "--log-conf", logging.toString(), "--no-net");
    }

    /** The beginning of a command that starts a small Java, which is up soon: a campaign has a dozen. */
    public static List<String> smallJava(Path home, String... options) {
        return Stream.concat(Stream.of(home.resolve("bin/java").toString(), "-Djava.awt.headless=true",
                "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "--enable-native-access=ALL-UNNAMED"),
                Stream.of(options)).collect(Collectors.toCollection(ArrayList::new));
    }
}
