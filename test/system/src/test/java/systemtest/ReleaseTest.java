package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.cyclonedx.Version;
import org.cyclonedx.model.Bom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The files that are published; that a project runs with nothing else is in {@link NewProjectTest}. */
@Tag("verify")
class ReleaseTest {

    @TempDir
    private Path folder;

    @Test
    void checksums_areThoseOfAllFiles() throws Exception {
        Release.run("sh", "-c", "cd '" + Release.FOLDER + "' && sha256sum --quiet -c SHA256SUMS");
        List<String> listed = Files.readAllLines(Release.FOLDER.resolve("SHA256SUMS")).stream()
                .map(line -> line.split(" +")[1]).toList();
        try (Stream<Path> files = Files.list(Release.FOLDER)) {
            assertEquals(files.map(file -> file.getFileName().toString()).filter(name -> !name.equals("SHA256SUMS"))
                    .sorted().toList(), listed.stream().sorted().toList());
        }
    }

    @Test
    void libraries_haveSourcesJavadocAndPom() throws Exception {
        for (String library : List.of("javino-protocol-", "javino-board-", "diffuser-arch-", "mobility-")) {
            for (String end : List.of("\\.jar", "-sources\\.jar", "-javadoc\\.jar", "\\.pom")) {
                assertTrue(Files.size(Release.file(library, end)) > 0);
            }
        }
    }

    @Test
    void arduinoLibrary_unzipped_compilesAnExample() throws Exception {
        Path libraries = Files.createDirectory(folder.resolve("libraries"));
        Release.run("cmake", "-E", "chdir", libraries.toString(), "cmake", "-E", "tar", "xf",
                Release.file("Javino-", "\\.zip").toString());
        try (Stream<Path> top = Files.list(libraries)) {
            assertEquals(List.of("Javino"), top.map(file -> file.getFileName().toString()).toList());
        }
        Path library = libraries.resolve("Javino");
        JsonObject json = JsonParser.parseString(Files.readString(library.resolve("library.json"))).getAsJsonObject();
        assertEquals("Javino", json.get("name").getAsString());
        assertTrue(Files.readAllLines(library.resolve("library.properties"))
                .contains("version=" + json.get("version").getAsString()));
        Files.createDirectory(folder.resolve("build"));
        Release.run("arduino-builder", "-compile", "-quiet", "-hardware", "/usr/share/arduino/hardware",
                "-hardware", "/usr/share/arduino-builder", "-tools", "/usr/share/arduino-builder", "-tools", "/usr/bin",
                "-fqbn", "arduino:avr:uno", "-libraries", libraries.toString(),
                "-build-path", folder.resolve("build").toString(), "-prefs", "runtime.tools.avr-gcc.path=/usr",
                "-prefs", "runtime.tools.ctags.path=/usr/bin",
                "-prefs", "compiler.cpp.extra_flags=-DDECIMAL_DIG=__DECIMAL_DIG__",
                library.resolve("examples/TwoBoards/TwoBoards.ino").toString());
        assertTrue(Files.size(folder.resolve("build/TwoBoards.ino.hex")) > 0);
    }

    @Test
    void billOfMaterials_isOfCycloneDxAndHasEachJarOfTheCommand() throws Exception {
        Path file = Release.file("javino-", "\\.cdx\\.json");
        org.cyclonedx.parsers.JsonParser parser = new org.cyclonedx.parsers.JsonParser();
        assertEquals(List.of(), parser.validate(file.toFile(), Version.VERSION_15));
        Bom bill = parser.parse(file.toFile());
        TreeSet<String> jars = bill.getComponents().stream()
                .map(component -> component.getName() + "-" + component.getVersion() + ".jar")
                .collect(Collectors.toCollection(TreeSet::new));
        try (Stream<Path> lib = Files.list(Release.unpack(folder).resolve("lib"))) {
            // Our own are no components of it.
            lib.map(jar -> jar.getFileName().toString()).filter(name -> !name.matches("(javino|key-agreement)-.*"))
                    .forEach(name -> assertTrue(jars.contains(name), () -> name + " is not in " + jars));
        }
        assertTrue(bill.getComponents().stream().anyMatch(component -> component.getName().equals("libsimavr-dev")));
    }

    @Test
    void changes_areTheSectionOfThisVersion() throws Exception {
        String changes = Files.readString(Release.file("CHANGES-", "\\.md"));
        assertTrue(changes.startsWith("## "), changes);
        assertEquals(1, changes.lines().filter(line -> line.startsWith("## ")).count());
    }
}
