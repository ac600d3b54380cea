package fuzz;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** A short, fixed run of each target: its kept corpus, then new inputs from one seed. */
class TargetsTest {

    private static final int RUNS = 3000;
    private static final Path CORPUS = Path.of(System.getProperty("javino.root"), "test/fuzz/build/corpus");

    static List<Target> decoders() {
        return Target.ofJava();
    }

    @Tag("soak")
    @ParameterizedTest
    @MethodSource("decoders")
    void decoder_anyBytes_noFault(Target target, @TempDir Path folder) throws Exception {
        Run run = Run.of(target, folder.resolve("found"), List.of(CORPUS.resolve(target.name())), "-seed=1",
                "-runs=" + RUNS);

        assertEquals("", run.failure());
        assertTrue(run.executed() >= RUNS, run + " has tried too little");
        assertTrue(run.covered() > 0, run + " has not seen the code");
    }

    @Tag("soak")
    @Test
    void faultyDecoder_isFound(@TempDir Path folder) throws Exception {
        Target target = new Target("faulty", Target.jazzer(FaultyTarget.class));

        Run run = Run.of(target, folder.resolve("found"), List.of(CORPUS.resolve("ContentTarget")), "-seed=1",
                "-runs=" + RUNS);

        assertTrue(run.failure().contains("ArithmeticException"), run.failure());
    }

    @Test
    void pack_sameFilesMadeInAnotherOrder_makeTheSameBytes(@TempDir Path folder) throws IOException {
        List<Path> archives = new ArrayList<>();
        for (List<String> names : List.of(List.of("b", "a", "c"), List.of("c", "a", "b"))) {
            Path inputs = Files.createDirectory(folder.resolve(String.join("", names)));
            for (String name : names) {
                FileTime time = FileTime.from(Instant.EPOCH.plus(Duration.ofDays(7000 + archives.size())));
                Files.setLastModifiedTime(Files.writeString(inputs.resolve(name), "input " + name), time);
            }
            archives.add(folder.resolve(inputs.getFileName() + ".zip"));
            assertEquals(3, Keep.pack(inputs, archives.get(archives.size() - 1)));
        }
        assertEquals(-1, Files.mismatch(archives.get(0), archives.get(1)));
        try (ZipFile zip = new ZipFile(archives.get(0).toFile())) {
            assertEquals("input b", new String(zip.getInputStream(zip.getEntry("b")).readAllBytes()));
        }
    }
}
