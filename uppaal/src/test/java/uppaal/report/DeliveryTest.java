package uppaal.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import uppaal.ModelException;
import uppaal.check.Exploration;
import uppaal.check.QueryFile;
import uppaal.document.Document;
import uppaal.document.DocumentReader;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;

class DeliveryTest {
    private static final Path MODELS = Path.of("models");

    @TempDir
    private Path folder;

    /** Each scene is explored once: some have millions of states. */
    @Test
    void deliver_ourModels_areAsReadmeSays() throws IOException {
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        assertEquals(List.of(),
                Main.deliver(MODELS, folder, new Report(new PrintStream(printed, true, StandardCharsets.UTF_8))));
        List<String> states = printed.toString(StandardCharsets.UTF_8).lines().filter(line -> line.endsWith(" states"))
                .map(line -> line.strip().replace(" states", "")).toList();
        assertEquals(Scene.OF_DELIVERY.size(), states.size());
        for (int i = 0; i < states.size(); i++) {
            assertInReadme(Scene.OF_DELIVERY.get(i), states.get(i));
        }
    }

    private static void assertInReadme(Scene scene, String states) throws IOException {
        assertTrue(
                Files.readString(Path.of("README.md")).lines().anyMatch(line -> line
                        .startsWith("| `" + scene.name() + "`:") && line.contains("| " + states + " |")),
                () -> "README.md needs the scene " + scene.name() + " with " + states + " states");
    }

    @Test
    void renew_ourModel_isAsExpected() throws IOException {
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        PrintStream out = new PrintStream(printed, true, StandardCharsets.UTF_8);
        assertEquals(List.of(), Main.renew(MODELS, folder, new Report(out)));
        for (Flaw flaw : Flaw.OF_RENEWAL) {
            assertTrue(printed.toString(StandardCharsets.UTF_8).contains(flaw.fault().sentence()), flaw.fault().name());
        }
    }

    @Test
    void readme_renewal_isAsFound() throws IOException {
        for (Scene scene : List.of(Scene.RENEWAL, Scene.ROLLOVER)) {
            assertInReadme(scene,
                    "" + Exploration.of(NetworkBuilder.build(scene.document(MODELS)), List.of()).states());
        }
        String readme = Files.readString(Path.of("README.md"));
        for (Flaw flaw : Flaw.OF_RENEWAL) {
            String row = "| " + flaw.fault().name() + ": " + flaw.fault().sentence() + " | " + flaw.query() + " |";
            assertTrue(readme.contains(row), () -> "README.md needs the row " + row);
        }
    }

    @Test
    void delivery_asUppaalOpensIt_isTheUnicastScene() throws IOException {
        assertEquals(Files.readString(MODELS.resolve("unicast.system")),
                DocumentReader.read(MODELS.resolve("delivery.xml")).system());
    }

    @Test
    void bound_oneSlotLess_isExceeded() {
        Scene scene =
                Scene.OF_DELIVERY.stream().filter(candidate -> candidate.name().equals("bound")).findFirst()
                        .orElseThrow();
        Network network = NetworkBuilder.build(scene.with("DEADLINE", "1423").document(MODELS));
        assertFalse(Exploration.of(network, Check.properties(network, scene.queries(MODELS))).holds(0));
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
    void with_unknownConstant_isSaid() {
        assertEquals("delivery.xml: there is no constant NONE", assertThrows(ModelException.class,
                () -> Scene.OF_DELIVERY.get(0).with("NONE", "1").document(MODELS)).getMessage());
    }
}
