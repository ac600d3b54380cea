package mutation;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** A copy of the library, and of the sketch that all boards run, built as `gradle firmware` builds them. */
final class FirmwareBuild {

    private static final String PLACE = "PLACE";
    private final Path place;
    private final List<String> command;

    /**
     * Copies the library.
     *
     * @param place   a folder for the copy and what is built of it
     * @param command the command that builds the sketch, with {@code PLACE} for the folder
     */
    FirmwareBuild(Path root, Path place, List<String> command) throws IOException {
        this.place = place;
        this.command = command.stream().map(part -> part.replace(PLACE, place.toString())).toList();
        Path library = place.resolve("libraries/JavinoBDI");
        Path original = root.resolve("javino-firmware");
        copy(original.resolve("src"), library.resolve("src"));
        Files.copy(original.resolve("library.properties"), library.resolve("library.properties"),
                StandardCopyOption.REPLACE_EXISTING);
        copy(original.resolve("examples/09_Station"), place.resolve("09_Station"));
        for (String folder : List.of("build", "core")) {
            Files.createDirectories(place.resolve(folder));
        }
    }

    /** The command that builds the sketch, as Gradle gives it. */
    static List<String> command() {
        return List.of(System.getProperty("javino.build").split("\n"));
    }

    private static void copy(Path from, Path to) throws IOException {
        Files.walkFileTree(from, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes about) throws IOException {
                Path copy = to.resolve(from.relativize(file));
                Files.createDirectories(copy.getParent());
                Files.copy(file, copy, StandardCopyOption.REPLACE_EXISTING);
                // Newer than what an earlier run has built of a mutant.
                touch(copy);
                return FileVisitResult.CONTINUE;
            }
        });
    }

    /** The program with one source changed; empty where it does not build. The source is then as it was. */
    Optional<Path> with(String file, String source) throws IOException, InterruptedException {
        Path changed = place.resolve("libraries/JavinoBDI/src").resolve(file);
        String right = Files.readString(changed);
        try {
            write(changed, source);
            return build();
        } finally {
            write(changed, right);
        }
    }

    /** The program; empty where it does not build. */
    Optional<Path> build() throws IOException, InterruptedException {
        Path built = place.resolve("build/09_Station.ino.elf");
        Files.deleteIfExists(built);
        int status = new ProcessBuilder(command).redirectErrorStream(true)
                .redirectOutput(place.resolve("build.log").toFile()).start().waitFor();
        return status == 0 ? Optional.of(built) : Optional.empty();
    }

    private static void write(Path file, String text) throws IOException {
        Files.writeString(file, text);
        touch(file);
    }

    /** arduino-builder knows times to a second: what is written within the second of a build would be old. */
    private static void touch(Path file) throws IOException {
        Files.setLastModifiedTime(file, FileTime.from(Instant.now().plusSeconds(2)));
    }

    /** Removes a folder with all that is in it, if it is there. */
    static void delete(Path place) throws IOException {
        if (Files.notExists(place)) {
            return;
        }
        try (Stream<Path> files = Files.walk(place)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(file);
            }
        }
    }
}
