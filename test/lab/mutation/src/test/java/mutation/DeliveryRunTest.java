package mutation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Tag("soak")
class DeliveryRunTest {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));

    @TempDir
    private Path folder;

    private String run(FirmwareMutant mutant, List<String> trace) throws Exception {
        return DeliveryRun.run(program(mutant), 1, folder.resolve("run"), trace::add);
    }

    private Path program(FirmwareMutant mutant) throws Exception {
        FirmwareBuild build = new FirmwareBuild(ROOT, folder.resolve("build"), FirmwareBuild.command());
        return build.with(mutant.file(), mutant.in(mutant.source(ROOT))).orElseThrow();
    }

    private static FirmwareMutant mutant(String file, String right, String what) throws Exception {
        return FirmwareMutant.all(ROOT).stream().filter(mutant -> mutant.file().equals(file)
                && mutant.right().contains(right) && mutant.what().equals(what)).findFirst().orElseThrow();
    }

    @Test
    void run_withoutMistake_goesAllWays() throws Exception {
        FirmwareMutant none = new FirmwareMutant("delivery/Retransmitter.cpp", 1, "", "",
                FirmwareMutant.all(ROOT).stream()
                        .filter(mutant -> mutant.file().equals("delivery/Retransmitter.cpp")).findFirst().orElseThrow()
                        .source(ROOT)
                        .split("\n")[0]);
        List<String> trace = new ArrayList<>();
        assertEquals("", run(none, trace));
        Set<String> ways = new TreeSet<>();
        for (String line : trace) {
            Pattern.compile("\"(kind|answers|trailer|outcome|why)\":\"([a-z ]+)\"").matcher(line).results()
                    .forEach(way -> ways.add(way.group(2)));
        }
        for (String way : List.of("unicast", "multicast", "broadcast", "fragment", "acknowledgement", "stale", "mark",
                "parity", "delivered", "undelivered", "sent", "power", "fault")) {
            assertEquals(true, ways.contains(way), () -> way + " is not in " + ways);
        }
    }

    @Test
    void run_mutantThatTheModelKnows_isRefused() throws Exception {
        FirmwareMutant wrongOrder = mutant("radio/RadioEncoder.cpp", "packet[length + 1] =", "1 + 1");
        Recording run = new Recording(folder.resolve("recorded"), 1);
        run.make(program(wrongOrder));
        assertTrue(run.refusal().isPresent());
    }
}
