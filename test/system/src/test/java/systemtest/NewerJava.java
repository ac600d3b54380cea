package systemtest;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import harness.Platform;
import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Optional;
import java.util.Properties;
import java.util.stream.Stream;

/** The Java that Jason 3.3 asks for, 21 or newer, where this machine has one. */
final class NewerJava {

    private static final int LEAST = 21;

    private NewerJava() {}

    /** A newer Java with Jason 3.3; a test that asks is skipped, and says so, where there is none. */
    static Platform withNewerJason() throws IOException {
        return with(System.getProperty("javino.newerJason"), "Jason 3.3");
    }

    /** A newer Java with other libraries in the place of Jason. */
    static Platform with(String libraries, String what) throws IOException {
        Optional<Path> home = home();
        String skipped = "skipped: " + what + " needs Java " + LEAST + " or newer, beside "
                + System.getProperty("java.home") + " or named by JAVA_HOME_21_X64";
        if (home.isEmpty()) {
            System.out.println(skipped);
        }
        assumeTrue(home.isPresent(), skipped);
        return Platform.USUAL.with(home.get(), libraries);
    }

    /** The home of the newest Java here, if that is new enough. */
    static Optional<Path> home() throws IOException {
        try (Stream<Path> homes = homes()) {
            return homes.filter(home -> version(home) >= LEAST).max(Comparator.comparingInt(NewerJava::version));
        }
    }

    /**
     * Those that lie beside the one that runs this (and so that one), and those that JAVA_HOME, JAVA_HOME_21_X64 or the
     * like name.
     */
    private static Stream<Path> homes() throws IOException {
        return Stream.concat(Files.list(Path.of(System.getProperty("java.home")).getParent()),
                System.getenv().entrySet().stream().filter(variable -> variable.getKey().startsWith("JAVA_HOME"))
                        .map(variable -> Path.of(variable.getValue())));
    }

    /** The version by the file that each Java has in its home; 0 where there is none, or no program to start. */
    private static int version(Path home) {
        if (!Files.isExecutable(home.resolve("bin/java"))) {
            return 0;
        }
        try (Reader release = Files.newBufferedReader(home.resolve("release"))) {
            Properties properties = new Properties();
            properties.load(release);
            String first = properties.getProperty("JAVA_VERSION", "").replaceFirst("^\"(\\d+).*", "$1");
            return first.matches("\\d+") ? Integer.parseInt(first) : 0;
        } catch (IOException unknown) {
            return 0;
        }
    }
}
