package uppaal.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import uppaal.check.Exploration;
import uppaal.document.Document;
import uppaal.document.DocumentReader;
import uppaal.network.Network;
import uppaal.network.NetworkBuilder;

class DeliveryTest {
    private static final Path MODELS = Path.of("models");
    private static final Path FIRMWARE = Path.of("../javino-firmware/src");

    @TempDir
    private Path folder;

    @Test
    void deliver_ourModels_areAsExpected() {
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        PrintStream out = new PrintStream(printed, true, StandardCharsets.UTF_8);
        assertEquals(List.of(), Main.deliver(MODELS, new Firmware(FIRMWARE), new Report(out)));
        for (Flaw flaw : Flaw.ALL) {
            assertTrue(printed.toString(StandardCharsets.UTF_8).contains(flaw.fault().sentence()), flaw.fault().name());
        }
    }

    @Test
    void renew_ourModel_isAsExpectedForAllEngines() throws IOException {
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        PrintStream out = new PrintStream(printed, true, StandardCharsets.UTF_8);
        assertEquals(List.of(), Main.renew(MODELS, folder, new Report(out)));
        for (Flaw flaw : Flaw.OF_RENEWAL) {
            assertTrue(printed.toString(StandardCharsets.UTF_8).contains(flaw.fault().sentence()), flaw.fault().name());
        }
        int states = Exploration.of(NetworkBuilder.build(DocumentReader.read(MODELS.resolve("renewal.xml"))), List.of())
                .states();
        assertTrue(Files.readString(Path.of("README.md")).contains("| `renewal.xml` | " + states + " |"),
                "README.md needs " + states);
    }

    @Test
    void readme_scenesAndFaults_areThoseThatAreFound() throws IOException {
        String readme = Files.readString(Path.of("README.md"));
        for (Scene scene : Scene.ALL) {
            int states = Exploration.of(NetworkBuilder.build(scene.document(MODELS)), List.of()).states();
            assertTrue(
                    readme.lines()
                            .anyMatch(line -> line.startsWith("| `" + scene.name() + "`:")
                                    && line.contains("| " + states + " |")),
                    () -> "README.md needs the scene " + scene.name() + " with " + states + " states");
        }
        for (Flaw flaw : Stream.concat(Flaw.ALL.stream(), Flaw.OF_RENEWAL.stream()).toList()) {
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
    void bound_oneUnitLess_isExceeded() {
        Scene scene =
                Scene.ALL.stream().filter(candidate -> candidate.name().equals("bound")).findFirst().orElseThrow();
        Network network = NetworkBuilder.build(Scene.with(scene.document(MODELS), "BOUND", 192));
        assertFalse(Exploration.of(network, Check.properties(network, scene.queries(MODELS))).holds(0));
    }

    @Test
    void differences_changedFirmware_areSaid() throws IOException {
        for (String file : List.of("delivery/Courier.cpp", "delivery/Backoff.cpp", "radio/AskRadio.cpp", "Config.h")) {
            Files.createDirectories(folder.resolve(file).getParent());
            Files.writeString(folder.resolve(file), Files.readString(FIRMWARE.resolve(file))
                    .replace("MAX_ATTEMPTS = 8", "MAX_ATTEMPTS = 9").replace("LAST_DOUBLING = 3", "LAST_DOUBLING = 2"));
        }
        Document document = Scene.ALL.get(0).document(MODELS);
        assertEquals(List.of("delivery.xml: ATTEMPTS is 8, by the firmware's sources it must be 9",
                "delivery.xml: LAST_SPAN is 16, by the firmware's sources it must be 8"),
                Scene.differences(document, new Firmware(folder)));
        assertEquals(List.of(), Scene.differences(document, new Firmware(FIRMWARE)));
    }
}
