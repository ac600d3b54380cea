package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.UncheckedIOException;
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

    /** The compiler shows all warnings, as the IDE can. */
    @Test
    void arduinoLibrary_installed_compilesAllExamplesForTheirBoardsWithoutAWarning() throws Exception {
        Path zip = Release.file("JavinoBDI-", "\\.zip");
        String[] calls = System.getProperty("javino.examples").replace("PLACE", folder.toString()).split("\n\n");
        if (calls[0].startsWith("arduino-cli")) {
            Release.run("env", "ARDUINO_DIRECTORIES_USER=" + folder, "arduino-cli", "--config-file",
                    System.getProperty("javino.arduino") + "/arduino-cli.yaml", "lib", "install", "--zip-path",
                    zip.toString());
        } else {
            System.out.println("skipped: the library's installation by arduino-cli, as there is none; it is unzipped");
            Path libraries = Files.createDirectory(folder.resolve("libraries"));
            Release.run("cmake", "-E", "chdir", libraries.toString(), "cmake", "-E", "tar", "xf", zip.toString());
        }
        Path library = folder.resolve("libraries/JavinoBDI");
        try (Stream<Path> all = Files.list(library.getParent())) {
            assertEquals(List.of(library), all.toList());
        }
        JsonObject json = JsonParser.parseString(Files.readString(library.resolve("library.json"))).getAsJsonObject();
        assertEquals("JavinoBDI", json.get("name").getAsString());
        assertTrue(Files.readAllLines(library.resolve("library.properties"))
                .contains("version=" + json.get("version").getAsString()));
        for (String call : calls) {
            compile(library, List.of(call.split("\n")));
        }
    }

    private void compile(Path library, List<String> call) throws Exception {
        Path into = Files
                .createDirectories(Path.of(call.get(call.indexOf("--build-path") + call.indexOf("-build-path") + 2)));
        Files.createDirectories(folder.resolve("core"));
        // Files made of the last sketch for this board go; the compiled library stays.
        Release.run("rm", "-rf", into + "/sketch", into + "/preproc", into + "/build.options.json");
        Path said = folder.resolve("said");
        int status = new ProcessBuilder(call).redirectErrorStream(true).redirectOutput(said.toFile()).start().waitFor();
        assertEquals(0, status, () -> call + " says:\n" + read(said));
        List<String> warnings = read(said).lines()
                .filter(line -> line.contains("warning:") && line.contains(library.toString())).toList();
        assertEquals(List.of(), warnings, call::toString);
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
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
