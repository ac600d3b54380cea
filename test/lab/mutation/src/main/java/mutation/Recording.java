package mutation;

import harness.Emulator;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import uppaal.conformance.Replay;

/**
 * The trace of boards that ran a program, and its outcome, in a folder: so it can be judged again and again.
 *
 * @param seed that of the air
 */
record Recording(Path folder, long seed) {

    /** The words of a trace by which a program has left its flash. */
    private static final String CRASH = "\"event\":\"crash\"";

    /** Lets boards run a program, unless they have done so. @return whether one crashed */
    boolean make(Path program) throws IOException, InterruptedException {
        Files.createDirectories(folder);
        Path run = Files.createTempDirectory("javino-mutate");
        try (PrintWriter trace = new PrintWriter(new GZIPOutputStream(Files.newOutputStream(file("jsonl.gz"))), false,
                StandardCharsets.UTF_8)) {
            String why = DeliveryRun.run(program, seed, run, trace::println);
            Files.copy(Emulator.keys(run), keys(), StandardCopyOption.REPLACE_EXISTING);
            Files.writeString(file("hosts"), why);
        } finally {
            FirmwareBuild.delete(run);
        }
        return lines().stream().anyMatch(line -> line.contains(CRASH));
    }

    boolean isMade() {
        return Files.exists(file("hosts"));
    }

    /** The lack of a host that misses a message; empty if all was fine. */
    String hosts() throws IOException {
        return Files.readString(file("hosts"));
    }

    /** Why the replay refuses the trace. */
    Optional<String> refusal() throws IOException {
        try {
            Replay replay = new Replay(keys());
            lines().forEach(replay::line);
            replay.finish();
            return replay.refusal();
        } catch (IllegalArgumentException wrong) {
            return Optional.of(wrong.getMessage());
        }
    }

    List<String> lines() throws IOException {
        try (GZIPInputStream trace = new GZIPInputStream(Files.newInputStream(file("jsonl.gz")))) {
            return new String(trace.readAllBytes(), StandardCharsets.UTF_8).lines().toList();
        }
    }

    Path keys() {
        return file("keys");
    }

    private Path file(String what) {
        return folder.resolve(seed + "." + what);
    }
}
