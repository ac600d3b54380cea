package uppaal.report;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import uppaal.Sketch;
import uppaal.TinyNetworks;
import uppaal.check.Exploration;
import uppaal.check.Property;
import uppaal.network.Network;
import uppaal.tool.Tool;

/** The second opinion must be the first one's, where no time passes also in the number of states. */
@Tag("soak")
class ZoneCheckerTest {
    private static final Path MODELS = Path.of("models");

    @TempDir
    private Path folder;

    @BeforeAll
    static void pythonIsInstalled() {
        assumeTrue(Tool.onPath("python3"), "python3 is not on the path");
    }

    private String opinion(String... files) throws IOException {
        return Tool.run(folder,
                Stream.concat(Stream.of("python3", Path.of("zone_checker.py").toAbsolutePath().toString()),
                        Stream.of(files)).toArray(String[]::new));
    }

    @Test
    void opinion_untimedModels_isOurs() throws IOException {
        // Only the moves with few states: the zone checker is slow.
        for (Scene scene : Stream.concat(Stream.of(Scene.PAPER, Scene.QUIET, Scene.RENEWAL), Scene.OF_MOVES.stream()
                .filter(scene -> List.of("cloning", "contact", "silence").contains(scene.name()))).toList()) {
            Check check = Check.of(scene, MODELS, folder);
            String opinion = opinion(scene.name() + ".xml");
            assertTrue(opinion.contains(": " + check.own().states() + " states of"), opinion);
            check.queries().forEach(query -> assertTrue(
                    opinion.contains("  " + query.name() + " " + Check.word(query.expected()) + "\n"), opinion));
        }
    }

    @Test
    void opinion_everyTinyNetwork_isOurs() throws IOException {
        for (TinyNetworks.Tiny tiny : TinyNetworks.all()) {
            opinion(written(tiny.sketch(), tiny.property(), tiny.holds()));
            String other = written(tiny.sketch(), tiny.property(), !tiny.holds());
            assertThrows(IOException.class, () -> opinion(other), tiny.rule());
        }
    }

    /**
     * Which of two things is possible hangs on whether two clocks are together; between, where no integers are,
     * neither.
     */
    @Test
    void opinion_deadlockBetweenIntegers_isSeenByItAlone() throws IOException {
        Sketch sketch = Sketch.of("clock x, y;").template("P", "a{x<=2} -> b{x<=1}; set x = 0",
                "b -> c; guard x == 1 && y == 1", "b -> c; guard x == 1 && y == 2", "b -> c; guard x == 1 && y == 3",
                "c -> c");
        Network network = sketch.network();
        Property property = Property.parse("A[] not deadlock", network, "here");
        assertTrue(Exploration.of(network, List.of(property)).holds(0));
        opinion(written(sketch, "A[] not deadlock", false));
    }

    @Test
    void opinion_runs_areThoseOfOurs() throws IOException {
        Sketch sketch = Sketch.of("clock x;").template("P", "a -> b{x<=1}; set x = 0", "b -> c~", "c~ -> b; set x = 0",
                "c~ -> d");
        opinion(written(sketch, "P.b --> P.c", true));
        opinion(written(sketch, "P.c --> P.d", false));
        opinion(written(sketch, "A<> P.b", false));
    }

    private String written(Sketch sketch, String query, boolean holds) throws IOException {
        Files.writeString(folder.resolve("tiny.q"),
                "/* T1 " + Check.word(holds) + ": so. */\n" + query + "\n");
        Files.writeString(folder.resolve("tiny.xml"), sketch.xml());
        return "tiny.xml";
    }
}
