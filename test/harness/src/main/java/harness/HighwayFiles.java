package harness;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The files of the highway that somebody wrote. */
public final class HighwayFiles {

    private static final String ROOT = System.getProperty("javino.root");
    public static final Path FOLDER = Path.of(ROOT, "examples/highway");

    private HighwayFiles() {
    }

    /**
     * Copies them, so that nobody's run is disturbed; scenarios name the real sketches. What builds make in the
     * folder may come and go meanwhile.
     */
    public static void copy(Path to) throws IOException {
        for (String part : List.of("", "agents", "inspector")) {
            Path copies = Files.createDirectories(to.resolve(part));
            try (Stream<Path> files = Files.list(FOLDER.resolve(part))) {
                for (Path file : files.filter(Files::isRegularFile).toList()) {
                    Files.writeString(copies.resolve(file.getFileName()),
                            Files.readString(file).replace("../..", ROOT));
                }
            }
        }
    }
}
