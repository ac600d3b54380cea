package fuzz;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/** Takes the inputs that campaigns have found into the kept corpora, as few as reach all that is reached. */
public final class Keep {

    private static final LocalDateTime NO_TIME = LocalDateTime.of(1980, 1, 1, 0, 0);

    private Keep() {
    }

    /** @param args the folder test/fuzz, with the corpora unpacked in build/corpus. */
    public static void main(String... args) throws IOException, InterruptedException {
        Path fuzz = Path.of(args[0]);
        Path build = fuzz.resolve("build");
        for (Target target : Stream.concat(Target.ofJava().stream(),
                Target.ofFirmware(fuzz.resolve("native/build")).stream()).toList()) {
            Path found = build.resolve("found").resolve(target.name());
            if (Files.isDirectory(found)) {
                Path merged = build.resolve("merged").resolve(target.name());
                Run run = Run.of(target, merged, List.of(build.resolve("corpus").resolve(target.name()), found),
                        "-merge=1");
                Holds.equal("", run.failure(), "merging the corpora of " + target.name());
                int kept = pack(merged, fuzz.resolve("corpus/" + target.name() + ".zip"));
                System.out.println(target.name() + ": " + kept + " inputs are kept");
            }
        }
    }

    /**
     * Writes the files of a folder to an archive; the same files make the same bytes.
     *
     * @return how many there are.
     */
    static int pack(Path folder, Path archive) throws IOException {
        List<Path> files;
        try (Stream<Path> all = Files.list(folder)) {
            files = all.sorted().toList();
        }
        Holds.always(!files.isEmpty(), "there are inputs in " + folder);
        try (OutputStream out = Files.newOutputStream(archive); ZipOutputStream zip = new ZipOutputStream(out)) {
            for (Path file : files) {
                ZipEntry entry = new ZipEntry(file.getFileName().toString());
                entry.setTimeLocal(NO_TIME);
                zip.putNextEntry(entry);
                Files.copy(file, zip);
            }
        }
        return files.size();
    }
}
