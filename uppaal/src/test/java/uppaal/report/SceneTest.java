package uppaal.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import uppaal.ModelException;
import uppaal.check.Exploration;
import uppaal.check.Query;
import uppaal.check.QueryFile;
import uppaal.document.Document;
import uppaal.document.DocumentReader;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;

class SceneTest {
    private static final Path MODELS = Path.of("models");

    @TempDir
    private Path folder;

    /** Each scene is explored once: some have millions of states. */
    @Test
    @Tag("soak")
    void check_ourModels_areAsReadmeSays() throws IOException {
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        assertEquals(List.of(),
                Main.check(MODELS, folder, new CheckReport(new PrintStream(printed, true, StandardCharsets.UTF_8))));
        List<String> states = printed.toString(StandardCharsets.UTF_8).lines().filter(line -> line.endsWith(" states"))
                .map(line -> line.strip().replace(" states", "")).toList();
        assertEquals(Scene.OURS.size(), states.size());
        for (int i = 0; i < states.size(); i++) {
            assertInReadme(Scene.OURS.get(i), states.get(i));
        }
    }

    /** Otherwise a mutant would be tried in another scene. */
    @Test
    @Tag("soak")
    void inSmall_everyScene_hasTheSameVerdicts() {
        for (Scene scene : Stream.concat(Stream.of(Scene.HIDDEN), Scene.OF_DELIVERY.stream()).toList()) {
            Scene small = scene.inSmall();
            List<Query> queries = small.queries(MODELS);
            Network network = NetworkBuilder.build(small.document(MODELS));
            Exploration found = Exploration.of(network, Check.properties(network, queries));
            for (int i = 0; i < queries.size(); i++) {
                assertEquals(queries.get(i).expected(), found.holds(i), scene.name() + ", " + queries.get(i).name());
            }
        }
    }

    private static void assertInReadme(Scene scene, String states) throws IOException {
        assertTrue(
                Files.readString(Path.of("README.md")).lines().anyMatch(line -> line
                        .startsWith("| `" + scene.name() + "`:") && line.contains("| " + states + " |")),
                () -> "README.md needs the scene " + scene.name() + " with " + states + " states");
    }

    @Test
    void delivery_asUppaalOpensIt_isTheUnicastScene() throws IOException {
        assertEquals(Files.readString(MODELS.resolve("unicast.system")),
                DocumentReader.read(MODELS.resolve("delivery.xml")).system());
    }

    @Test
    void write_everyScene_isWholeAndTheSame() throws IOException {
        for (Scene scene : Scene.OF_DELIVERY) {
            Path written = scene.write(MODELS, folder);
            assertEquals(scene.document(MODELS), DocumentReader.read(written));
            assertEquals(scene.queries(MODELS).size(),
                    QueryFile.read(folder.resolve(scene.name() + ".q")).size());
        }
        Document bound = DocumentReader.read(folder.resolve("bound.xml"));
        assertTrue(bound.declarations().contains("PATIENCE = 19;"), bound.declarations());
        assertEquals(Files.readString(MODELS.resolve("bound.system")), bound.system());
    }

    @Test
    void text_unknownConstant_isSaid() {
        Scene scene = new Scene("s", "", "delivery.xml", Map.of("NONE", "1"), Map.of(), List.of());
        assertEquals("delivery.xml: there is no constant NONE",
                assertThrows(ModelException.class, () -> scene.document(MODELS)).getMessage());
    }
}
